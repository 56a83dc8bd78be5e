// SPDX-License-Identifier: GPL-3.0-or-later
// The header: A. Cheng et al., MRC2014: Extensions to the MRC format header for electron
// cryo-microscopy and tomography, 2015, as ccpem.ac.uk/mrc_format has it; IMOD's stamp and flags:
// bio3d.colorado.edu/imod/doc/mrc_format.txt. VTK reads the header; of the numbers it swaps the
// bytes of the first row alone, once for every row, and leaves what a file that was cut off lacks.

#include "readers/simulations/make_mrc.h"

#include <fmt/format.h>
#include <vtkByteSwap.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMRCReader.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSignedCharArray.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/error.h"

namespace pellucid::readers {
namespace {

/// Numbers of 32 bits of the header, by their places in bytes; in either byte order.
class MrcHeader {
 public:
  MrcHeader() = default;
  explicit MrcHeader(const std::filesystem::path& path) {
    std::ifstream(path, std::ios::binary).read(bytes_.data(), std::streamsize(bytes_.size()));
    constexpr int largest_mode = 101;
    swapped_ = bytes_[stamp] == big_endian || number(12) < 0 || number(12) > largest_mode;
  }

  /// Says whether numbers begin with their largest byte, and whether the file says so.
  bool is_big_endian() const { return swapped_; }
  bool says_big_endian() const { return bytes_[stamp] == big_endian; }
  /// Where the samples begin, in bytes.
  std::int64_t data_start() const { return std::int64_t(bytes_.size()) + number(92); }
  /// The angles between the axes, in degrees; 0 where the file does not say.
  std::array<float, 3> angles() const { return {real(52), real(56), real(60)}; }

  int mode() const { return number(12); }
  /// Which axis columns, rows and sections run along: 1 to 3; 0 where the file does not say.
  std::array<int, 3> axes() const { return {number(64), number(68), number(72)}; }
  bool has_signed_bytes() const {
    constexpr int first_version = 20140, imod = 1146047817;
    return mode() == 0 &&
           (number(152) == imod ? (number(156) & 1) != 0 : number(108) >= first_version);
  }

 private:
  static constexpr std::size_t stamp = 212;
  static constexpr char big_endian = 0x11;

  template <class T>
  T value(std::size_t at) const {
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes_.begin() + std::ptrdiff_t(at), raw.size(), raw.begin());
    if (swapped_) std::ranges::reverse(raw);
    T result;
    std::memcpy(&result, raw.data(), sizeof result);
    return result;
  }
  std::int32_t number(std::size_t at) const { return value<std::int32_t>(at); }
  float real(std::size_t at) const { return value<float>(at); }

  std::array<char, 1024> bytes_{};
  bool swapped_ = false;
};

void refuse_mode(int mode, const std::filesystem::path& path) {
  constexpr int unsigned_16 = 6;
  constexpr std::array known{0, 1, 2, 3, 4, 16};
  if (std::ranges::find(known, mode) == known.end())
    throw InputError(fmt::format(
        "{}: mode {}{}; accepted: modes 0, 1 and 2, bytes, signed numbers of 16 bits "
        "and floats",
        path.string(), mode, mode == unsigned_16 ? ", unsigned numbers of 16 bits" : ""));
}

void refuse(const MrcHeader& header, const std::filesystem::path& path) {
  refuse_mode(header.mode(), path);
  if (header.is_big_endian() && !header.says_big_endian())
    throw InputError(
        fmt::format("{}: its largest bytes are first, but byte 213, the machine "
                    "stamp, is not 17; accepted: a stamp that says so",
                    path.string()));
  for (const float angle : header.angles())
    if (angle != 0 && !(std::abs(angle - 90) < 1e-3f))
      throw InputError(
          fmt::format("{}: an angle between its axes is {}°; accepted: 90°", path.string(), angle));
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
  void SetHeader(const MrcHeader& header) { header_ = header; }

 protected:
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* information) override {
    vtkImageData* image = vtkImageData::SafeDownCast(output);
    AllocateOutputData(image, information,
                       information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
    if (vtkDataArray* numbers = image->GetPointData()->GetScalars()) {
      read(*numbers);
      if (header_.has_signed_bytes()) give_sign(*numbers, *image->GetPointData());
    }
  }

 private:
  void read(vtkDataArray& numbers) {
    const std::int64_t wanted = numbers.GetNumberOfValues() * numbers.GetDataTypeSize();
    std::ifstream file(GetFileName(), std::ios::binary);
    file.seekg(header_.data_start());
    file.read(static_cast<char*>(numbers.GetVoidPointer(0)), wanted);
    if (file.gcount() != wanted)
      throw InputError(
          fmt::format("{}: {} bytes of samples, but its {} samples take {}; truncated?",
                      GetFileName(), file.gcount(), numbers.GetNumberOfTuples(), wanted));
    if (header_.is_big_endian())
      vtkByteSwap::SwapVoidRange(numbers.GetVoidPointer(0),
                                 std::size_t(numbers.GetNumberOfValues()),
                                 std::size_t(numbers.GetDataTypeSize()));
  }

  static void give_sign(vtkDataArray& bytes, vtkPointData& data) {
    vtkNew<vtkSignedCharArray> numbers;
    numbers->SetName(bytes.GetName());
    numbers->SetNumberOfComponents(bytes.GetNumberOfComponents());
    numbers->SetNumberOfTuples(bytes.GetNumberOfTuples());
    std::memcpy(numbers->GetVoidPointer(0), bytes.GetVoidPointer(0),
                std::size_t(bytes.GetNumberOfValues()));
    data.SetScalars(numbers);
  }

  MrcHeader header_;
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> make_mrc(const std::filesystem::path& path) {
  const MrcHeader header(path);
  refuse(header, path);
  const auto reader = vtkSmartPointer<MrcReader>::New();
  reader->SetFileName(path.c_str());
  reader->SetHeader(header);
  return reader;
}

}  // namespace pellucid::readers
