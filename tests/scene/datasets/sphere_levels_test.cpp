// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities on nested levels: how they nest, and what a file of them gives.

#include <gtest/gtest.h>

#include "core/error.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/vdb_levels.h"
#include "scene/datasets/dataset.h"
#include "tests/support/levels.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::scene {
namespace {

TEST(UnitSphereLevels, WrittenVelocitiesGiveTheSameScalars) {
  const testing::TemporaryFolder folder;
  const auto levels = make_velocity_levels("sphere-levels:levels=2,rings=2");
  fields::write_vdb_levels(folder / "v.vdb", "velocity",
                           std::span<const fields::VectorLevel>(levels));
  for (const char* scalar : {"q", "magnitude", "speed"}) {
    const auto expected = fields::scalars_of(levels, scalar);
    const auto read = testing::read_float_levels(folder / "v.vdb", scalar);
    ASSERT_EQ(read.size(), expected.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].width, expected[i].width);
      EXPECT_EQ(read[i].samples, expected[i].samples);
    }
  }
}

TEST(UnitSphereLevels, AreNested) {
  const auto levels = make_velocity_levels("sphere-levels");
  ASSERT_EQ(levels.size(), 4u);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_EQ(levels[i].width, levels[i - 1].width / 2);
    const Box3 outer = levels[i - 1].box(0.5), inner = levels[i].box(0.5);
    EXPECT_TRUE(outer.contains(inner.min) && outer.contains(inner.max));
  }
  EXPECT_THROW(make_velocity_levels("sphere-levels:levels=5"), InputError);
  EXPECT_THROW(make_velocity_levels("cube-levels"), InputError);
  EXPECT_THROW(make_velocity_levels("stack"), InputError);
  EXPECT_THROW(make_velocity_levels("sphere-levels:rings=17"), InputError);
}

}  // namespace
}  // namespace pellucid::scene
