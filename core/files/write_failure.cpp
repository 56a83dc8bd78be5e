// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/write_failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "core/error.h"

namespace pellucid {

void fail_writing(const std::filesystem::path& path, int code) {
  const std::string message =
      fmt::format("{}: cannot write: {}", path.string(), std::generic_category().message(code));
  if (code == ENOSPC || code == EDQUOT || code == EIO) throw WorkError(message);
  throw InputError(message);
}

}  // namespace pellucid
