// SPDX-License-Identifier: GPL-3.0-or-later
// The header: A. Cheng et al., MRC2014: Extensions to the MRC format header for electron
// cryo-microscopy and tomography, 2015, as ccpem.ac.uk/mrc_format has it; IMOD's stamp and flags:
// bio3d.colorado.edu/imod/doc/mrc_format.txt.

#include "readers/vtk/make_mrc.h"

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkMRCReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/error.h"

namespace pellucid::readers {
namespace {

/// Numbers of 32 bits of the header, by their places in bytes; in either byte order.
class MrcHeader {
 public:
  explicit MrcHeader(const std::filesystem::path& path) {
    std::ifstream(path, std::ios::binary).read(bytes_.data(), std::streamsize(bytes_.size()));
    constexpr int largest_mode = 101;
    swapped_ = number(12) < 0 || number(12) > largest_mode;
  }

  int mode() const { return number(12); }
  /// Which axis columns, rows and sections run along: 1 to 3; 0 where the file does not say.
  std::array<int, 3> axes() const { return {number(64), number(68), number(72)}; }
  bool has_signed_bytes() const {
    constexpr int first_version = 20140, imod = 1146047817;
    return mode() == 0 &&
           (number(152) == imod ? (number(156) & 1) != 0 : number(108) >= first_version);
  }

 private:
  std::int32_t number(std::size_t at) const {
    std::array<char, 4> raw;
    std::copy_n(bytes_.begin() + std::ptrdiff_t(at), 4, raw.begin());
    if (swapped_) std::ranges::reverse(raw);
    std::int32_t value = 0;
    std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }

  std::array<char, 1024> bytes_{};
  bool swapped_ = false;
};

void refuse(const MrcHeader& header, const std::filesystem::path& path) {
  constexpr int unsigned_16 = 6;
  if (header.mode() == unsigned_16)
    throw InputError(
        fmt::format("{}: mode 6, unsigned numbers of 16 bits; accepted: modes 0, 1 "
                    "and 2, bytes, signed numbers of 16 bits and floats",
                    path.string()));
  const auto [columns, rows, sections] = header.axes();
  if (const bool is_said = columns != 0 || rows != 0 || sections != 0;
      is_said && (columns != 1 || rows != 2 || sections != 3))
    throw InputError(
        fmt::format("{}: its columns, rows and sections are the axes {}, {}, {}; "
                    "accepted: 1, 2, 3",
                    path.string(), columns, rows, sections));
}

class MrcReader : public vtkMRCReader {
 public:
  static MrcReader* New() { VTK_STANDARD_NEW_BODY(MrcReader); }
  void SetSignedBytes(bool are_signed) { are_signed_ = are_signed; }

 protected:
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* information) override {
    vtkMRCReader::ExecuteDataWithInformation(output, information);
    vtkPointData* data = vtkImageData::SafeDownCast(output)->GetPointData();
    vtkDataArray* bytes = data->GetScalars();
    if (!are_signed_ || !bytes || bytes->GetDataType() != VTK_UNSIGNED_CHAR) return;
    vtkNew<vtkSignedCharArray> numbers;
    numbers->SetName(bytes->GetName());
    numbers->SetNumberOfComponents(bytes->GetNumberOfComponents());
    numbers->SetNumberOfTuples(bytes->GetNumberOfTuples());
    std::memcpy(numbers->GetVoidPointer(0), bytes->GetVoidPointer(0),
                std::size_t(bytes->GetNumberOfValues()));
    data->SetScalars(numbers);
  }

 private:
  bool are_signed_ = false;
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_mrc(const std::filesystem::path& path) {
  const MrcHeader header(path);
  refuse(header, path);
  const auto reader = vtkSmartPointer<MrcReader>::New();
  reader->SetFileName(path.c_str());
  reader->SetSignedBytes(header.has_signed_bytes());
  return reader;
}

}  // namespace pellucid::readers
