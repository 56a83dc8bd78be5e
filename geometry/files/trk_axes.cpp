// SPDX-License-Identifier: GPL-3.0-or-later
// After nibabel (get_affine_trackvis_to_rasmm, io_orientation and inv_ornt_aff of 5.0), by which
// most of these files are written and read.

#include "geometry/files/trk_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/matrix.hpp>

namespace pellucid::geometry {
namespace {

/// An axis of the world, and whether a voxel's axis runs along it.
struct Direction {
  int axis = 0;
  bool positive = true;
};
using Directions = std::array<Direction, 3>;

/// The rotation that is nearest to three axes of any lengths: the limit of R ← (R + R⁻ᵀ) / 2, which
/// is the polar factor that nibabel has from a singular value decomposition. The determinant of
/// axes of unit length is 1 when they are at right angles.
Mat3 nearest_rotation(Mat3 axes, const ByteReader& bytes) {
  for (int column = 0; column < 3; ++column) axes[column] /= glm::length(axes[column]);
  if (!(std::abs(glm::determinant(axes)) > 1e-6))
    bytes.fail("vox_to_ras; accepted: a matrix with an inverse");
  for (int i = 0; i < 50; ++i) axes = (axes + glm::transpose(glm::inverse(axes))) * 0.5;
  return axes;
}

/// The world's axes that the voxels' run along most, each once.
Directions directions_of(const Mat4& ras_from_voxel, const ByteReader& bytes) {
  const Mat3 axes = nearest_rotation(Mat3(ras_from_voxel), bytes);
  Directions directions;
  std::array<bool, 3> taken{};
  for (int column = 0; column < 3; ++column) {
    double most = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (const double along = axes[column][axis];
          !taken[std::size_t(axis)] && std::abs(along) > most) {
        most = std::abs(along);
        directions[std::size_t(column)] = {axis, along >= 0};
      }
    taken[std::size_t(directions[std::size_t(column)].axis)] = true;
  }
  return directions;
}

/// "LPS": the voxels' axes run to the left, to the back, up.
Directions directions_of(const std::string& order, const ByteReader& bytes) {
  Directions directions;
  std::array<bool, 3> taken{};
  for (std::size_t k = 0; k < 3; ++k) {
    const char letter =
        k < order.size() ? char(std::toupper(static_cast<unsigned char>(order[k]))) : '?';
    const std::size_t place = std::string_view("RLAPSI").find(letter);
    if (place == std::string_view::npos || taken[place / 2])
      bytes.fail(fmt::format("voxel_order '{}'; accepted: three of R|L, A|P, S|I", order));
    directions[k] = {int(place / 2), place % 2 == 0};
    taken[place / 2] = true;
  }
  return directions;
}

/// "LPS".
std::string letters_of(const Directions& directions) {
  std::string letters;
  for (const Direction& direction : directions)
    letters += "RLAPSI"[2 * direction.axis + (direction.positive ? 0 : 1)];
  return letters;
}

bool exchanges_axes(const Directions& a, const Directions& b) {
  return !std::ranges::equal(a, b, {}, &Direction::axis, &Direction::axis);
}

/// Brings the file's voxels to the image's: y_k = x_j or, turned round, size_k - 1 - x_j, where the
/// image's axis j runs along the axis of the world that the file's axis k does. So nibabel writes
/// and reads files; where three axes are exchanged in a circle it is the inverse of what the names
/// say.
Mat4 image_from_file(const Directions& in_file, const Directions& in_image,
                     const std::array<int, 3>& size) {
  Mat4 matrix(0);
  matrix[3][3] = 1;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) {
      const Direction &a = in_file[std::size_t(k)], &b = in_image[std::size_t(j)];
      if (a.axis != b.axis) continue;
      const bool same = a.positive == b.positive;
      matrix[j][k] = same ? 1 : -1;
      if (!same) matrix[3][k] = size[std::size_t(k)] - 1;
    }
  return matrix;
}

Mat4 voxel_from_file(const TrkImage& image, const ByteReader& bytes) {
  Mat4 matrix(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(image.voxel_size[axis] > 0))
      bytes.fail(fmt::format("voxel_size {} along axis {}; accepted: a length above 0",
                             image.voxel_size[axis], axis));
    matrix[axis][axis] = 1 / image.voxel_size[axis];
    matrix[3][axis] = -0.5;  // a voxel's centre is whole
  }
  return matrix;
}

}  // namespace

Mat4 ras_from_trk(const TrkImage& image, const ByteReader& bytes,
                  std::vector<std::string>& remarks) {
  const bool is_given = image.ras_from_voxel[3][3] != 0;
  if (!is_given) remarks.push_back("vox_to_ras is not recorded: taken for the identity");
  const Mat4 ras_from_voxel = is_given ? image.ras_from_voxel : Mat4(1);
  const std::string order = image.voxel_order.empty() ? "LPS" : image.voxel_order;
  const Directions in_file = directions_of(order, bytes);
  const Directions in_image = directions_of(ras_from_voxel, bytes);
  if (exchanges_axes(in_file, in_image))
    remarks.push_back(
        fmt::format("voxel_order {} has other axes than vox_to_ras, {}: exchanged as nibabel does",
                    order, letters_of(in_image)));
  return ras_from_voxel * image_from_file(in_file, in_image, image.size) *
         voxel_from_file(image, bytes);
}

}  // namespace pellucid::geometry
