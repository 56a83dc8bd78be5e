// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "core/files/write_failure.h"

namespace pellucid {
namespace {

void wait_for_lock(int file) {
  while (::flock(file, LOCK_EX) != 0 && errno == EINTR) {
  }
}

/// Who had the lock before has removed its file: then the lock is one on nothing.
bool is_at(const std::filesystem::path& path, int file) {
  struct stat held {
  }, there{};
  return ::fstat(file, &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

}  // namespace

FileLock::FileLock(std::filesystem::path path) : path_(std::move(path)) {
  for (;;) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) fail_writing(path_, errno);
    wait_for_lock(file_);
    if (is_at(path_, file_)) return;
    ::close(file_);
  }
}

// Removed while it is held: who waits sees that, and makes a new one.
FileLock::~FileLock() {
  ::unlink(path_.c_str());
  ::close(file_);
}

}  // namespace pellucid
