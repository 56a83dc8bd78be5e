// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/child_reader.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "core/options/split.h"
#include "readers/vtk/data_set_blocks.h"
#include "readers/vtk/vtk_formats.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;

/// Names without line breaks, one a line: blocks hold numbers and texts alone.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string_view line : split(text, '\n'))
    if (!line.empty()) lines.emplace_back(line);
  return lines;
}

/// Bytes of the files that are read with this one, which are noted.
std::uint64_t note_files_beside(const fs::path& path, const VtkFormat& format) {
  std::uint64_t bytes = 0;
  for (const fs::path& file : files_beside(path, format)) {
    note_read(file);
    bytes += fs::file_size(file);
  }
  return bytes;
}

/// Without times the one that there is.
std::vector<VtkTime> times_of(const Blocks& blocks) {
  const auto times = blocks.at("times").values<double>();
  const auto of = blocks.at("all times").values<double>();
  std::vector<VtkTime> all;
  for (std::size_t i = 0; i < std::max<std::size_t>(times.size(), 1); ++i) {
    const Blocks part = blocks.within(fmt::format("{}|", i));
    all.push_back({times.empty() ? 0 : times[i],
                   data_set_of(part),
                   lines_of(part.text("blocks")),
                   lines_of(part.text("left out")),
                   {of.begin(), of.end()}});
  }
  return all;
}

}  // namespace

std::vector<VtkTime> read_vtk_file(const fs::path& path, const std::string& block,
                                   const std::string& time, const std::string& arrays) {
  require_file(path);
  const VtkFormat* format = vtk_format(path);
  if (!format) throw InputError(fmt::format("{}: VTK reads no such file", path.string()));
  const Blocks blocks = read_in_child(format->program, path, {block, time, arrays}, 0,
                                      note_files_beside(path, *format));
  try {
    return times_of(blocks);
  } catch (const BlockError& error) {
    throw InputError(
        fmt::format("{}: not a valid {} file: {}", path.string(), format->ending, error.what()));
  }
}

vtkSmartPointer<vtkDataSet> read_vtk_data_set(const fs::path& path) {
  return read_vtk_file(path, {}, "first").front().data;
}

}  // namespace pellucid::readers
