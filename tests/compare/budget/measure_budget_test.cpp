// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/measure_budget.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "compare/methods/methods.h"
#include "compare/pictures/image_file.h"
#include "core/files/output_file.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Sheets that fill the picture, the first one nearest, over blue.
class UnitMeasureBudget : public ::testing::Test {
 protected:
  CellMeasurement measured(const std::string& vertices_of_sheets, int sheets,
                           const std::string& method) {
    write_text(folder_ / "sheets.ply", ply(vertices_of_sheets, sheets));
    write_text(folder_ / "scene.json",
               R"({"format": "pellucid-scene", "version": 1, "resolution": [8, 6],
                   "camera": {"type": "orthographic", "eye": [0, 0, 5], "height": 2},
                   "background": [0, 0, 1], "objects": [{"mesh": "sheets.ply"}]})");
    const scene::Scene scene = scene::load_scene(folder_ / "scene.json");
    const MethodCall reference = call("raytrace");
    Cell cell{.scene_file = folder_ / "scene.json", .scene = "scene", .call = call(method)};
    cell.budget = BudgetOptions{};
    CellMeasurement found;
    add_budget(cell, reference, scene, {}, found);
    return found;
  }

  static MethodCall call(std::string_view name) {
    const scene::MethodRow& row = find_row("method", name, methods());
    return {&row, Parameters(row.name, row.parameters, {})};
  }
  static std::string ply(const std::string& vertices, int sheets) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(3 * sheets) +
                       "\nproperty float x\nproperty float y\nproperty float z\n"
                       "property float red\nproperty float green\nproperty float blue\n"
                       "property float alpha\nelement face " +
                       std::to_string(sheets) +
                       "\nproperty list uchar int vertex_indices\nend_header\n" + vertices;
    for (int i = 0; i < sheets; ++i)
      text += "3 " + std::to_string(3 * i) + " " + std::to_string(3 * i + 1) + " " +
              std::to_string(3 * i + 2) + "\n";
    return text;
  }
  static std::string sheet(const std::string& z, const std::string& color) {
    return "-20 -20 " + z + " " + color + "\n20 -20 " + z + " " + color + "\n0 40 " + z + " " +
           color + "\n";
  }
  static const BudgetLine& line(const CellMeasurement& found, std::string_view stage) {
    for (const BudgetLine& one : found.row.budget->lines)
      if (one.stage == stage) return one;
    throw std::runtime_error("no such stage");
  }

  testing::TemporaryFolder folder_;
};

// Over an important sheet, opaque points that one of 16 samples of each pixel meets, at an eighth
// of it, and its centre does not: by q = 3 they have a quarter of their opacity where they are met.
TEST_F(UnitMeasureBudget, OpacitiesAreOptimizedForTheSamplesThatAreDrawn) {
  std::string points =
      "ply\nformat ascii 1.0\nelement vertex 48\nproperty float x\nproperty float y\n"
      "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
      "property float alpha\nend_header\n";
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x)
      points += fmt::format("{} {} 1 1 0 0 1\n", (x - 4 + 0.125) / 3, (y - 3 + 0.125) / 3);
  write_text(folder_ / "points.ply", points);
  write_text(folder_ / "sheet.ply", ply(sheet("0", "0 0 1 1"), 1));
  write_text(folder_ / "scene.json",
             R"({"format": "pellucid-scene", "version": 1, "resolution": [8, 6],
                 "camera": {"type": "orthographic", "eye": [0, 0, 5], "height": 2},
                 "energy": {"q": 3, "r": 0}, "objects": [
                   {"points": "points.ply", "radius": 0.01},
                   {"mesh": "sheet.ply", "importance": 1}]})");
  const scene::Scene scene = scene::load_scene(folder_ / "scene.json");
  Cell cell{.scene_file = folder_ / "scene.json", .scene = "scene", .call = call("raytrace")};
  cell.budget = BudgetOptions{};
  cell.opacities = call("decoupled-lists");
  CellMeasurement found;
  add_budget(cell, call("raytrace"), scene, {}, found);
  // The mean is (1, 0, 63) / 64 where the centre is blue.
  EXPECT_NEAR(found.row.budget->rmse, std::sqrt(2.0 / 3) / 64, 1e-6);
}

double byte_of(double value) { return std::round(255 * value) / 255; }

// Red over green over blue, α = 0.4 each: the exact composite is (0.4, 0.24, 0.36), the weighted
// average of both colours with the exact coverage 0.64 is (0.32, 0.32, 0.36).
TEST_F(UnitMeasureBudget, TheWeightedAveragesErrorIsThatOfCompositing) {
  const CellMeasurement found =
      measured(sheet("1", "1 0 0 0.4") + sheet("0", "0 1 0 0.4"), 2, "weighted-average");
  const Vec3 truth(0.4, 0.24, 0.36), average(0.32, 0.32, 0.36);
  const auto shown = [](const Vec3& v) { return Vec3(byte_of(v.r), byte_of(v.g), byte_of(v.b)); };
  const Vec3 error = shown(average) - truth;
  const auto share = [&](const Vec3& d) { return glm::dot(d, error) / glm::dot(error, error); };
  // Composites in float are rounded some times by 6e-8, against an error of 0.08.
  const double rounding = 1e-5;
  const BudgetLine& compositing = line(found, "compositing");
  EXPECT_NEAR(compositing.first, share(shown(average) - shown(truth)), rounding);
  EXPECT_NEAR(compositing.last, share(average - truth), rounding);
  EXPECT_NEAR(line(found, "display").first, share(shown(average) - average), rounding);
  EXPECT_NEAR(line(found, "display").last, share(shown(truth) - truth), rounding);
  for (const char* stage : {"samples", "arithmetic"})
    EXPECT_NEAR(line(found, stage).share, 0, rounding) << stage;
  EXPECT_NEAR(found.row.budget->interaction, 0, rounding);
  EXPECT_NEAR(found.row.budget->rmse, glm::length(error) / std::sqrt(3.0), 1e-7);
  for (const char* stage : {"field", "integration", "mesh", "opacities"})
    EXPECT_NE(line(found, stage).why_not, "") << stage;
  ASSERT_EQ(found.further.size(), 4u);
  EXPECT_EQ(found.row.pictures[1].name, "budget-compositing");
}

TEST_F(UnitMeasureBudget, AnExactPicturesErrorIsThatOfTheDisplay) {
  const CellMeasurement found = measured(sheet("0", "1 0 0 0.3"), 1, "raytrace");
  EXPECT_NEAR(line(found, "display").share, 1, 1e-5);
  EXPECT_THAT(line(found, "compositing").why_not, HasSubstr("every layer exactly"));
}

TEST_F(UnitMeasureBudget, WhereNothingIsWrongThereIsNothingToSplit) {
  const CellMeasurement found = measured(sheet("0", "1 0 0 1"), 1, "raytrace");
  EXPECT_FALSE(found.row.budget.has_value());
  EXPECT_THAT(found.row.explanation, Contains(HasSubstr("nothing to split")));
}

}  // namespace
}  // namespace pellucid::compare
