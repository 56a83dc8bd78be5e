// SPDX-License-Identifier: GPL-3.0-or-later
// Point grids as OpenVDB writes them, with and without codecs.

#include <gmock/gmock.h>
#include <openvdb/points/PointConversion.h>

#include <fstream>
#include <random>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

using openvdb::points::NullCodec;
using openvdb::points::PointDataGrid;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

constexpr double voxel = 0.25;

std::vector<openvdb::Vec3f> random_points(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> coordinate(-2, 2);
  std::vector<openvdb::Vec3f> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

template <class Codec>
PointDataGrid::Ptr point_grid(const std::vector<openvdb::Vec3f>& points) {
  openvdb::initialize();
  const auto grid = openvdb::points::createPointDataGrid<Codec, PointDataGrid>(
      points, *openvdb::math::Transform::createLinearTransform(voxel));
  grid->setName("stars");
  return grid;
}

/// Fills the attribute with f(world position).
template <class T>
void attach(PointDataGrid& grid, const std::string& name, const auto& f) {
  openvdb::points::appendAttribute<T>(grid.tree(), name);
  for (auto leaf = grid.tree().beginLeaf(); leaf; ++leaf) {
    const openvdb::points::AttributeHandle<openvdb::Vec3f> p(leaf->constAttributeArray("P"));
    openvdb::points::AttributeWriteHandle<T> values(leaf->attributeArray(name));
    for (auto i = leaf->beginIndexOn(); i; ++i)
      values.set(*i, f(grid.indexToWorld(openvdb::Vec3d(p.get(*i)) + i.getCoord().asVec3d())));
  }
}

void write(const std::filesystem::path& path, const openvdb::GridCPtrVec& grids) {
  openvdb::io::File file(path.string());
  file.write(grids);
}

TEST(UnitVdbPoints, PositionsAndNumbersAreThoseOfTheGrids) {
  const TemporaryFolder folder;
  const auto points = random_points(500);
  const auto exact = point_grid<NullCodec>(points);
  attach<float>(*exact, "density", [](const openvdb::Vec3d& x) { return float(x.x() + 3); });
  attach<int>(*exact, "id", [](const openvdb::Vec3d& x) { return int(100 * x.y()); });
  attach<openvdb::Vec3f>(*exact, "Cd", [](const openvdb::Vec3d& x) {
    return openvdb::Vec3f(float(x.z() + 2) / 4, 0.5f, 0.25f);
  });
  attach<openvdb::Vec3f>(
      *exact, "v", [](const openvdb::Vec3d& x) { return openvdb::Vec3f(1, float(x.x()), 2); });
  const auto path = folder / "stars.vdb";
  write(path, {exact});
  const PointSet set = read_points(path);
  ASSERT_EQ(set.positions.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& x = set.positions[i];
    EXPECT_FLOAT_EQ(set.scalars.at("density")[i], x.x + 3);
    EXPECT_EQ(set.scalars.at("id")[i], int(100 * x.y));
    EXPECT_FLOAT_EQ(set.scalars.at("v_y")[i], x.x);
    // A sum up to 4 is rounded to float, by 1.2e-7, and a quarter of it again.
    EXPECT_NEAR(set.colors[i].r, (x.z + 2) / 4, 1.2e-7);
    EXPECT_EQ(Rgba(0, set.colors[i].g, set.colors[i].b, set.colors[i].a), Rgba(0, 0.5, 0.25, 1));
  }
  // The grid sorts by voxel: the sums tell whether every point is there once. A position is a float
  // fraction of a voxel.
  Vec3 sum(0), expected(0);
  for (const Vec3& x : set.positions) sum += x;
  for (const openvdb::Vec3f& x : points) expected += Vec3(x.x(), x.y(), x.z());
  EXPECT_LT(glm::length(sum - expected), 500 * voxel * 1.2e-7);  // if all were rounded one way
}

TEST(UnitVdbPoints, CodecsAndSeveralGridsAreRead) {
  const TemporaryFolder folder;
  const auto points = random_points(64);
  const auto coarse = point_grid<openvdb::points::FixedPointCodec<false>>(points);
  const auto exact = point_grid<NullCodec>(points);
  attach<float>(*exact, "density", [](const openvdb::Vec3d&) { return 1.0f; });
  const auto path = folder / "both.vdb";
  write(path, {coarse, exact});
  const PointSet set = read_points(path);
  ASSERT_EQ(set.positions.size(), 128u);
  EXPECT_TRUE(set.scalars.empty()) << "only one of the grids has it";
  // In the same order of voxels; 16 bits a coordinate in a voxel, cut off, and a float's rounding.
  const double step = voxel / 65535;
  for (std::size_t i = 0; i < 64; ++i)
    EXPECT_LT(glm::length(set.positions[i] - set.positions[64 + i]), 1.01 * std::sqrt(3.0) * step);
}

TEST(UnitVdbPoints, RefusesOtherGridsAndDamagedFiles) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) -> std::string {
    try {
      read_points(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto other = folder / "levels.vdb";
  write(other, {openvdb::FloatGrid::create(1)});
  EXPECT_THAT(refusal(other), HasSubstr("the file holds no points"));
  const auto path = folder / "stars.vdb";
  write(path, {point_grid<NullCodec>(random_points(100))});
  const std::string whole = read_text(path);
  for (const double share : {0.1, 0.4, 0.7, 0.99}) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, std::size_t(share * whole.size()));
    EXPECT_THAT(refusal(path), HasSubstr("stars.vdb: not a valid .vdb file"));
  }
}

}  // namespace
}  // namespace pellucid::geometry
