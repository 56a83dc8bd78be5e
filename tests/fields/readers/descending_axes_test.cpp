// SPDX-License-Identifier: GPL-3.0-or-later
// Grids whose axes run downwards: latitudes from north to south, negative spacings.

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;

/// Each axis ascends or descends, in every combination.
Axes turned(int which) {
  Axes axes{evenly(0, 0.5, 5), evenly(-1, 0.25, 7), evenly(2, 1, 4)};
  for (std::size_t a = 0; a < 3; ++a)
    if (which >> a & 1) std::ranges::reverse(axes[a]);
  return axes;
}

class UnitDescendingAxes : public ::testing::Test {
 protected:
  std::unique_ptr<VectorField> read(const std::string& name, const std::string& text,
                                    std::string_view options = {}) {
    write_bytes(folder_ / name, text);
    return make_field((folder_ / name).string() + std::string(options));
  }
  static void expect_straight(const VectorField& field, const std::string& what) {
    for (const Vec3& x : {Vec3(0.3, 0.2, 2.4), Vec3(1.9, -0.9, 4.7), Vec3(1, 0.1, 3)})
      EXPECT_NEAR_VEC(velocity_of(field, x), straight(x), 1e-12) << what;
    EXPECT_EQ(status_at(field, {2.1, 0, 3}), SampleStatus::outside) << what;
    EXPECT_EQ(field.domain().min, Vec3(0, -1, 2)) << what;
  }
  TemporaryFolder folder_;
};

TEST_F(UnitDescendingAxes, OfARectilinearGrid) {
  for (int which = 0; which < 8; ++which) {
    const Axes axes = turned(which);
    const std::string text = rectilinear(axes, vectors("U", crossings(axes), straight));
    for (const char* options : {"", ":sampler=c1"})
      expect_straight(*read("r.vtr", text, options), fmt::format("{}{}", which, options));
  }
}

TEST_F(UnitDescendingAxes, OfAnImageWithNegativeSpacing) {
  for (int which = 0; which < 8; ++which) {
    const Axes axes = turned(which);
    // Indices from 3 on, so that the origin is not where the first sample is.
    std::string extent, origin, spacing;
    for (const auto& axis : axes) {
      const double step = axis[1] - axis[0];
      extent += fmt::format("3 {} ", axis.size() + 2);
      origin += fmt::format("{} ", axis[0] - 3 * step);
      spacing += fmt::format("{} ", step);
    }
    expect_straight(
        *read("i.vti",
              vtk_files::xml("ImageData",
                             fmt::format("<ImageData WholeExtent=\"{0}\" Origin=\"{1}\" "
                                         "Spacing=\"{2}\"><Piece Extent=\"{0}\">{3}</Piece>"
                                         "</ImageData>",
                                         extent, origin, spacing,
                                         data(vectors("U", crossings(axes), straight), {})))),
        std::to_string(which));
  }
}

/// Text of a .vti whose directions run against the world's axes instead.
std::string image_against(const Axes& axes, std::string_view arrays) {
  std::string extent, origin, spacing, directions;
  for (std::size_t a = 0; a < 3; ++a) {
    const double step = axes[a][1] - axes[a][0];
    extent += fmt::format("0 {} ", axes[a].size() - 1);
    origin += fmt::format("{} ", axes[a][0]);
    spacing += fmt::format("{} ", std::abs(step));
    for (std::size_t b = 0; b < 3; ++b)
      directions += fmt::format("{} ", a != b ? 0 : step > 0 ? 1 : -1);
  }
  return vtk_files::xml(
      "ImageData", fmt::format("<ImageData WholeExtent=\"{0}\" Origin=\"{1}\" Spacing=\"{2}\" "
                               "Direction=\"{3}\"><Piece Extent=\"{0}\">{4}</Piece></ImageData>",
                               extent, origin, spacing, directions, arrays));
}

TEST_F(UnitDescendingAxes, OfAnImageWhoseDirectionsRunAgainstTheWorlds) {
  for (int which = 0; which < 8; ++which) {
    const Axes axes = turned(which);
    const std::string text = image_against(axes, data(vectors("U", crossings(axes), straight), {}));
    expect_straight(*read("d.vti", text), std::to_string(which));
  }
}

/// Isosurfaces take the same axes: cells of half a unit each way.
TEST_F(UnitDescendingAxes, OfAnImageThatIsALevel) {
  const auto slope = [](const Vec3& x) { return x.x + 10 * x.y + 100 * x.z; };
  for (int which = 0; which < 8; ++which) {
    Axes axes{evenly(0, 0.5, 5), evenly(-1, 0.5, 4), evenly(2, 0.5, 6)};
    for (std::size_t a = 0; a < 3; ++a)
      if (which >> a & 1) std::ranges::reverse(axes[a]);
    write_bytes(folder_ / "d.vti",
                image_against(axes, data(scalars("p", crossings(axes), slope, "Float32"), {})));
    const auto levels = testing::read_float_levels(folder_ / "d.vti", "p");
    EXPECT_EQ(levels.front().origin, Vec3(0, -1, 2));
    for (const Vec3& at : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(4, 3, 5)})
      EXPECT_FLOAT_EQ(levels.front().at(int(at.x), int(at.y), int(at.z)),
                      float(slope(levels.front().world(at))));
  }
}

TEST_F(UnitDescendingAxes, CellsAreTurnedWithTheirAxes) {
  for (int which = 0; which < 8; ++which) {
    const Axes axes = turned(which);
    const auto field =
        read("c.vtr", rectilinear(axes, {}, vectors("U", crossings(middles(axes)), straight)),
             ":cells=constant");
    const Vec3 in_cell(0.6, -0.3, 4.2), middle(0.75, -0.375, 4.5);
    EXPECT_NEAR_VEC(velocity_of(*field, in_cell), straight(middle), 1e-12) << which;
  }
}

TEST_F(UnitDescendingAxes, CoordinatesThatDoNeitherAreRefused) {
  Axes axes = turned(0);
  axes[1] = {3, 1, 2};
  try {
    read("r.vtr", rectilinear(axes, vectors("U", crossings(axes), straight)));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("they have to ascend, or to descend"));
  }
}

}  // namespace
}  // namespace pellucid::fields
