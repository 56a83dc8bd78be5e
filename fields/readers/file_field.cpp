// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/file_field.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "core/options/lower_case.h"
#include "core/options/split.h"

namespace pellucid::fields {
namespace {

struct PathAndOptions {
  std::string_view path;
  std::string_view options;  // with the colon
  const FileFormatRow* format = nullptr;
};

/// The options begin at the first colon behind a known ending, so that a path may hold colons.
PathAndOptions path_and_options(std::string_view text) {
  PathAndOptions best{text, {}};
  if (text.starts_with("formula:")) return best;  // 2.e is a number there
  const std::string lower = lower_case(text);
  for (const FileFormatRow& row : field_formats())
    for (std::size_t at = lower.find(row.ending); at != std::string_view::npos;
         at = lower.find(row.ending, at + 1)) {
      const std::size_t end = at + row.ending.size();
      const bool ends_here = end == text.size() || text[end] == ':';
      if (ends_here && (!best.format || end < best.path.size()))
        best = {text.substr(0, end), text.substr(end), &row};
    }
  return best;
}

/// Values may have commas: what follows one without "=" belongs to the value before it.
RawOptions raw_options(const PathAndOptions& parts) {
  RawOptions options;
  std::string* value = nullptr;
  if (parts.options.size() < 2) return options;
  for (const std::string_view part : split(parts.options.substr(1), ',')) {
    const std::size_t equals = part.find('=');
    if (value && equals == std::string_view::npos) {
      *value += fmt::format(",{}", part);
      continue;
    }
    if (equals == std::string_view::npos || equals == 0)
      throw InputError(
          fmt::format("{}: option '{}' is not of the form key=value", parts.path, part));
    const auto [place, is_new] = options.emplace(part.substr(0, equals), part.substr(equals + 1));
    if (!is_new)
      throw InputError(fmt::format("{}: option '{}' is given twice", parts.path, place->first));
    value = &place->second;
  }
  return options;
}

FileOptions parse_options(const PathAndOptions& parts) {
  return file_options().read(Parameters(parts.path, file_options().specs(), raw_options(parts)));
}

}  // namespace

FileOptions in_common(FileOptions options) {
  if (!options.common_array) options.common_array = std::make_shared<std::string>();
  if (!options.told_periods) options.told_periods = std::make_shared<ToldPeriods>();
  return options;
}

Periods periods_of(const FileOptions& options, const std::string& file) {
  Periods periods = parse_periods(options.periodic, file);
  periods.told = options.told_periods;
  return periods;
}

const std::string& wanted_array(const FileOptions& options) {
  return options.array.empty() && options.common_array ? *options.common_array : options.array;
}

void keep_array(const FileOptions& options, const std::string& name) {
  if (options.common_array && options.common_array->empty()) *options.common_array = name;
}

const OptionTable<FileOptions>& file_options() {
  static const OptionTable<FileOptions> table{
      text("array", &FileOptions::array,
           "vectors, NAME or three scalars U,V,W; by default the active or the only ones"),
      choice("sampler", &FileOptions::interpolation,
             {{"linear", Interpolation::linear}, {"c1", Interpolation::c1}},
             "c1: cubic, continuous with its derivative"),
      choice("cells", &FileOptions::cells,
             {{"averaged", CellValues::averaged}, {"constant", CellValues::constant}},
             "vectors of cells: averaged to points, or constant in each cell"),
      text("periodic", &FileOptions::periodic,
           "axes along which the grid repeats itself: x,y or x:LENGTH; none: not even a longitude"),
      text("block", &FileOptions::block, "blocks by name, A or A,B; by default all are merged"),
      text("time", &FileOptions::time, "first, last or a number: the field at that time alone"),
      choice("staggered", &FileOptions::average_faces, {{"refused", false}, {"averaged", true}},
             "a staggered .vdb grid: the means of both faces, in the middle of each voxel")};
  return table;
}

std::string file_endings() {
  std::string endings;
  for (const FileFormatRow& row : field_formats())
    endings += (endings.empty() ? "" : ", ") + std::string(row.ending);
  return endings;
}

const FileFormatRow* file_format(std::string_view path) {
  const std::string lower = lower_case(path);
  for (const FileFormatRow& row : field_formats())
    if (lower.ends_with(row.ending)) return &row;
  return nullptr;
}

void refuse_grid_options(const FileOptions& options, const std::filesystem::path& path) {
  if (options.cells == CellValues::constant)
    throw InputError(fmt::format(
        "{}: cells=constant: its samples are at points; accepted: cells=averaged", path.string()));
  if (parse_periods(options.periodic, path.string()).any())
    throw InputError(fmt::format(
        "{}: periodic={}: accepted of image, rectilinear and MetaImage data; here: periodic=none",
        path.string(), options.periodic));
}

std::unique_ptr<VectorField> read_file(const std::filesystem::path& path,
                                       const FileFormatRow& format, const FileOptions& options) {
  require_file(path);
  note_read(path);
  try {
    return format.read(path, options);
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("{}: claims more data than this machine's memory holds", path.string()));
  } catch (const std::length_error&) {
    throw InputError(fmt::format("{}: claims more data than can be", path.string()));
  }
}

bool names_file(std::string_view text) { return path_and_options(text).format; }

std::unique_ptr<VectorField> read_file_field(std::string_view text,
                                             const std::filesystem::path& base) {
  const PathAndOptions parts = path_and_options(text);
  if (!parts.format) return nullptr;
  return read_file(base / parts.path, *parts.format, parse_options(parts));
}

std::unique_ptr<VectorField> read_file_scalar(std::string_view text,
                                              const std::filesystem::path& base,
                                              const std::string& name) {
  const PathAndOptions parts = path_and_options(text);
  if (!parts.format)
    throw InputError(fmt::format(
        "{}: it has no scalar '{}' beside its velocity; accepted: a field of a file that has", text,
        name));
  FileOptions options = parse_options(parts);
  // The grid's period is what its velocity tells: a scalar may be alike at both ends by chance.
  if (parse_periods(options.periodic, std::string(parts.path)).are_told_by_samples()) {
    options.told_periods = std::make_shared<ToldPeriods>();
    read_file(base / parts.path, *parts.format, options);
  }
  options.array = name;
  options.quantity = Quantity::scalar;
  return read_file(base / parts.path, *parts.format, options);
}

}  // namespace pellucid::fields
