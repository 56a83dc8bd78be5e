// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's reader of NIfTI leaves to its caller: scales, and where voxels are.

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <array>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "core/files/output_file.h"
#include "tests/readers/simulations/read_files.h"

namespace pellucid::readers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The bytes of a header, by their places as nifti1.h has them.
class Bytes {
 public:
  explicit Bytes(std::size_t count) : text_(count, '\0') {}
  template <class T>
  void put(std::size_t at, T number) {
    std::memcpy(&text_[at], &number, sizeof number);
  }
  template <class T>
  void append(T number) {
    text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class UnitNifti : public ReadFiles {
 protected:
  using Describe = std::function<void(Bytes&)>;

  /// An image of 2 × 2 × 2 voxels of 16 bits: 0, 1, 2, …
  std::filesystem::path nifti(
      float slope, float intercept, std::int16_t times = 1,
      const Describe& describe = [](Bytes&) {}) const {
    Bytes bytes(352);
    bytes.put(0, std::int32_t(348));
    const std::int16_t sizes[8] = {4, 2, 2, 2, times, 1, 1, 1};
    for (std::size_t k = 0; k < 8; ++k) bytes.put(40 + 2 * k, sizes[k]);
    bytes.put(70, std::int16_t(4)), bytes.put(72, std::int16_t(16));
    for (std::size_t k = 0; k < 8; ++k) bytes.put(76 + 4 * k, 1.0f);
    bytes.put(108, 352.0f), bytes.put(112, slope), bytes.put(116, intercept);
    bytes.put(344, std::array<char, 4>{'n', '+', '1', 0});
    describe(bytes);
    for (std::int16_t i = 0; i < 8 * times; ++i) bytes.append(i);
    write_text(folder_ / "i.nii", bytes.text());
    return folder_ / "i.nii";
  }

  /// Every voxel, which its value numbers, is where the file has it.
  void expect_at(const std::filesystem::path& file, const glm::dvec3& origin,
                 const glm::dmat3& steps) const {
    const auto data = read_vtk_data_set(file);
    ASSERT_EQ(data->GetNumberOfPoints(), 8);
    for (vtkIdType id = 0; id < 8; ++id) {
      const int number = int(data->GetPointData()->GetArray(0)->GetComponent(id, 0));
      glm::dvec3 place;
      data->GetPoint(id, &place.x);
      const glm::dvec3 wanted =
          origin + steps * glm::dvec3(number & 1, number >> 1 & 1, number >> 2);
      EXPECT_LE(glm::length(place - wanted), 1e-5) << "voxel " << number;  // the header's floats
    }
  }

  /// Of the file that was written last: as isosurfaces take images.
  bool is_along_axes() const {
    const auto data = read_vtk_data_set(folder_ / "i.nii");
    return vtkImageData::SafeDownCast(data)->GetDirectionMatrix()->IsIdentity();
  }
};

/// As CIFTI has its matrices, along the sixth and the seventh.
TEST_F(UnitNifti, DimensionsBehindTheFifthAreRefused) {
  for (const auto axis : {std::int16_t(6), std::int16_t(7)}) {
    const auto put = [&](Bytes& bytes) {
      bytes.put(40, axis);
      bytes.put(40 + 2 * std::size_t(axis), std::int16_t(2));
    };
    EXPECT_THAT(complaint(nifti(1, 0, 1, put)),
                HasSubstr("dim[" + std::to_string(axis) + "] is 2; accepted: 1"));
  }
  // What stands behind the number of dimensions says nothing.
  EXPECT_EQ(complaint(nifti(1, 0, 1, [](Bytes& bytes) { bytes.put(52, std::int16_t(9)); })),
            "no complaint");
}

TEST_F(UnitNifti, IsScaled) {
  EXPECT_THAT(values(nifti(0.5f, 0), 3), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(values(nifti(0.5f, -3), 3), ElementsAre(-3, -2.5, -2));
  EXPECT_THAT(values(nifti(1, 7), 3), ElementsAre(7, 8, 9));
  for (const float none : {0.0f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_THAT(values(nifti(none, 7), 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(complaint(nifti(2, std::numeric_limits<float>::infinity())),
              HasSubstr("scl_inter is inf"));
}

TEST_F(UnitNifti, VolumesOverTimeAreRefused) {
  EXPECT_THAT(complaint(nifti(1, 0, 3)), HasSubstr("3 volumes over time"));
}

void put_sform(Bytes& bytes, const glm::dvec3& origin, const glm::dmat3& steps) {
  bytes.put(254, std::int16_t(1));
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t a = 0; a < 3; ++a)
      bytes.put(280 + 16 * row + 4 * a, float(steps[int(a)][int(row)]));
    bytes.put(292 + 16 * row, float(origin[int(row)]));
  }
}

const glm::dvec3 origin{10, -20, 30};

TEST_F(UnitNifti, VoxelsAreWhereTheMatrixHasThem) {
  const auto expect_placed = [&](const glm::dmat3& steps) {
    expect_at(nifti(1, 0, 1, [&](Bytes& bytes) { put_sform(bytes, origin, steps); }), origin,
              steps);
  };
  for (const double x : {-2.0, 2.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.5, 1.5}) expect_placed({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
  expect_placed({{0, 2, 0}, {0, 0, 3}, {1, 0, 0}});
  expect_placed({{0, 2, 0}, {0, 0, 3}, {-1, 0, 0}});
  EXPECT_TRUE(is_along_axes());
  expect_placed({{1.6, 1.2, 0}, {-0.6, 0.8, 0}, {0, 0, 3}});
  EXPECT_FALSE(is_along_axes());
}

/// Half a turn about x, (b, c, d) = (1, 0, 0), takes y and z to their opposites; qfac, z once more.
TEST_F(UnitNifti, VoxelsAreWhereTheQuaternionHasThem) {
  for (const float qfac : {-1.0f, 1.0f}) {
    const auto describe = [&](Bytes& bytes) {
      bytes.put(252, std::int16_t(1)), bytes.put(256, 1.0f), bytes.put(76, qfac);
      for (std::size_t a = 0; a < 3; ++a) {
        bytes.put(80 + 4 * a, float(a + 1));
        bytes.put(268 + 4 * a, float(origin[int(a)]));
      }
    };
    expect_at(nifti(1, 0, 1, describe), origin, {{1, 0, 0}, {0, -2, 0}, {0, 0, -3 * qfac}});
  }
}

TEST_F(UnitNifti, TheSformCountsWhereTheQformIsOfTheOtherHand) {
  const glm::dmat3 steps{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const float qfac : {-1.0f, 1.0f}) {
    const auto describe = [&](Bytes& bytes) {
      bytes.put(252, std::int16_t(1)), bytes.put(76, qfac);  // no turn
      put_sform(bytes, origin, qfac > 0 ? steps : glm::dmat3(1));
    };
    expect_at(nifti(1, 0, 1, describe), origin, qfac > 0 ? steps : glm::dmat3(1));
  }
}

TEST_F(UnitNifti, WithoutAMatrixTheFirstVoxelIsAtZero) {
  expect_at(nifti(1, 0), glm::dvec3(0), glm::dmat3(1));
}

TEST_F(UnitNifti, AMatrixWithoutAnAxisIsRefused) {
  EXPECT_THAT(complaint(nifti(1, 0, 1,
                              [](Bytes& bytes) {
                                put_sform(bytes, origin, {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}});
                              })),
              HasSubstr("a step along axis 1 of its matrix is 0 long"));
}

}  // namespace
}  // namespace pellucid::readers
