// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid {

/// A MemoryFile is a file in memory, open for reading and writing, without a name; it is gone when
/// its last descriptor and mapping are.
class MemoryFile {
 public:
  /// Throws WorkError when the system has none to give.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return file_; }

 private:
  int file_;
};

}  // namespace pellucid
