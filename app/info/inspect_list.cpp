// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/inspect.h"
#include "core/files/bad_file.h"
#include "core/files/output_file.h"
#include "fields/readers/file_field.h"
#include "fields/readers/file_lists.h"

namespace pellucid::app {

FileContents inspect_list(const std::filesystem::path& path, const Progress& progress) {
  const fields::Collection files = fields::listed_files(path);
  std::size_t count = 0;
  for (const auto& [time, parts] : files)
    for (const fields::CollectedFile& part : parts) {
      require_file(part.file);
      if (fields::is_file_list(part.file)) bad_file(path, "it lists a list of files");
      ++count;
    }
  const std::vector<fields::CollectedFile>& first = files.begin()->second;
  FileContents contents = inspect(first.front().file, progress);
  contents.more["of the first file"] = contents.kind;
  contents.kind = "files over time";
  contents.title = fields::file_format(path.string())->title;
  contents.counts = {{"files", count}};
  if (first.size() > 1) contents.counts.emplace_back("parts", first.size());
  contents.more["first file"] = first.front().file.filename().string();
  contents.times.clear();
  for (const auto& [time, parts] : files) contents.times.push_back(time);
  return contents;
}

}  // namespace pellucid::app
