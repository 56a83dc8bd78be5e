// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/info/inspect.h"
#include "core/error.h"
#include "core/files/json_text.h"
#include "fields/readers/file_field.h"

namespace pellucid::app {
namespace {

FileContents contents_of(const fields::VectorField& field) {
  FileContents contents;
  contents.kind = "field";
  if (const Box3 box = field.domain(); !box.empty()) contents.bounds = box;
  contents.more["description"] = field.description();
  contents.more["steady"] = field.steady();
  if (const auto size = field.cell_size()) contents.more["smallest cell"] = *size;
  return contents;
}

/// The times of a series that has been read, so that it is what it should be; what a file holds is
/// told of the first one.
void add_frames(const std::filesystem::path& path, const Progress& progress,
                FileContents& contents) {
  const nlohmann::json files = read_json(path)["files"];
  for (const nlohmann::json& file : files) contents.times.push_back(file["time"]);
  contents.kind = "series of files";
  contents.counts = {{"files", files.size()}};
  const FileContents first =
      inspect(path.parent_path() / files.front()["name"].get<std::string>(), progress);
  contents.arrays = first.arrays;
  contents.more["first file"] = files.front()["name"];
}

}  // namespace

FileContents inspect_field(const std::filesystem::path& path, const Progress& progress) {
  const fields::FileFormatRow& row = *fields::file_format(path.string());
  FileContents contents = contents_of(*fields::read_file(path, row, {}));
  contents.title = row.title;
  if (row.ending == ".series") add_frames(path, progress, contents);
  return contents;
}

}  // namespace pellucid::app
