// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/archives/parse_archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>
#include <string>

#include "core/files/bad_file.h"

namespace pellucid::readers {
namespace {

struct Free {
  void operator()(archive* reader) const { archive_read_free(reader); }
};

class ArchiveReader {
 public:
  explicit ArchiveReader(const std::filesystem::path& path)
      : path_(path), reader_(archive_read_new()) {
    constexpr std::size_t piece = 1 << 16;
    archive_read_support_format_zip_seekable(reader_.get());
    check(archive_read_open_filename(reader_.get(), path.c_str(), piece));
  }

  /// The next file; nullptr when there is none.
  archive_entry* next() {
    archive_entry* entry = nullptr;
    const int result = archive_read_next_header(reader_.get(), &entry);
    if (result == ARCHIVE_EOF) return nullptr;
    check(result);
    return entry;
  }

  /// All of the file that next() has found. What its head claims is not believed.
  std::string bytes() {
    std::string bytes;
    char piece[1 << 16];
    for (;;) {
      const la_ssize_t got = archive_read_data(reader_.get(), piece, sizeof piece);
      if (got < 0) check(int(got));
      if (got <= 0) return bytes;
      bytes.append(piece, std::size_t(got));
    }
  }

 private:
  void check(int result) const {
    if (result >= ARCHIVE_WARN) return;
    const char* why = archive_error_string(reader_.get());
    bad_file(path_, why ? why : "it cannot be unpacked");
  }

  const std::filesystem::path& path_;
  std::unique_ptr<archive, Free> reader_;
};

}  // namespace

void parse_archive(const std::filesystem::path& path, BlockWriter& out) {
  ArchiveReader reader(path);
  while (archive_entry* entry = reader.next()) {
    const char* name = archive_entry_pathname(entry);
    if (archive_entry_filetype(entry) != AE_IFREG || !name || !*name) continue;
    out.add_text(name, reader.bytes());
  }
}

}  // namespace pellucid::readers
