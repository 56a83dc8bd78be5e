// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pack/archive.h"

#include <optional>

#include "compare/pack/archive_writer.h"
#include "core/files/output_file.h"
#include "core/files/output_folder.h"
#include "core/options/lower_case.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// The kind of archive that the path's ending is of; nothing for a folder.
std::optional<ArchiveKind> kind_of(const fs::path& to) {
  const std::string name = lower_case(to.filename().string());
  if (name.ends_with(".zip")) return ArchiveKind::zip;
  if (name.ends_with(".tar.gz") || name.ends_with(".tgz")) return ArchiveKind::tar_gz;
  return std::nullopt;
}

void write_archive(ArchiveKind kind, const fs::path& to, const std::string& name,
                   const std::vector<PackedFile>& files) {
  ArchiveWriter archive(to, kind);
  for (const PackedFile& one : files) {
    const std::string content = one.content();
    archive.begin(name + '/' + one.path, content.size(), one.executable);
    archive.write(content);
  }
  archive.commit();
}

void write_folder(const fs::path& to, const std::vector<PackedFile>& files) {
  OutputFolder folder(to);
  folder.fill([&](const fs::path& temporary) {
    for (const PackedFile& file : files) {
      const fs::path path = temporary / file.path;
      fs::create_directories(path.parent_path());
      write_text(path, file.content());
      if (file.executable) fs::permissions(path, fs::perms(0755));
    }
  });
  folder.commit();
}

}  // namespace

std::string PackedFile::content() const { return source.empty() ? text : read_text(source); }

std::string package_name(const fs::path& to) {
  std::string name = fs::absolute(to / "").parent_path().filename().string();
  for (const std::string_view ending : {".tar.gz", ".tgz", ".zip"})
    if (lower_case(name).ends_with(ending) && name.size() > ending.size())
      return name.substr(0, name.size() - ending.size());
  return name;
}

void write_package(const fs::path& to, const std::string& name,
                   const std::vector<PackedFile>& files) {
  if (const auto kind = kind_of(to)) return write_archive(*kind, to, name, files);
  write_folder(to, files);
}

}  // namespace pellucid::compare
