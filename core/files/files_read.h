// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace pellucid {

/// A FilesRead lists the files that this process reads while it lives, whichever thread reads them:
/// what a result made meanwhile depends on. Readers report through note_read(); the list belongs to
/// the process and not to a call, since a file may name further files that only its reader knows,
/// and a loop's tasks may read.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Returns the paths reported until now, absolute and normalized.
  std::set<std::filesystem::path> paths() const;

 private:
  friend void note_read(const std::filesystem::path& path);
  std::set<std::filesystem::path> paths_;
};

/// A ProtectedInputs keeps the files that this process reads while it lives from being written
/// over: a command's output may not be one of its inputs, by whichever name or link.
class ProtectedInputs {
 public:
  ProtectedInputs();
  ~ProtectedInputs();
  ProtectedInputs(const ProtectedInputs&) = delete;
  ProtectedInputs& operator=(const ProtectedInputs&) = delete;

  /// Throws InputError when a ProtectedInputs that lives has seen the file `output` read.
  static void refuse(const std::filesystem::path& output);

 private:
  FilesRead read_;
};

/// An UnnotedReads keeps what this process reads while it lives off all lists: who makes one
/// accounts for those files in another way.
class UnnotedReads {
 public:
  UnnotedReads();
  ~UnnotedReads();
  UnnotedReads(const UnnotedReads&) = delete;
  UnnotedReads& operator=(const UnnotedReads&) = delete;
};

/// Reports to every FilesRead that lives that `path` is read. read_text() does so by itself.
void note_read(const std::filesystem::path& path);

/// Returns the path without "." and "..", as it is told in lists and messages. What ".." leads to
/// behind a link only the file system knows: such a path is absolute, and the links of its folder
/// are followed.
std::filesystem::path without_dots(const std::filesystem::path& path);

/// A ContentHashes knows the hash of each file's content, and reads no file twice.
class ContentHashes {
 public:
  /// Returns 16 hexadecimal digits of the content's hash (XXH3); empty when it cannot be read.
  std::string of(const std::filesystem::path& path);

 private:
  std::map<std::filesystem::path, std::string> known_;
};

}  // namespace pellucid
