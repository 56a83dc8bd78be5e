// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_options.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "fields/make_field.h"
#include "integrators/front/refinement.h"
#include "integrators/front/surface_particles.h"
#include "integrators/surfaces/integrate_surface.h"

namespace pellucid::integrators {
namespace {

template <class Options>
Options read(const OptionTable<Options>& table, std::string_view given) {
  return table.read(Parameters("surface", table.specs(), parse_name_and_options(given).options));
}

SurfaceSetup setup_of(std::string_view given) {
  const auto field = fields::make_field("rotation");
  const SurfaceRequest request{.field = field.get(),
                               .seed = segment_seed({1, 0, 0}, {3, 0, 0}),
                               .duration = 2,
                               .progress = {}};
  return surface_setup(request, read(surface_options(), given));
}

TEST(UnitSurfaceOptions, TheSecondParticleFollowsBothOptions) {
  EXPECT_EQ(setup_of("surface").trajectory.companion, Companion::variation);
  EXPECT_EQ(setup_of("surface:normals=none").trajectory.companion, Companion::none);
  EXPECT_EQ(setup_of("surface:normals=ghost").trajectory.companion, Companion::ghost_reset);
  EXPECT_EQ(setup_of("surface:normals=ghost,ghost=rescale").trajectory.companion,
            Companion::ghost_rescaled);
}

TEST(UnitSurfaceOptions, WhatIsNotGivenFollowsFromTheRequest) {
  const SurfaceSetup adaptive = setup_of("surface");
  EXPECT_EQ(adaptive.extent, 2);                          // the segment's length
  EXPECT_DOUBLE_EQ(adaptive.trajectory.tolerance, 2e-9);  // a billionth of it
  EXPECT_EQ(adaptive.trajectory.max_step, 2);             // the duration
  EXPECT_EQ(setup_of("surface:stepper=rk4").trajectory.max_step, 2. / 500);
  EXPECT_EQ(setup_of("surface:stepper=rk4").trajectory.stepper->name, "rk4");
}

TEST(UnitSurfaceOptions, WhatIsGivenReachesTheSetup) {
  const SurfaceSetup setup = setup_of(
      "surface:rip=0.25,max-particles=7,max-triangles=8,accuracy=1e-3,dt=0.5,length=4,max-steps=9");
  EXPECT_EQ(setup.rip, 0.25);
  EXPECT_EQ(setup.max_particles, 7u);
  EXPECT_EQ(setup.max_triangles, 8u);
  EXPECT_EQ(setup.trajectory.tolerance, 1e-3);
  EXPECT_EQ(setup.trajectory.max_step, 0.5);
  EXPECT_EQ(setup.trajectory.max_length, 4);
  EXPECT_EQ(setup.trajectory.max_steps, 9u);
  EXPECT_THROW(setup_of("surface:dt=0"), InputError);
}

Refinement refinement(std::string_view given) {
  return refinement_of(read(refinement_options(0.5), given), 0.5, 5);
}

TEST(UnitRefinementOptions, AToleranceTakesTheThresholdsPlace) {
  EXPECT_EQ(refinement("row").threshold, 0.5);
  EXPECT_EQ(refinement("row").step, 0.5 / 5);
  EXPECT_EQ(refinement("row:threshold=2").step, 2. / 5);
  EXPECT_EQ(refinement("row:tolerance=0.1").threshold, 0);
  EXPECT_EQ(refinement("row:tolerance=0.1").step, 0);
  EXPECT_EQ(refinement("row:tolerance=0.1,step=3").step, 3);
  EXPECT_THROW(refinement("row:tolerance=0.1,threshold=2"), InputError);
  EXPECT_THROW(refinement("row:tolerance=0"), InputError);
}

TEST(UnitSurfaceOptions, WhatWouldChangeNothingIsRefused) {
  EXPECT_THROW(setup_of("surface:ghost=rescale"), InputError);
  EXPECT_THROW(setup_of("surface:accuracy=1e-9,stepper=rk4"), InputError);
  EXPECT_THROW(setup_of("surface:cells=0.5"), InputError);
  const auto field = fields::make_field("rotation");
  const SurfaceRequest request{.field = field.get(),
                               .seed = segment_seed({1, 0, 0}, {3, 0, 0}),
                               .duration = 2,
                               .progress = {}};
  EXPECT_THROW(integrate_surface("hultquist:tolerance=1e-3,stepper=rk4", request), InputError);
  EXPECT_NO_THROW(integrate_surface("hultquist:threshold=0.1,stepper=rk4", request));
}

/// The tolerance's own steps bind as before where the given one is longer, and it where it is not.
TEST(UnitSurfaceOptions, AStepBesideAToleranceAddsToIt) {
  const auto field = fields::make_field("rotation");
  const SurfaceRequest request{.field = field.get(),
                               .seed = segment_seed({1, 0, 0}, {1.5, 0, 0}),
                               .duration = 5,
                               .progress = {}};
  for (const std::string name : {"hultquist", "adaptive-front"}) {
    const auto own = integrate_surface(name + ":tolerance=1e-3", request);
    const auto longer = integrate_surface(name + ":tolerance=1e-3,step=1", request);
    EXPECT_EQ(longer.mesh.triangles, own.mesh.triangles) << name;
    const auto shorter = integrate_surface(name + ":tolerance=1e-3,step=0.02", request);
    for (const auto& [a, b, c] : shorter.mesh.triangles) {
      const auto& s = shorter.mesh.scalars.at("s");
      const auto& x = shorter.mesh.positions;
      const bool one_particle = s[a] == s[b];
      EXPECT_TRUE(!one_particle || glm::distance(x[a], x[b]) <= 1.3 * 0.02) << name;
    }
  }
}

}  // namespace
}  // namespace pellucid::integrators
