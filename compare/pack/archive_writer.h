// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/files/output_file.h"

struct archive;

namespace pellucid::compare {

/// An ArchiveKind is a format of archives.
enum class ArchiveKind { zip, tar_gz };

/// An ArchiveWriter writes an archive by libarchive, one file after another, compressed. No time is
/// in it, so that the same files are the same bytes. It appears with commit(), whole. Functions
/// throw WorkError where writing fails.
class ArchiveWriter {
 public:
  /// Throws as OutputFile does.
  ArchiveWriter(const std::filesystem::path& to, ArchiveKind kind);

  /// Begins a file of `size` bytes; `path`, with '/', is its place in the archive.
  void begin(const std::string& path, std::uint64_t size, bool executable = false);
  /// Writes bytes of the file that was begun last.
  void write(std::span<const char> bytes);
  void commit();

 private:
  struct Free {
    void operator()(archive* writer) const;
  };

  void check(int result) const;

  std::filesystem::path to_;
  OutputFile file_;
  std::unique_ptr<archive, Free> writer_;
};

}  // namespace pellucid::compare
