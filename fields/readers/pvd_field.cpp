// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView's collection of VTK files, each at a time and a part of what there is then:
//   <Collection> <DataSet timestep="0" part="0" file="a.vtu"/> … </Collection>
// Parts of one time are merged, and so are blocks within a file.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/options/lower_case.h"
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

/// Parts of a time, and how many blocks there are in them.
struct Parts {
  std::vector<readers::NamedBlock> parts;
  std::size_t blocks = 0;
};

/// The blocks of `wanted` of each file.
Parts read_parts(const std::vector<CollectedFile>& entries, const std::string& wanted,
                 const Path& path) {
  Parts read;
  for (const CollectedFile& entry : entries) {
    try {
      const auto file = readers::read_vtk_file(entry.file, wanted, "first").front();
      read.parts.push_back({entry.name, file.data});
      read.blocks += std::max<std::size_t>(file.blocks.size(), 1);
    } catch (const InputError& error) {
      bad_file(path, error.what());
    }
  }
  return read;
}

bool holds_blocks(const CollectedFile& entry) {
  const std::string ending = lower_case(entry.file.extension().string());
  return ending == ".vtm" || ending == ".vtpc" || ending == ".vtpd";
}

/// A block is one of the collection's parts, or else one within its files.
bool is_of_parts(const std::vector<CollectedFile>& entries, const std::string& wanted) {
  if (std::ranges::none_of(entries, holds_blocks)) return true;
  std::vector<readers::NamedBlock> names;
  for (const CollectedFile& entry : entries) names.push_back({entry.name, {}});
  return readers::has_blocks(names, wanted);
}

std::unique_ptr<VectorField> read_frame(const std::vector<CollectedFile>& entries,
                                        const FileOptions& options, const Path& path) {
  const bool of_parts = is_of_parts(entries, options.block);
  Parts read = read_parts(entries, of_parts ? "" : options.block, path);
  const auto parts =
      readers::chosen_blocks(std::move(read.parts), of_parts ? options.block : "", path.string());
  const Path& named = entries.size() == 1 ? entries.front().file : path;
  const std::string note = parts.size() > 1 ? fmt::format(", {} parts merged", parts.size())
                           : entries.size() == 1 && read.blocks > 1
                               ? fmt::format(", {} blocks merged", read.blocks)
                               : "";
  return field_of(readers::merged(parts), options, named, note);
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
