// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace pellucid {

/// A FileLock is held by one process at a time, of all machines that share the file; the others
/// wait for it. Its file is made for it and goes with it; a process that is killed leaves the file
/// and loses the lock. On a file system without locks nobody waits. Throws InputError when the
/// folder is missing or not writable, WorkError when the disk fails.
class FileLock {
 public:
  explicit FileLock(std::filesystem::path path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace pellucid
