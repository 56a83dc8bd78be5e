// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pellucid {

/// The file of an OutputFolder that lists the others, a path in each line.
inline constexpr const char* folder_list = ".pellucid-folder";

/// An OutputFolder appears whole or not at all: its files are written into a folder beside its
/// place, which commit() renames. Without commit() nothing remains; what a killed process has left
/// beside the place is removed by the next OutputFolder of that name. It holds a list of its files
/// (folder_list), so that a folder which is there is replaced in one step only if it is empty, or
/// holds such a list and no file that is not on it: nobody's own files go away. Throws InputError
/// when the folder around it is missing or not writable, and for a place that holds anything else
/// or what a ProtectedInputs has seen read; WorkError when the disk fails.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Returns where the files have to be written.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Runs `write` with temporary(). What it throws names the files by the place that was asked for:
  /// temporary() is nobody's business, and is gone when the message is read.
  void fill(const std::function<void(const std::filesystem::path& to)>& write) const;

  /// Renames. Throws as the class says.
  void commit();

 private:
  std::filesystem::path path_;    // as given, for messages
  std::filesystem::path target_;  // absolute, without a last '/'
  std::filesystem::path temporary_;
  int lock_ = -1;  // held on the temporary while this process lives
};

}  // namespace pellucid
