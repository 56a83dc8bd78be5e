// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkDataSet.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/files/ending.h"
#include "fields/files/meta_image_data.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/vdb_levels.h"
#include "fields/levels/vtk_levels.h"
#include "fields/readers/file_lists.h"
#include "readers/vdb/vdb_file.h"
#include "readers/vtk/times.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_formats.h"

namespace pellucid::fields {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view vdb_ending = ".vdb";
constexpr std::string_view meta_image_endings[] = {".mhd", ".mha"};
constexpr std::string_view list_endings[] = {".pvd", ".series"};

bool ends_as(const fs::path& path, std::span<const std::string_view> endings) {
  return std::ranges::find(endings, small_ending(path)) != endings.end();
}

std::string accepted_endings() {
  std::vector<std::string_view> endings{vdb_ending};
  for (const readers::VtkFormat& format : readers::vtk_formats())
    if (!format.without_arrays) endings.push_back(format.ending);
  endings.insert(endings.end(), std::begin(meta_image_endings), std::end(meta_image_endings));
  endings.insert(endings.end(), std::begin(list_endings), std::end(list_endings));
  return fmt::format("{}", fmt::join(endings, ", "));
}

std::string remark_on_time(const fs::path& path, double time, std::size_t of) {
  return fmt::format("{} is drawn at {}, the first of its {} times", path.filename().string(), time,
                     of);
}

/// What files are asked for.
struct Wanted {
  std::string_view scalar;
  const std::string& velocity;
  const std::string& time;
};

FileLevels read_vdb(const fs::path& path, const Wanted& wanted) {
  if (!wanted.time.empty()) readers::chosen_time({}, wanted.time, path);  // throws: it has none
  const auto grids = readers::read_vdb_grids(path);
  FileLevels file;
  file.levels = levels_of(grids, path, wanted.scalar, wanted.velocity);
  file.range = value_range(grids, wanted.scalar, file.levels);
  file.gaps = value_gaps(grids, wanted.scalar);
  return file;
}

FileLevels read_vtk(const fs::path& path, const Wanted& wanted) {
  const bool of_velocity = is_derived(wanted.scalar) && !wanted.velocity.empty();
  const readers::VtkTime read =
      readers::read_vtk_file(path, {}, wanted.time.empty() ? "first" : wanted.time,
                             of_velocity ? wanted.velocity : ArrayChoice(wanted.scalar).name)
          .front();
  FileLevels file;
  if (std::string remark = remark_on_choice(*read.data, path, wanted.scalar); !remark.empty())
    file.remarks.push_back(std::move(remark));
  if (wanted.time.empty() && read.of.size() > 1)
    file.remarks.push_back(remark_on_time(path, read.time, read.of.size()));
  file.levels = level_of(*read.data, path, wanted.scalar, wanted.velocity);
  file.range = sample_range(file.levels);
  return file;
}

FileLevels read_image(const fs::path& path, const Wanted& wanted) {
  if (!wanted.time.empty()) readers::chosen_time({}, wanted.time, path);  // throws: it has none
  FileLevels file;
  file.levels = level_of(*data_set_of(read_meta_image(path)), path, wanted.scalar, wanted.velocity);
  file.range = sample_range(file.levels);
  return file;
}

FileLevels read_one(const fs::path& path, const Wanted& wanted) {
  if (readers::vtk_format(path)) return read_vtk(path, wanted);
  if (small_ending(path) == vdb_ending) return read_vdb(path, wanted);
  if (ends_as(path, meta_image_endings)) return read_image(path, wanted);
  bad_file(path, fmt::format("ending '{}'; accepted of an isosurface: {}. ParaView: save as .vti",
                             path.extension().string(), accepted_endings()));
}

/// The parts of one time are levels of their own.
FileLevels read_list(const fs::path& path, const Wanted& wanted) {
  const Collection files = listed_files(path);
  std::vector<double> times;
  for (const auto& [time, parts] : files) times.push_back(time);
  const double time =
      times[readers::chosen_time(times, wanted.time.empty() ? "first" : wanted.time, path)];
  FileLevels list;
  list.range = sample_range({});
  if (wanted.time.empty() && times.size() > 1)
    list.remarks.push_back(remark_on_time(path, time, times.size()));
  for (const CollectedFile& part : files.at(time)) {
    try {
      append(read_one(part.file, {wanted.scalar, wanted.velocity, {}}), list);
    } catch (const InputError& error) {
      bad_file(path, error.what());
    }
  }
  return list;
}

}  // namespace

void append(FileLevels more, FileLevels& files) {
  append(std::move(more.levels), files.levels);
  files.range = {std::min(files.range.x, more.range.x), std::max(files.range.y, more.range.y)};
  files.gaps.add(more.gaps);
  std::ranges::move(more.remarks, std::back_inserter(files.remarks));
}

FileLevels read_levels(const fs::path& path, std::string_view scalar, const std::string& velocity,
                       const std::string& time) {
  const Wanted wanted{scalar, velocity, time};
  return is_file_list(path) ? read_list(path, wanted) : read_one(path, wanted);
}

}  // namespace pellucid::fields
