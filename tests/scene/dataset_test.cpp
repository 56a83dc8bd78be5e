#include "scene/dataset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/error.h"
#include "scene/datasets/stack.h"

namespace pellucid {
namespace {

const Vertices& vertices(const Dataset& data) {
  return std::visit([](const auto& set) -> const Vertices& { return set; }, data);
}

TEST(PropertyDataset, EveryRowMakesTheSameDataTwice) {
  for (const DatasetRow& row : datasets()) {
    const Dataset once = make_dataset(row.name), again = make_dataset(row.name);
    EXPECT_FALSE(vertices(once).positions.empty()) << row.name;
    EXPECT_TRUE(vertices(once).positions == vertices(again).positions) << row.name;
    EXPECT_NE(row.citation, "") << row.name;
  }
}

TEST(UnitDataset, UnknownNamesAndValuesAreRefused) {
  EXPECT_THROW(make_dataset("stak"), InputError);
  EXPECT_THROW(make_dataset("stack:layers=0"), InputError);
}

/// The sheets' depths, in the order in which they are drawn.
std::vector<double> depths(const std::string& options) {
  const auto mesh = std::get<TriangleMesh>(make_dataset("stack:" + options));
  std::vector<double> z;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 4) z.push_back(mesh.positions[i].z);
  return z;
}

TEST(UnitStack, SheetsLieWhereTheirParametersSay) {
  EXPECT_EQ(depths("layers=3,order=front"), (std::vector<double>{1, 0, -1}));
  EXPECT_EQ(depths("layers=3,order=back,scale=10,shift=5"), (std::vector<double>{-5, 5, 15}));
  EXPECT_EQ(depths("layers=2,depths=equal"), (std::vector<double>{0, 0}));
  const std::vector<double> close = depths("layers=3,depths=ulp,order=front");
  EXPECT_EQ(close[1], std::nextafter(1.0, 0.0));
  EXPECT_EQ(close[2], std::nextafter(close[1], 0.0));
  std::vector<double> shuffled = depths("layers=50");
  EXPECT_FALSE(std::is_sorted(shuffled.begin(), shuffled.end()));
  std::sort(shuffled.begin(), shuffled.end());
  std::vector<double> even = depths("layers=50,order=back");
  EXPECT_EQ(shuffled, even);
}

TEST(UnitStack, EverySheetCoversTheSquareOnce) {
  for (const char* sheet : {"square", "grid", "needles"}) {
    const auto mesh =
        std::get<TriangleMesh>(make_dataset(std::string("stack:layers=1,sheet=") + sheet));
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 n =
          glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      EXPECT_GE(n.z, 0) << sheet;  // none is turned, so that none lies on another
      area += n.z / 2;
    }
    EXPECT_NEAR(area, 16, 1e-12) << sheet;
  }
}

}  // namespace
}  // namespace pellucid
