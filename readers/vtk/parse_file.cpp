// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/parse_file.h"

#include <fmt/format.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "readers/vtk/blocks_of.h"
#include "readers/vtk/times.h"
#include "readers/vtk/vtk_formats.h"
#include "readers/vtk/vtk_messages.h"
#include "readers/vtk/xml_checks.h"

namespace pellucid::readers {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view why) {
  throw InputError(
      fmt::format("{}: not a valid {} file: {}", path.string(), path.extension().string(), why));
}

/// Says whether a legacy file is text and has "nan" among its numbers, which VTK does not read.
bool has_nan_as_text(const std::filesystem::path& path) {
  if (path.extension() != ".vtk") return false;
  std::ifstream file(path);
  bool is_text = false;
  for (std::string text; file >> text;) {
    const std::string word = lower_case(text);
    is_text = is_text || word == "ascii";
    if (word == "binary") return false;
    if (is_text && (word == "nan" || word == "-nan" || word == "+nan")) return true;
  }
  return false;
}

void refuse_messages(const VtkMessages& messages, const std::filesystem::path& path) {
  const std::string line = messages.first_line();
  if (line.empty()) return;
  if (has_nan_as_text(path))
    fail(path,
         "VTK reads no 'nan' in legacy files of text; accepted: binary data, or .vti, .vtu, …");
  fail(path, line);
}

/// What a file claims must be what it can hold: a compressor makes data at most some thousand times
/// smaller. Stops an allocation before a mutated extent asks for it.
void refuse_absurd_extent(vtkAlgorithm* reader, const std::filesystem::path& path) {
  int extent[6];
  vtkInformation* information = reader->GetOutputInformation(0);
  if (!information || !information->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())) return;
  information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  double points = 1;
  for (int axis = 0; axis < 3; ++axis)
    points *= double(extent[2 * axis + 1]) - double(extent[2 * axis]) + 1;
  constexpr double largest_compression = 8192;
  double bytes = double(std::filesystem::file_size(path));
  for (const auto& file : files_beside(path, *vtk_format(path)))
    bytes += double(std::filesystem::file_size(file));
  if (points > largest_compression * bytes)
    fail(path, fmt::format("it claims {:.3g} points in {:.0f} bytes", points, bytes));
}

/// VTK stops reading an XML file where appended data begin, and does not miss their end.
void require_closing_tag(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const auto size = std::streamoff(std::filesystem::file_size(path));
  file.seekg(std::max<std::streamoff>(0, size - 4096));
  const std::string tail{std::istreambuf_iterator<char>(file), {}};
  if (tail.find("</VTKFile>") == std::string::npos)
    fail(path, "it does not end with </VTKFile>: truncated?");
}

std::vector<double> times_of(vtkAlgorithm& reader) {
  vtkInformation* about = reader.GetOutputInformation(0);
  const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!about || !about->Has(key)) return {};
  const double* times = about->Get(key);
  return {times, times + about->Length(key)};
}

/// What the reader has at a time, or without times.
ParsedTime parse_time(vtkAlgorithm& reader, std::optional<double> time, const VtkRequest& request,
                      const VtkMessages& messages, const std::filesystem::path& path) {
  if (time)
    reader.UpdateTimeStep(*time);
  else
    reader.Update();
  refuse_messages(messages, path);
  const auto blocks =
      chosen_blocks(blocks_within(reader.GetOutputDataObject(0)), request.block, path.string());
  if (blocks.empty()) fail(path, "it holds no points");
  ParsedTime parsed;
  for (const NamedBlock& block : blocks)
    if (!block.name.empty()) parsed.blocks.push_back(block.name);
  parsed.data = merged(blocks);
  refuse_messages(messages, path);
  return parsed;
}

const VtkReader& row_of(const std::filesystem::path& path, std::span<const VtkReader> readers) {
  const VtkFormat* format = vtk_format(path);
  for (const VtkReader& reader : readers)
    if (format && reader.ending == format->ending) return reader;
  fail(path, "there is no reader of it here");
}

}  // namespace

FileTimes parse_vtk_file(const std::filesystem::path& path, std::span<const VtkReader> readers,
                         const VtkRequest& request,
                         const std::function<void(const ParsedTime&)>& take) {
  if (const VtkFormat* format = vtk_format(path); format && is_xml(*format)) {
    require_closing_tag(path);
    check_xml(path);
  }
  const VtkReader& row = row_of(path, readers);
  const VtkMessages messages(row.harmless);
  const auto reader = row.make(path);
  std::vector<std::string> left_out;
  if (row.pick_arrays) left_out = row.pick_arrays(*reader, request.arrays);
  reader->UpdateInformation();
  refuse_messages(messages, path);
  refuse_absurd_extent(reader, path);
  const auto parse = [&](std::optional<double> time, bool is_last) {
    ParsedTime parsed = parse_time(*reader, time, request, messages, path);
    parsed.left_out = left_out;
    parsed.is_last = is_last;
    take(parsed);
  };
  std::vector<double> times = times_of(*reader);
  if (times.empty()) {
    if (request.time != "first" && !request.time.empty()) chosen_time(times, request.time, path);
    parse(std::nullopt, true);
    return {};
  }
  const std::vector<double> all = times;
  if (!request.time.empty()) times = {times[chosen_time(times, request.time, path)]};
  for (const double time : times) try {
      parse(time, time == times.back());
    } catch (const InputError& error) {
      if (all.size() == 1) throw;
      throw InputError(fmt::format("{} (at time {} of {}; time=last reads the last alone)",
                                   error.what(), time, all.size()));
    }
  return {times, all};
}

}  // namespace pellucid::readers
