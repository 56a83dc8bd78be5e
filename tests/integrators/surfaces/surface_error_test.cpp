// SPDX-License-Identifier: GPL-3.0-or-later
// The measure of error where the surface has no two tangents: at rest, on an axis, at a fold. The
// meshes lie in a plane that the surface fills, so that nothing is off.
#include "integrators/surfaces/surface_error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "fields/make_field.h"
#include "integrators/surfaces/integrate_surface.h"

namespace pellucid::integrators {
namespace {

constexpr double pi = std::numbers::pi;

struct Flat {
  const char *field, *integrator;
  Vec3 to;  // from the origin
  double duration;
  bool path;
};

constexpr Flat flats[] = {
    {"u=t,v=0,w=0", "adaptive-front:particles=9,tolerance=1e-3", {0, 0, 1}, 2, true},
    {"u=t,v=0,w=0", "fixed-front:particles=5,rows=1", {0, 0, 1}, 2, true},
    {"u=cos(t),v=0,w=0", "fixed-front:particles=9,rows=7", {0, 0, 1}, pi, true},
    {"u=cos(t),v=0,w=0", "hultquist:threshold=0.1,facet-angle=180", {0, 0, 1}, pi, true},
    {"u=max(0,t-1),v=0,w=0", "fixed-front:particles=9,rows=7", {0, 0, 1}, 2, true},
    {"u=-y,v=x,w=0", "hultquist:threshold=0.1", {2, 0, 0}, 2 * pi, false}};

TEST(UnitSurfaceError, WhatLiesInItsSurfaceIsNotOff) {
  for (const auto& [velocity, integrator, to, duration, path] : flats) {
    const auto field = fields::make_field(std::string("formula:") + velocity);
    const SurfaceRequest request{field.get(), segment_seed({0, 0, 0}, to), duration, 0, path, {}};
    const auto surface = integrate_surface(integrator, request);
    // Two trajectories of some units' length, each right to 1e-9 of it.
    EXPECT_LE(measure_error(surface.mesh, request, 300).max, 1e-8) << velocity << ' ' << integrator;
  }
}

/// A prism of 8 sides in a cylinder of radius 1, swept from rest: each side's middle is off by its
/// sagitta, 1 - cos(π / 8), and on the seed circle, where all particles rest, no less.
TEST(UnitSurfaceError, WhatIsOffIsSoFromRestToo) {
  const auto field = fields::make_field("formula:u=0,v=0,w=t");
  const SurfaceRequest request{field.get(), circle_seed({0, 0, 0}, {0, 0, 1}, 1), 2, 0, true, {}};
  const auto surface = integrate_surface("fixed-front:particles=8,rows=1", request);
  EXPECT_NEAR(measure_error(surface.mesh, request, 1000).max, 1 - std::cos(pi / 8), 1e-8);
}

/// The same prism: its facets turn by a sixteenth of a turn between their middles and their sides.
TEST(UnitSurfaceError, UnitsDoNotMatter) {
  for (const double unit : {1e-100, 1., 1e100}) {
    const auto field = fields::make_field(fmt::format("formula:u=0,v=0,w={}*t", unit));
    const SeedCurve circle = circle_seed({0, 0, 0}, {0, 0, 1}, unit);
    const SurfaceRequest request{field.get(), circle, 2, 0, true, {}};
    const auto surface = integrate_surface("fixed-front:particles=8,rows=1", request);
    const SurfaceError error = measure_error(surface.mesh, request, 1000);
    const double sagitta = 1 - std::cos(pi / 8);
    EXPECT_NEAR(error.max / unit, sagitta, 1e-8) << unit;
    // One of 400 seeds is within a 400th of a turn, or some, of a side's middle.
    EXPECT_NEAR(error.max_from_surface / unit, sagitta, 1e-3) << unit;
    EXPECT_NEAR(error.normal_max_degrees, 22.5, 0.5) << unit;
    // Mean over a side of 1 - cos, the distance from the cylinder.
    const double a = std::sin(pi / 8), h = std::cos(pi / 8);
    EXPECT_NEAR(error.mean / unit, 1 - 0.5 * (1 + h * h / a * std::asinh(a / h)), 1e-3) << unit;
  }
}

/// A cylinder's normals are radial. Turned about its axis they are off by as much as they are
/// turned, and where one has none nothing is said of it.
TEST(UnitSurfaceError, NormalsOfVerticesAreHeldToTheSurfaceThere) {
  const auto field = fields::make_field("formula:u=0,v=0,w=1");
  const SurfaceRequest request{field.get(), circle_seed({0, 0, 0}, {0, 0, 1}, 2), 3, 0, false, {}};
  auto mesh = integrate_surface("fixed-front:particles=40,rows=3", request).mesh;
  EXPECT_LE(measure_error(mesh, request, 100).vertex_normal_max_degrees.value(), 1e-5);
  const double turn = 10 * pi / 180;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const Vec3 n = mesh.normals[i];
    const double side = i % 2 == 0 ? 1 : -1;
    mesh.normals[i] = side * Vec3(n.x * std::cos(turn) - n.y * std::sin(turn),
                                  n.x * std::sin(turn) + n.y * std::cos(turn), n.z);
  }
  mesh.normals[5] = Vec3(0);
  const SurfaceError error = measure_error(mesh, request, 100);
  EXPECT_NEAR(error.vertex_normal_max_degrees.value(), 10, 1e-5);
  EXPECT_NEAR(error.vertex_normal_mean_degrees.value(), 10, 1e-5);
  mesh.normals.clear();
  EXPECT_FALSE(measure_error(mesh, request, 100).vertex_normal_max_degrees);
}

/// Straight stream lines of one length make an exact mesh, and there is no surface beyond.
TEST(UnitSurfaceError, TheIntegratorsOwnLengthIsTheSurfacesEnd) {
  const auto field = fields::make_field("formula:u=1,v=0,w=0");
  const SurfaceRequest request{field.get(), segment_seed({0, 0, 0}, {0, 0, 1}), 3, 0, false, {}};
  for (const char* integrator : {"hultquist:tolerance=1e-4,length=1", "fixed-front:length=1"}) {
    const auto mesh = integrate_surface(integrator, request).mesh;
    const auto parameters = integrator_parameters(integrator);
    EXPECT_LE(measure_error(mesh, request, 100, parameters).max_from_surface, 1e-8) << integrator;
    // Without it what is up to 3 units away is missed, to the spacing of 16 points.
    EXPECT_GT(measure_error(mesh, request, 100).max_from_surface, 1.8) << integrator;
  }
}

/// Half of the seeds rest: their line is no surface.
TEST(UnitSurfaceError, WhatRestsForeverIsNotMissed) {
  const auto field = fields::make_field("formula:u=0,v=0,w=abs(x)+x");
  const SurfaceRequest request{field.get(), segment_seed({-1, 0, 0}, {1, 0, 0}), 1, 0, false, {}};
  const auto mesh = integrate_surface("hultquist:tolerance=1e-3", request).mesh;
  EXPECT_LE(measure_error(mesh, request, 100).max_from_surface, 1e-3);
}

/// All velocities lie in the plane of the seeds, and with them the mesh: a sheared sheet, on which
/// a search from one place ends 0.15 away.
TEST(UnitSurfaceError, ASmallestDistanceAroundIsNotTheSmallest) {
  const auto field = fields::make_field("hill");
  const SurfaceRequest request{field.get(), segment_seed({0, 0.3, 0}, {0, 0.9, 0}), 6, 0, false,
                               {}};
  const auto surface = integrate_surface("hultquist:tolerance=2e-2,facet-angle=180", request);
  EXPECT_LE(measure_error(surface.mesh, request, 200).max, 1e-8);
}

}  // namespace
}  // namespace pellucid::integrators
