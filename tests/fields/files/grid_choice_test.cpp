// SPDX-License-Identifier: GPL-3.0-or-later
// Which grid of a file is meant, by names and types alone.
#include "fields/files/grid_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/error.h"

namespace pellucid::fields {
namespace {

using ::testing::HasSubstr;

GridEntry vector_grid(const std::string& name) { return {name, "vec3s", true}; }
GridEntry scalar_grid(const std::string& name) { return {name, "float", false}; }

template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(UnitGridChoice, EveryGridOfOneNameIsReachable) {
  const std::vector grids{scalar_grid("v"), vector_grid("v"), vector_grid("w"), vector_grid("v")};
  // Numbers count all grids of the name.
  EXPECT_EQ(choose_vector_grid(grids, "v[1]", "f"), 1u);
  EXPECT_EQ(choose_vector_grid(grids, "v[2]", "f"), 3u);
  EXPECT_EQ(choose_vector_grid(grids, "v", "f"), 1u);
  EXPECT_EQ(choose_vector_grid(grids, "w", "f"), 2u);
  const auto choose = [&](const char* name) {
    return refusal([&] { choose_vector_grid(grids, name, "f.vdb"); });
  };
  EXPECT_THAT(choose(""), HasSubstr("f.vdb: which grid? array=NAME; vector grids: v[1], w, v[2]"));
  for (const char* wrong : {"v[0]", "v[3]", "w[0]", "x"})
    EXPECT_THAT(choose(wrong), HasSubstr("no such grid")) << wrong;
}

TEST(UnitGridChoice, ANameThatLooksLikeANumberIsAName) {
  const std::vector grids{vector_grid("v"), vector_grid("v"), vector_grid("v[7]")};
  EXPECT_EQ(choose_vector_grid(grids, "v[7]", "f"), 2u);
}

TEST(UnitGridChoice, TheOnlyVectorGridNeedsNoName) {
  EXPECT_EQ(choose_vector_grid(std::vector{scalar_grid("p"), vector_grid("Cd")}, "", "f"), 1u);
  EXPECT_EQ(choose_velocity(std::vector{scalar_grid("p"), vector_grid("Cd")}, "", "f"), "Cd");
}

TEST(UnitGridChoice, ComponentsOfTheirOwnAreNamed) {
  const std::vector grids{scalar_grid("vel.x"), scalar_grid("vel.y")};
  EXPECT_THAT(refusal([&] { choose_vector_grid(grids, "", "f"); }),
              HasSubstr("vector grids: none; others: vel.x (float), vel.y (float)"));
}

TEST(UnitGridChoice, TheVelocityHasAUsualName) {
  const auto choose = [](const std::vector<GridEntry>& grids) {
    return choose_velocity(grids, "", "f");
  };
  for (const char* usual : {"vel", "velocity", "Velocity", "v", "U"})
    EXPECT_EQ(choose({vector_grid("Cd"), vector_grid(usual), vector_grid("N")}), usual);
  EXPECT_THROW(choose({vector_grid("Cd"), vector_grid("N")}), InputError);
  EXPECT_THROW(choose({vector_grid("vel"), vector_grid("v")}), InputError);
  EXPECT_THROW(choose({scalar_grid("vel")}), InputError);
}

}  // namespace
}  // namespace pellucid::fields
