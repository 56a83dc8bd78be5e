// SPDX-License-Identifier: GPL-3.0-or-later
// Linked to pellucid-read-simulation alone: these readers load a hundred libraries.
#include <vtkCGNSReader.h>
#include <vtkExodusIIReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkHDFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockPLOT3DReader.h>
#include <vtkObjectFactory.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPointSet.h>
#include <vtkSTLReader.h>
#include <vtkTecplotReader.h>
#include <vtkVersionMacros.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "readers/simulations/make_mrc.h"
#include "readers/simulations/make_netcdf.h"
#include "readers/simulations/make_nifti.h"
#include "readers/simulations/make_nrrd.h"
#include "readers/simulations/simulation_checks.h"
#include "readers/simulations/tecplot_coordinates.h"
#include "readers/vtk/parse_file.h"

namespace pellucid::readers {
namespace {

using Path = std::filesystem::path;

template <class Reader>
vtkSmartPointer<Reader> reader_of(const Path& path) {
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make(const Path& path) {
  return reader_of<Reader>(path);
}

/// Cell data as they are in the case, and, where VTK does it yet, polyhedra cut into cells that can
/// be searched.
vtkSmartPointer<vtkAlgorithm> make_foam(const Path& path) {
  refuse_divided_foam(path);
  const auto reader = reader_of<vtkOpenFOAMReader>(path);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)  // which complains of being asked
  reader->DecomposePolyhedraOn();
#endif
  reader->CreateCellToPointOff();
  reader->SkipZeroTimeOff();
  return reader;
}

/// Says whether the vectors by which VTK moves the nodes are displacements: it takes the first
/// whose name begins with "dis".
bool has_displacements(vtkExodusIIReader& reader) {
  for (int i = 0; i < reader.GetNumberOfObjectArrays(vtkExodusIIReader::NODAL); ++i) {
    const std::string name = lower_case(reader.GetObjectArrayName(vtkExodusIIReader::NODAL, i));
    if (name.starts_with("dis")) return name.starts_with("disp");
  }
  return false;
}

/// All results of the nodes and elements, each node where its displacement has it.
vtkSmartPointer<vtkAlgorithm> make_exodus(const Path& path) {
  refuse_unread_exodus(path);
  const auto reader = reader_of<vtkExodusIIReader>(path);
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  reader->SetApplyDisplacements(has_displacements(*reader));
  return reader;
}

vtkSmartPointer<vtkAlgorithm> make_cgns(const Path& path) {
  refuse_curved_cgns(path);
  const auto reader = reader_of<vtkCGNSReader>(path);
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return reader;
}

vtkSmartPointer<vtkAlgorithm> make_ensight(const Path& path) {
  refuse_ensight6_blocks(path);
  const auto reader = vtkSmartPointer<vtkGenericEnSightReader>::New();
  reader->SetCaseFileName(path.c_str());
  reader->ReadAllVariablesOn();
  return reader;
}

/// A text begins with the number of grids, alone in its line, or with the sizes of the only one;
/// nothing of a binary file, of which VTK finds such things out.
std::optional<int> numbers_in_first_line(const Path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line(256, '\0');
  file.read(line.data(), std::streamsize(line.size()));
  line.resize(std::size_t(file.gcount()));
  if (line.find_first_not_of("0123456789 \t\r\n+-.eEdD") != std::string::npos) return std::nullopt;
  std::istringstream words(line.substr(0, line.find('\n')));
  int count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

vtkSmartPointer<vtkAlgorithm> make_plot3d(const Path& path) {
  const auto reader = vtkSmartPointer<vtkMultiBlockPLOT3DReader>::New();
  constexpr int velocity = 200;  // of VTK's numbers of functions
  reader->SetXYZFileName(path.c_str());
  if (const Path solution = Path(path).replace_extension(".q"); std::filesystem::exists(solution))
    reader->SetQFileName(solution.c_str());
  const auto numbers = numbers_in_first_line(path);
  reader->SetAutoDetectFormat(!numbers);
  reader->SetBinaryFile(!numbers);
  reader->SetMultiGrid(numbers == 1);
  reader->AddFunction(velocity);
  reader->SetVectorFunctionNumber(velocity);  // the active ones, which VTK would have be momentum
  return reader;
}

/// VTK takes what is there of a file that was cut off. Binary ones are as long as their number of
/// facets, 50 bytes each behind a head of 84, asks for; texts have their end.
vtkSmartPointer<vtkAlgorithm> make_stl(const Path& path) {
  constexpr std::uint64_t head = 84, facet = 50, tail = 4096;
  const std::uint64_t size = std::filesystem::file_size(path);
  std::ifstream file(path, std::ios::binary);
  std::string begin(std::min(size, head), '\0');
  file.read(begin.data(), std::streamsize(begin.size()));
  std::uint32_t facets = 0;
  if (begin.size() == head) std::memcpy(&facets, begin.data() + 80, sizeof facets);
  const bool is_text =
      lower_case(begin).starts_with("solid") && begin.find('\0') == std::string::npos;
  if (!is_text && (size < head || size != head + facet * facets))
    throw InputError(
        fmt::format("{}: {} bytes, but its {} facets take {}; truncated, or no STL file",
                    path.string(), size, facets, head + facet * facets));
  file.seekg(std::streamoff(size - std::min(size, tail)));
  if (is_text &&
      lower_case(std::string(std::istreambuf_iterator<char>(file), {})).find("endsolid") ==
          std::string::npos)
    throw InputError(path.string() + ": no 'endsolid' at its end; truncated?");
  return make<vtkSTLReader>(path);
}

/// VTK takes as many of the last variables as there are without the coordinates, wherever these
/// are.
class TecplotReader : public vtkTecplotReader {
 public:
  static TecplotReader* New() { VTK_STANDARD_NEW_BODY(TecplotReader); }
  void TakeAllVariables() {
    UpdateInformation();
    for (const std::string& name : Variables) SetDataArrayStatus(name.c_str(), 1);
  }

 protected:
  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    if (!vtkTecplotReader::RequestData(request, input, output)) return 0;
    auto* zones = vtkMultiBlockDataSet::GetData(output);
    for (unsigned i = 0; i < zones->GetNumberOfBlocks(); ++i)
      if (auto* zone = vtkPointSet::SafeDownCast(zones->GetBlock(i)))
        place_points(*zone, Variables);
    return 1;
  }
};

vtkSmartPointer<vtkAlgorithm> make_tecplot(const Path& path) {
  refuse_fortran_numbers(path);
  refuse_several_solution_times(path);
  const auto reader = reader_of<TecplotReader>(path);
  reader->TakeAllVariables();
  return reader;
}

/// Of zones: what Tecplot 360 writes of their place in an animation, which reads nothing otherwise.
constexpr std::string_view tecplot_words[] = {
    "'STRANDID' is currently unsupported", "'SOLUTIONTIME' is currently unsupported",
    "'PARENTZONE' is currently unsupported", "'FILETYPE' is currently unsupported"};

constexpr VtkReader readers[] = {{".vtkhdf", make<vtkHDFReader>},
                                 {".foam", make_foam},
                                 {".case", make_ensight},
                                 {".encas", make_ensight},
                                 {".ex2", make_exodus},
                                 {".exo", make_exodus},
                                 {".e", make_exodus},
                                 {".cgns", make_cgns},
                                 {".xyz", make_plot3d},
                                 {".p3d", make_plot3d},
                                 {".tec", make_tecplot, nullptr, tecplot_words},
                                 {".nc", make_netcdf, pick_netcdf_variables},
                                 {".cdf", make_netcdf, pick_netcdf_variables},
                                 {".nii", make_nifti},
                                 {".nii.gz", make_nifti},
                                 {".nrrd", make_nrrd},
                                 {".nhdr", make_nrrd},
                                 {".stl", make_stl},
                                 {".mrc", make_mrc},
                                 {".rec", make_mrc}};

}  // namespace

std::span<const VtkReader> simulation_readers() { return readers; }

}  // namespace pellucid::readers
