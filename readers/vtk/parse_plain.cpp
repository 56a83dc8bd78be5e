// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDataSetReader.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPartitionedDataSetCollectionReader.h>
#include <vtkXMLPartitionedDataSetReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "readers/vtk/parse_file.h"
#include "readers/vtk/xml_tags.h"

namespace pellucid::readers {
namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// A legacy reader hides all but the first vectors and scalars unless asked.
vtkSmartPointer<vtkAlgorithm> make_legacy(const std::filesystem::path& path) {
  const auto reader = vtkSmartPointer<vtkDataSetReader>::New();
  reader->SetFileName(path.c_str());
  reader->ReadAllVectorsOn();
  reader->ReadAllScalarsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

/// Takes the mark of a duplicate off every cell.
void forget_duplicates(vtkDataSet& data) {
  vtkUnsignedCharArray* const marks = data.GetCellGhostArray();
  const vtkIdType count = marks ? marks->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < count; ++i)
    marks->SetValue(
        i, static_cast<unsigned char>(marks->GetValue(i) & ~vtkDataSetAttributes::DUPLICATECELL));
}

/// Pieces of a grid along indices overlap where they have ghost cells. VTK takes each cell from one
/// of them, with that piece's mark: left in, it would hide the only one that there is.
template <class Reader>
class GridPieces : public Reader {
 public:
  static GridPieces* New() { VTK_STANDARD_NEW_BODY(GridPieces); }

 protected:
  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    if (!Reader::RequestData(request, input, output)) return 0;
    if (vtkDataSet* const data = vtkDataSet::GetData(output)) forget_duplicates(*data);
    return 1;
  }
};

using Direction = std::vector<double>;

/// The nine numbers of the first image in the file, whose form check_xml() has seen; none where it
/// has no such attribute.
Direction direction_in(const std::filesystem::path& path) {
  for (const XmlTag& tag : xml_tags(path)) {
    if (tag.name != "ImageData" && tag.name != "PImageData") continue;
    const auto found = tag.attributes.find("Direction");
    if (found == tag.attributes.end()) return {};
    std::istringstream words(found->second);
    return Direction(std::istream_iterator<double>(words), {});
  }
  return {};
}

/// Says the file's, or what its pieces say, which is the same of all.
Direction direction_of_pieces(const std::filesystem::path& path) {
  Direction direction = direction_in(path);
  for (const XmlTag& tag : xml_tags(path)) {
    const auto source = tag.attributes.find("Source");
    if (tag.name != "Piece" || source == tag.attributes.end()) continue;
    const Direction of_piece = direction_in(path.parent_path() / source->second);
    if (direction.empty()) direction = of_piece;
    if (!of_piece.empty() && of_piece != direction)
      throw InputError(
          fmt::format("{}: the Direction of its piece {} is another one than of the "
                      "others or the file's own; accepted: one",
                      path.string(), source->second));
  }
  return direction;
}

/// VTK 9.1 leaves out how the axes of images in pieces are turned.
class PiecesReader : public GridPieces<vtkXMLPImageDataReader> {
 public:
  static PiecesReader* New() { VTK_STANDARD_NEW_BODY(PiecesReader); }

 protected:
  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override {
    if (!GridPieces::RequestData(request, input, output)) return 0;
    const Direction direction = direction_of_pieces(GetFileName());
    if (direction.size() == 9) vtkImageData::GetData(output)->SetDirectionMatrix(direction.data());
    return 1;
  }
};

constexpr VtkReader readers[] = {{".vti", make<vtkXMLImageDataReader>},
                                 {".vtr", make<vtkXMLRectilinearGridReader>},
                                 {".vts", make<vtkXMLStructuredGridReader>},
                                 {".vtu", make<vtkXMLUnstructuredGridReader>},
                                 {".vtp", make<vtkXMLPolyDataReader>},
                                 {".vtk", make_legacy},
                                 {".pvti", make<PiecesReader>},
                                 {".pvtr", make<GridPieces<vtkXMLPRectilinearGridReader>>},
                                 {".pvts", make<GridPieces<vtkXMLPStructuredGridReader>>},
                                 {".pvtu", make<vtkXMLPUnstructuredGridReader>},
                                 {".pvtp", make<vtkXMLPPolyDataReader>},
                                 {".vtm", make<vtkXMLMultiBlockDataReader>},
                                 {".vtpd", make<vtkXMLPartitionedDataSetReader>},
                                 {".vtpc", make<vtkXMLPartitionedDataSetCollectionReader>}};

}  // namespace

std::span<const VtkReader> plain_readers() { return readers; }

}  // namespace pellucid::readers
