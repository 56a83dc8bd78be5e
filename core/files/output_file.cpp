// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/files/files_read.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

bool is_disk_trouble(int code) { return code == ENOSPC || code == EDQUOT || code == EIO; }

[[noreturn]] void fail(const fs::path& path, int code) {
  const std::string message =
      fmt::format("{}: cannot write: {}", path.string(), std::generic_category().message(code));
  if (is_disk_trouble(code)) throw WorkError(message);
  throw InputError(message);
}

/// A file descriptor that closes itself.
struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

void write_all(const Descriptor& file, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.fd, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  temporary_ = path_.parent_path() / fmt::format(".{}.{}{}", path_.stem().string(), ::getpid(),
                                                 path_.extension().string());
  if (fs::is_directory(path_)) fail(path_, EISDIR);
  const Descriptor file{::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (file.fd < 0) fail(path_, errno);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  {
    const Descriptor file{::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0 || ::fsync(file.fd) != 0) fail(path_, errno);
  }
  std::error_code code;
  fs::rename(temporary_, path_, code);
  if (code) fail(path_, code.value());
  temporary_.clear();
}

void write_text(const fs::path& path, std::string_view text) {
  OutputFile out(path);
  {
    const Descriptor file{::open(out.temporary().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC)};
    if (file.fd < 0) fail(path, errno);
    write_all(file, text, path);
  }
  out.commit();
}

std::string read_text(const fs::path& path) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.fd < 0)
    throw InputError(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
  std::string text;
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.fd, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw InputError(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
    if (got == 0) break;
    text.append(block, static_cast<std::size_t>(got));
  }
  note_read(path);
  return text;
}

}  // namespace pellucid
