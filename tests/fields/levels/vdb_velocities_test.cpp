// SPDX-License-Identifier: GPL-3.0-or-later
// Levels derived from the velocities of OpenVDB files: which grid is meant, and where its samples
// belong.

#include <gmock/gmock.h>
#include <openvdb/openvdb.h>

#include <cmath>

#include "core/error.h"
#include "fields/levels/vdb_levels.h"
#include "fields/readers/vdb_field.h"
#include "readers/vdb/grid_blocks.h"
#include "tests/fields/levels/vdb_refusal.h"

namespace pellucid::fields {
namespace {

using openvdb::math::Transform;
using ::testing::HasSubstr;
using testing::read_float_levels;
using testing::refusal;

/// n³ voxels of a rotation about z with this speed.
openvdb::Vec3SGrid::Ptr vector_grid(const std::string& name, int n, float speed) {
  openvdb::initialize();
  auto grid = openvdb::Vec3SGrid::create();
  grid->setName(name);
  auto accessor = grid->getAccessor();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        accessor.setValueOn({i, j, k}, openvdb::Vec3s(-speed * float(j), speed * float(i), 0));
  return grid;
}

std::vector<ScalarLevel> magnitudes(const openvdb::GridPtrVec& grids,
                                    const std::string& velocity = {}) {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write(grids);
  return read_float_levels(folder / "levels.vdb", "magnitude", velocity);
}

TEST(UnitVdbVelocities, OneOfSeveralVectorGridsIsTheVelocity) {
  const auto velocity = vector_grid("vel", 4, 1), color = vector_grid("Cd", 4, 7);
  for (const auto& grids : {openvdb::GridPtrVec{velocity, color}, {color, velocity}}) {
    const auto levels = magnitudes(grids);
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_EQ(levels.front().at(3, 0, 0), 3);
    EXPECT_EQ(magnitudes(grids, "Cd").front().at(3, 0, 0), 21);
  }
  EXPECT_EQ(magnitudes({color}).front().at(3, 0, 0), 21);  // the only one, whatever its name
  EXPECT_EQ(magnitudes({velocity, vector_grid("vel", 5, 2)}).size(), 2u);  // levels of one name
}

/// u = x at the voxels' lower faces: where it belongs, |v| is x at their middles.
template <class Grid>
typename Grid::Ptr staggered_grid() {
  openvdb::initialize();
  auto grid = Grid::create(typename Grid::ValueType(99));  // a background that would show
  grid->setName("v");
  grid->setTransform(Transform::createLinearTransform(0.5));
  grid->setGridClass(openvdb::GRID_STAGGERED);
  auto accessor = grid->getAccessor();
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i)
        accessor.setValueOn({i, j, k}, typename Grid::ValueType(0.5 * (i + 1.5), 2, -1));
  return grid;
}

TEST(UnitVdbVelocities, StaggeredVelocitiesBelongToTheMiddlesOfVoxels) {
  for (const openvdb::GridBase::Ptr& grid :
       {openvdb::GridBase::Ptr(staggered_grid<openvdb::Vec3SGrid>()),
        openvdb::GridBase::Ptr(staggered_grid<openvdb::Vec3DGrid>())}) {
    const std::vector<readers::VdbGrid> grids{
        {.name = "v", .value_type = grid->valueType(), .grid = grid}};
    const auto levels = rounded(levels_of(grids, "v.vdb", "magnitude"), 0);
    const ScalarLevel& level = levels.levels.front();
    EXPECT_EQ(level.size, (std::array{5, 5, 5}));  // the last voxels have one face alone
    EXPECT_EQ(level.origin, Vec3(0));
    for (int i = 0; i < 5; ++i)
      EXPECT_FLOAT_EQ(float(levels.scale.value(level.at(i, 2, 3))),
                      float(glm::length(Vec3(0.5 * (i + 2), 2, -1))));
    EXPECT_THROW(field_of(grids, {}, "v.vdb"), InputError);  // a velocity's faces are asked for
    FileOptions averaged;
    averaged.average_faces = true;
    const auto field = field_of(grids, averaged, "v.vdb");
    EXPECT_EQ(field->domain().max, Vec3(2));
    Vec3 v;
    ASSERT_EQ(field->sampler()->velocity(Vec3(1.3, 0.7, 2), 0, v), SampleStatus::ok);
    EXPECT_LT(glm::length(v - Vec3(2.3, 2, -1)), 1e-6);
  }
}

TEST(UnitVdbVelocities, StaggeredVelocitiesOfOneLayerAreRefused) {
  auto grid = openvdb::Vec3SGrid::create();
  grid->setName("v");
  grid->setGridClass(openvdb::GRID_STAGGERED);
  grid->denseFill({{0, 0, 0}, {5, 5, 0}}, openvdb::Vec3s(1));
  EXPECT_THAT(refusal(grid, "magnitude"), HasSubstr("no voxel has both faces across every axis"));
  grid->sparseFill({{0, 0, 0}, {511, 511, 511}}, openvdb::Vec3s(1));  // 64 tiles of 128³
  EXPECT_THAT(refusal(grid, "magnitude"), HasSubstr("tiles of more than 2^24 voxels"));
}

TEST(UnitVdbVelocities, WhichGridIsTheVelocityIsAsked) {
  const auto refusal_of = [](const openvdb::GridPtrVec& grids, const std::string& velocity) {
    try {
      magnitudes(grids, velocity);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const openvdb::GridPtrVec both{vector_grid("Cd", 4, 1), vector_grid("wind", 4, 1)};
  EXPECT_THAT(refusal_of(both, ""), HasSubstr("vector grids: Cd, wind"));
  EXPECT_THAT(refusal_of(both, "vel"), HasSubstr("'vel': no such grid; vector grids: Cd, wind"));
  EXPECT_EQ(refusal_of(both, "wind"), "");
}

}  // namespace
}  // namespace pellucid::fields
