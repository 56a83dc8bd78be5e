// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkDataSetReader.h>
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

#include "readers/vtk/parse_file.h"

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

constexpr VtkReader readers[] = {{".vti", make<vtkXMLImageDataReader>},
                                 {".vtr", make<vtkXMLRectilinearGridReader>},
                                 {".vts", make<vtkXMLStructuredGridReader>},
                                 {".vtu", make<vtkXMLUnstructuredGridReader>},
                                 {".vtp", make<vtkXMLPolyDataReader>},
                                 {".vtk", make_legacy},
                                 {".pvti", make<vtkXMLPImageDataReader>},
                                 {".pvtr", make<vtkXMLPRectilinearGridReader>},
                                 {".pvts", make<vtkXMLPStructuredGridReader>},
                                 {".pvtu", make<vtkXMLPUnstructuredGridReader>},
                                 {".pvtp", make<vtkXMLPPolyDataReader>},
                                 {".vtm", make<vtkXMLMultiBlockDataReader>},
                                 {".vtpd", make<vtkXMLPartitionedDataSetReader>},
                                 {".vtpc", make<vtkXMLPartitionedDataSetCollectionReader>}};

}  // namespace

std::span<const VtkReader> plain_readers() { return readers; }

}  // namespace pellucid::readers
