// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/vtk_file.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetReader.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "fields/files/vtk_messages.h"

namespace pellucid::fields {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view why) {
  throw InputError(
      fmt::format("{}: not a valid {} file: {}", path.string(), path.extension().string(), why));
}

void refuse_messages(const VtkMessages& messages, const std::filesystem::path& path) {
  if (const std::string line = messages.first_line(); !line.empty()) fail(path, line);
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
  if (path.extension() != ".vtk") require_closing_tag(path);
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

std::string vector_names(vtkPointData* arrays) {
  std::string names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    const vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetNumberOfComponents() == 3 && arrays->GetArrayName(i))
      names += (names.empty() ? "" : ", ") + std::string(arrays->GetArrayName(i));
  }
  return names.empty() ? "none" : names;
}

vtkDataArray* only_vectors(vtkPointData* arrays) {
  vtkDataArray* only = nullptr;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = arrays->GetArray(i);
    if (!array || array->GetNumberOfComponents() != 3) continue;
    if (only) return nullptr;
    only = array;
  }
  return only;
}

}  // namespace

vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".vti") return read<vtkXMLImageDataReader>(path);
  if (ending == ".vtr") return read<vtkXMLRectilinearGridReader>(path);
  if (ending == ".vts") return read<vtkXMLStructuredGridReader>(path);
  if (ending == ".vtu") return read<vtkXMLUnstructuredGridReader>(path);
  return read<vtkDataSetReader>(path);
}

vtkDataArray* pick_vectors(vtkDataSet* data, const std::string& name,
                           const std::filesystem::path& path) {
  vtkPointData* arrays = data->GetPointData();
  vtkDataArray* vectors = name.empty() ? arrays->GetVectors() : arrays->GetArray(name.c_str());
  if (name.empty() && !vectors) vectors = only_vectors(arrays);
  const std::string names = vector_names(arrays);
  if (!vectors && name.empty())
    throw InputError(
        fmt::format("{}: which vectors? array=NAME; point arrays of three components: "
                    "{}",
                    path.string(), names));
  if (!vectors || vectors->GetNumberOfComponents() != 3)
    throw InputError(
        fmt::format("{}: array={}: no such vectors; point arrays of three components: "
                    "{}",
                    path.string(), name, names));
  if (vectors->GetNumberOfTuples() != data->GetNumberOfPoints())
    throw InputError(fmt::format("{}: array '{}' has {} vectors, but there are {} points",
                                 path.string(), vectors->GetName() ? vectors->GetName() : "",
                                 vectors->GetNumberOfTuples(), data->GetNumberOfPoints()));
  return vectors;
}

}  // namespace pellucid::fields
