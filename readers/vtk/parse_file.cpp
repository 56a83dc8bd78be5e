// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/parse_file.h"

#include <fmt/format.h>
#include <vtkDataSet.h>
#include <vtkDataSetReader.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "readers/vtk/vtk_messages.h"

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
  for (std::string word; file >> word;) {
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::tolower(c); });
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
  const double bytes = double(std::filesystem::file_size(path));
  if (points > largest_compression * bytes)
    fail(path, fmt::format("it claims {:.3g} points in {:.0f} bytes", points, bytes));
}

void prepare(vtkAlgorithm*) {}

/// A legacy reader hides all but the first vectors and scalars unless asked.
void prepare(vtkDataSetReader* reader) {
  reader->ReadAllVectorsOn();
  reader->ReadAllScalarsOn();
  reader->ReadAllFieldsOn();
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

template <class Reader>
vtkSmartPointer<vtkDataSet> read(const std::filesystem::path& path) {
  if constexpr (!std::is_same_v<Reader, vtkDataSetReader>) require_closing_tag(path);
  const VtkMessages messages;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  prepare(reader.Get());
  reader->UpdateInformation();
  refuse_messages(messages, path);
  refuse_absurd_extent(reader, path);
  reader->Update();
  refuse_messages(messages, path);
  vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!data || data->GetNumberOfPoints() == 0) fail(path, "it holds no points");
  return data;
}

}  // namespace

vtkSmartPointer<vtkDataSet> parse_vtk_file(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".vti") return read<vtkXMLImageDataReader>(path);
  if (ending == ".vtr") return read<vtkXMLRectilinearGridReader>(path);
  if (ending == ".vts") return read<vtkXMLStructuredGridReader>(path);
  if (ending == ".vtu") return read<vtkXMLUnstructuredGridReader>(path);
  if (ending == ".vtp") return read<vtkXMLPolyDataReader>(path);
  return read<vtkDataSetReader>(path);
}

}  // namespace pellucid::readers
