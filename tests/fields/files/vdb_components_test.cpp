// SPDX-License-Identifier: GPL-3.0-or-later
// A velocity of which each component is a grid of its own.
#include <gmock/gmock.h>
#include <openvdb/openvdb.h>

#include "core/error.h"
#include "fields/make_field.h"
#include "fields/readers/attributes.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {
namespace {

using ::testing::HasSubstr;

Vec3 skew(const Vec3& x) { return {1 + x.y, x.x - x.z, 2 * x.z}; }

class UnitVdbComponents : public ::testing::Test {
 protected:
  UnitVdbComponents() { openvdb::initialize(); }

  /// Of 6³ voxels from the origin on.
  template <class Grid>
  static typename Grid::Ptr component(int axis, double spacing = 0.5, int count = 6) {
    auto grid = Grid::create(0);
    for (int k = 0; k < count; ++k)
      for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i)
          grid->tree().setValueOn({i, j, k},
                                  typename Grid::ValueType(skew(spacing * Vec3(i, j, k))[axis]));
    grid->setName(std::string("vel.") + "xyz"[axis]);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(spacing));
    return grid;
  }
  std::unique_ptr<VectorField> read(const openvdb::GridPtrVec& grids, const std::string& options) {
    openvdb::io::File((folder_ / "v.vdb").string()).write(grids);
    return make_field((folder_ / "v.vdb").string() + options);
  }
  std::string complaint(const openvdb::GridPtrVec& grids, const std::string& options) {
    try {
      read(grids, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  TemporaryFolder folder_;
};

using openvdb::DoubleGrid;
using openvdb::FloatGrid;

TEST_F(UnitVdbComponents, ThreeGridsAreOneVelocity) {
  const Vec3 x(0.7, 1.1, 2.3), v = skew(x);
  const auto field =
      read({component<FloatGrid>(2), component<FloatGrid>(0), component<FloatGrid>(1)},
           ":array=vel.x,vel.y,vel.z");
  EXPECT_NEAR_VEC(velocity_of(*field, x), v, 1e-6);  // of floats
  EXPECT_THAT(field->description(), HasSubstr("216 active voxels of vel.x,vel.y,vel.z"));
  const openvdb::GridPtrVec doubles{component<DoubleGrid>(0), component<DoubleGrid>(1),
                                    component<DoubleGrid>(2)};
  EXPECT_NEAR_VEC(velocity_of(*read(doubles, ":array=vel.x,vel.y,vel.z"), x), v, 1e-13);
  EXPECT_NEAR_VEC(velocity_of(*read(doubles, ":array=vel.z,vel.x,vel.y,sampler=c1"), x),
                  Vec3(v.z, v.x, v.y), 1e-13);
}

/// As OpenVDB makes them of arrays: v_y = x - z is 0 on a plane.
TEST_F(UnitVdbComponents, ValuesOfTheBackgroundCountWhereOthersAreActive) {
  const auto y = component<FloatGrid>(1);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) y->tree().setValueOff({i, j, i});
  const auto field =
      read({component<FloatGrid>(0), y, component<FloatGrid>(2)}, ":array=vel.x,vel.y,vel.z");
  EXPECT_NEAR_VEC(velocity_of(*field, {1.2, 0.7, 1.2}), skew({1.2, 0.7, 1.2}), 1e-6);
  EXPECT_EQ(status_at(*field, Vec3(2.6)), SampleStatus::outside);
}

/// A tile of one grid that another one divides.
TEST_F(UnitVdbComponents, TilesAreDividedWhereOthersAre) {
  auto constant = FloatGrid::create(0);
  constant->tree().addTile(1, {0, 0, 0}, 7, true);
  constant->setName("vel.x");
  constant->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
  for (const bool is_first : {true, false}) {
    openvdb::GridPtrVec grids{component<FloatGrid>(1), component<FloatGrid>(2)};
    grids.insert(is_first ? grids.begin() : grids.end(), constant);
    const auto field =
        read(grids, is_first ? ":array=vel.x,vel.y,vel.z" : ":array=vel.y,vel.z,vel.x");
    const Vec3 v = skew(Vec3(1.2));
    EXPECT_NEAR_VEC(velocity_of(*field, Vec3(1.2)),
                    is_first ? Vec3(7, v.y, v.z) : Vec3(v.y, v.z, 7), 1e-6);
    EXPECT_NEAR_VEC(velocity_of(*field, Vec3(3.2)), is_first ? Vec3(7, 0, 0) : Vec3(0, 0, 7), 1e-6);
  }
}

TEST_F(UnitVdbComponents, WhatDoesNotFitIsRefused) {
  const auto x = component<FloatGrid>(0), y = component<FloatGrid>(1), z = component<FloatGrid>(2);
  EXPECT_THAT(complaint({x, y, z}, ""), HasSubstr("array=A,B,C takes three of float or double"));
  EXPECT_THAT(complaint({x, y, z}, ":array=vel.x,vel.y,vel.w"), HasSubstr("no such grid"));
  EXPECT_THAT(complaint({x, y, component<DoubleGrid>(2)}, ":array=vel.x,vel.y,vel.z"),
              HasSubstr("of float, float and double; accepted: three of float or three of double"));
  EXPECT_THAT(complaint({x, y, component<FloatGrid>(2, 0.25)}, ":array=vel.x,vel.y,vel.z"),
              HasSubstr("'vel.x' and 'vel.z' have different transforms"));
}

TEST_F(UnitVdbComponents, OneGridIsAScalar) {
  openvdb::io::File((folder_ / "v.vdb").string())
      .write(openvdb::GridPtrVec{component<FloatGrid>(0), component<DoubleGrid>(1)});
  const std::string file = (folder_ / "v.vdb").string();
  const Vec3 x(0.7, 1.1, 2.3), v = skew(x);
  const Attributes both(file, {}, std::vector<std::string>{"vel.x", "vel.y"});
  EXPECT_NEAR(both.values(0, std::vector{x}, std::vector{0.}).front(), v.x, 1e-6);  // of floats
  EXPECT_NEAR(both.values(1, std::vector{x}, std::vector{0.}).front(), v.y, 1e-12);
  EXPECT_THAT([&] { Attributes(file, {}, std::vector<std::string>{"p"}); },
              ::testing::ThrowsMessage<InputError>(
                  HasSubstr("no scalar 'p'; accepted: a grid of float or double; grids: vel.x")));
}

}  // namespace
}  // namespace pellucid::fields
