// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/files/output_folder.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

struct FreeArchive {
  void operator()(archive* a) const { archive_write_free(a); }
};
struct FreeEntry {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};
using Archive = std::unique_ptr<archive, FreeArchive>;

/// The writer of a kind of archive, by libarchive; nothing where the path's ending is of none. No
/// time is in it, so that the same files are the same bytes.
Archive archive_for(const fs::path& to) {
  const std::string name = to.filename().string();
  Archive writer(archive_write_new());
  if (name.ends_with(".zip")) {
    archive_write_set_format_zip(writer.get());
  } else if (name.ends_with(".tar.gz") || name.ends_with(".tgz")) {
    archive_write_set_format_pax_restricted(writer.get());
    archive_write_add_filter_gzip(writer.get());
    archive_write_set_filter_option(writer.get(), "gzip", "timestamp", nullptr);
  } else {
    return nullptr;
  }
  return writer;
}

/// libarchive says what went wrong by its result, and by a text.
void check(int result, const Archive& writer, const fs::path& to) {
  if (result >= ARCHIVE_WARN) return;
  throw WorkError(
      fmt::format("{}: cannot write: {}", to.string(), archive_error_string(writer.get())));
}

void add(const std::string& path, const PackedFile& file, const Archive& writer,
         const fs::path& to) {
  const std::string content = file.content();
  const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), path.c_str());
  archive_entry_set_size(entry.get(), la_int64_t(content.size()));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), file.executable ? 0755 : 0644);
  archive_entry_set_mtime(entry.get(), 0, 0);
  check(archive_write_header(writer.get(), entry.get()), writer, to);
  if (archive_write_data(writer.get(), content.data(), content.size()) < 0)
    check(ARCHIVE_FATAL, writer, to);
}

void write_archive(const Archive& writer, const fs::path& to, const std::string& name,
                   const std::vector<PackedFile>& files) {
  OutputFile file(to);
  check(archive_write_open_filename(writer.get(), file.temporary().c_str()), writer, to);
  for (const PackedFile& one : files) add(name + '/' + one.path, one, writer, to);
  check(archive_write_close(writer.get()), writer, to);
  file.commit();
}

void write_folder(const fs::path& to, const std::vector<PackedFile>& files) {
  OutputFolder folder(to, "ro-crate-metadata.json");
  for (const PackedFile& file : files) {
    const fs::path path = folder.temporary() / file.path;
    fs::create_directories(path.parent_path());
    write_text(path, file.content());
    if (file.executable) fs::permissions(path, fs::perms(0755));
  }
  folder.commit();
}

}  // namespace

std::string PackedFile::content() const { return source.empty() ? text : read_text(source); }

std::string package_name(const fs::path& to) {
  std::string name = fs::absolute(to / "").parent_path().filename().string();
  for (const std::string_view ending : {".tar.gz", ".tgz", ".zip"})
    if (name.ends_with(ending) && name.size() > ending.size())
      return name.substr(0, name.size() - ending.size());
  return name;
}

void write_package(const fs::path& to, const std::string& name,
                   const std::vector<PackedFile>& files) {
  if (const Archive writer = archive_for(to)) return write_archive(writer, to, name, files);
  write_folder(to, files);
}

}  // namespace pellucid::compare
