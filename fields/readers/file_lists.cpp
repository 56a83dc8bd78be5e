// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/file_lists.h"

#include <string>

#include "core/files/ending.h"
#include "fields/readers/series_field.h"

namespace pellucid::fields {

bool is_file_list(const std::filesystem::path& path) {
  const std::string ending = small_ending(path);
  return ending == ".pvd" || ending == ".series";
}

Collection listed_files(const std::filesystem::path& path) {
  if (small_ending(path) == ".pvd") return pvd_collection(path);
  Collection files;
  for (const SeriesEntry& entry : series_entries(path))
    files[entry.time].push_back({{}, entry.file});
  return files;
}

}  // namespace pellucid::fields
