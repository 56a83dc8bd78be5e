// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/support/bytes.h"

namespace pellucid::fuzz {

/// A FileInMemory is a file for readers that take a path: named as they want it, in a folder of its
/// own, where files may lie beside it. The folder is in /dev/shm, where there is one and TMPDIR
/// names no other place, and lives as long as this does.
class FileInMemory {
 public:
  /// `name` is the file's, such as "input.ply"; `beside` are names and contents of further ones.
  explicit FileInMemory(
      std::string_view name,
      std::initializer_list<std::pair<std::string_view, std::string>> beside = {});
  ~FileInMemory();
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  /// Returns the path, with `bytes` as all that the file holds.
  const std::filesystem::path& with(Bytes bytes) const;
  const std::filesystem::path& path() const { return path_; }
  /// Returns the file's name without its folder.
  std::string name() const { return path_.filename().string(); }

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace pellucid::fuzz
