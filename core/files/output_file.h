// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pellucid {

/// An OutputFile appears whole or not at all: it is written beside its place and renamed by
/// commit(). Without commit() nothing remains, and what a killed process has left beside the place
/// is removed by the next OutputFile of that name. A link stays a link to the file that is written;
/// a device or a pipe is written into and stays what it is. Throws InputError when the folder is
/// missing or not writable, or the place holds what a ProtectedInputs has seen read; WorkError when
/// the disk is full or fails.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Returns where a library that writes by path has to write. It keeps the extension of the final
  /// name.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes to the disk and renames. Throws as the class says.
  void commit();

 private:
  std::filesystem::path path_;    // as given, for messages
  std::filesystem::path target_;  // behind the links
  bool is_regular_ = true;        // or will be
  std::filesystem::path temporary_;
  int lock_ = -1;  // held on the temporary while this process lives
};

/// Returns the file that a chain of links leads to, which need not be there.
std::filesystem::path behind_links(const std::filesystem::path& path);

/// Writes the whole text by an OutputFile, and throws as it does.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Throws InputError unless `path` is a file that may be read and is no larger than the memory: a
/// pipe or a device is none, and opening one would wait for who writes into it.
void require_file(const std::filesystem::path& path);

/// Reads a whole file and notes that it was read (note_read()). Throws InputError as require_file()
/// does, and when the file is larger than this machine's memory.
std::string read_text(const std::filesystem::path& path);

/// Returns the text without the byte order mark of UTF-8 that some editors put before it.
std::string_view without_mark(std::string_view text);

}  // namespace pellucid
