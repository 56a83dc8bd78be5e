// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/write_failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "core/error.h"

namespace pellucid {
namespace {

std::string message_of(const std::filesystem::path& path, int code) {
  return fmt::format("{}: cannot write: {}", path.string(), std::generic_category().message(code));
}

bool is_of_disk(int code) {
  return code == ENOSPC || code == EDQUOT || code == EFBIG || code == EIO;
}

}  // namespace

void fail_writing(const std::filesystem::path& path, int code) {
  if (is_of_disk(code)) throw WorkError(message_of(path, code));
  throw InputError(message_of(path, code));
}

void fail_stream(const std::filesystem::path& path) {
  if (is_of_disk(errno)) fail_writing(path, errno);
  throw WorkError(fmt::format("{}: cannot write: is the disk full?", path.string()));
}

}  // namespace pellucid
