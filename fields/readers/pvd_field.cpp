// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView's collection of VTK files, each at a time and a part of what there is then:
//   <Collection> <DataSet timestep="0" part="0" file="a.vtu"/> … </Collection>
// Parts of one time are merged.

#include <fmt/format.h>

#include <map>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/options/parameters.h"
#include "fields/readers/file_field.h"
#include "fields/readers/pvd_collection.h"
#include "fields/readers/series_field.h"
#include "fields/readers/vtk_field.h"
#include "readers/vtk/blocks_of.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/xml_tags.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

std::string attribute(const readers::XmlTag& tag, std::string_view name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? "" : found->second;
}

double time_of(const readers::XmlTag& tag, const Path& path) {
  const std::string text = attribute(tag, "timestep");
  double time = 0;
  if (!text.empty() && (!parse_number(text, time) || !std::isfinite(time)))
    bad_file(path, fmt::format("timestep=\"{}\"; accepted: a number", text));
  return time;
}

CollectedFile entry_of(const readers::XmlTag& tag, const Path& path) {
  const std::string file = attribute(tag, "file");
  if (file.empty()) bad_file(path, "a DataSet names no file");
  std::string name = attribute(tag, "name");
  if (name.empty()) name = attribute(tag, "group");
  if (name.empty()) name = attribute(tag, "part");
  return {name, path.parent_path() / file};
}

}  // namespace

Collection pvd_collection(const Path& path) {
  Collection collection;
  for (const readers::XmlTag& tag : readers::xml_tags(path))
    if (tag.name == "DataSet") collection[time_of(tag, path)].push_back(entry_of(tag, path));
  if (collection.empty())
    bad_file(path,
             "not a valid .pvd file: accepted: a <Collection> of <DataSet timestep=… file=…/>");
  return collection;
}

namespace {

std::unique_ptr<VectorField> read_frame(const std::vector<CollectedFile>& entries,
                                        const FileOptions& options, const Path& path) {
  std::vector<readers::NamedBlock> blocks;
  for (const CollectedFile& entry : entries) {
    try {
      blocks.push_back({entry.name, readers::read_vtk_data_set(entry.file)});
    } catch (const InputError& error) {
      bad_file(path, error.what());
    }
  }
  blocks = readers::chosen_blocks(std::move(blocks), options.block, path.string());
  const Path& named = entries.size() == 1 ? entries.front().file : path;
  const std::string note = blocks.size() > 1 ? fmt::format(", {} parts merged", blocks.size()) : "";
  return field_of(readers::merged(blocks), options, named, note);
}

std::unique_ptr<VectorField> read_pvd_field(const Path& path, const FileOptions& asked) {
  const FileOptions options = in_common(asked);
  const Collection collection = pvd_collection(path);
  std::vector<double> times;
  for (const auto& [time, entries] : collection) times.push_back(time);
  return field_over_times(times, options.time, path, [&](std::size_t number) {
    return read_frame(collection.at(times[number]), options, path);
  });
}

}  // namespace

std::vector<FileFormatRow> pvd_formats() {
  return {{".pvd", "ParaView's collection of VTK files over time", read_pvd_field}};
}

}  // namespace pellucid::fields
