// SPDX-License-Identifier: GPL-3.0-or-later
// Path surfaces of unsteady flows that turn, stop and come back, against their closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fields/make_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

struct PathSurface {
  std::string name, field;
  std::function<Vec3(const Vec3& seed, double t)> flow_map;
  double duration;
};

std::ostream& operator<<(std::ostream& out, const PathSurface& form) { return out << form.name; }

Vec3 pulse(const Vec3& x, double t) {
  return {x.x * std::exp(std::sin(t)), x.y * std::exp(-std::sin(t)), x.z};
}

Vec3 drift(const Vec3& x, double t) { return x + Vec3(std::sin(t), 1 - std::cos(t), 0); }

std::vector<PathSurface> path_surfaces() {
  return {{"PulseBeforeItTurns", "pulsing-saddle", pulse, 1.2},
          {"PulseThereAndBack", "pulsing-saddle", pulse, 3},
          {"PulsePeriod", "pulsing-saddle", pulse, 6},
          {"DriftHalfCircle", "drift", drift, 3},
          {"DriftOnceAroundAndOn", "drift", drift, 7}};
}

struct Segment {
  Vec3 from, to;
};

constexpr Segment seeds[] = {{{0.2, 1, 0}, {1, 1, 0.3}}, {{-0.5, 0.7, 0}, {0.6, 1.1, 1}}};

/// The area of a fine grid over (s, t): of second order, and here right to 1e-5 of itself.
double closed_form_area(const PathSurface& form, const Segment& seed) {
  constexpr int columns = 200, rows = 2000;
  const auto at = [&](int i, int j) {
    return form.flow_map(seed.from + double(i) / columns * (seed.to - seed.from),
                         form.duration * j / rows);
  };
  double twice = 0;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      twice += glm::length(glm::cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j)));
  return 0.5 * twice;
}

class PropertyPathSurfaces : public ::testing::TestWithParam<PathSurface> {};

INSTANTIATE_TEST_SUITE_P(ClosedForms, PropertyPathSurfaces, ::testing::ValuesIn(path_surfaces()),
                         [](const auto& form) { return form.param.name; });

/// A mesh within d of a surface of some units' length and width is short by slopes of some √d at
/// most, squared, and by strips d wide where it comes back; 10 d of the area leaves room for both.
TEST_P(PropertyPathSurfaces, AreOneSheetOfTheClosedFormsArea) {
  struct Call {
    const char* integrator;
    double relative;
  };
  constexpr Call calls[] = {{"fixed-front:particles=100,rows=400", 2e-3},
                            {"adaptive-front:particles=2,tolerance=1e-3", 1e-2},
                            {"adaptive-front:particles=2,threshold=0.05", 1e-2},
                            {"hultquist:tolerance=1e-2", 1e-1},
                            {"hultquist:tolerance=1e-3", 1e-2},
                            {"hultquist:threshold=0.05", 1e-2}};
  const auto field = fields::make_field(GetParam().field);
  for (const Segment& seed : seeds)
    for (const auto& [integrator, relative] : calls) {
      SurfaceRequest request;
      request.field = field.get();
      request.seed = segment_seed(seed.from, seed.to);
      request.duration = GetParam().duration;
      request.path = true;
      const auto surface = integrate_surface(integrator, request);
      const MeshQuality quality = measure_quality(surface.mesh);
      const double right = closed_form_area(GetParam(), seed);
      EXPECT_NEAR(testing::area_of(surface.mesh), right, relative * right) << integrator;
      EXPECT_EQ(quality.sheets, 1u) << integrator;
      EXPECT_EQ(quality.non_manifold_vertices, 0u) << integrator;
      EXPECT_EQ(surface.stats.ends.count(EndReason::torn), 0u) << integrator;
    }
}

/// Particles part along the wall at which the gyres meet, and come together elsewhere: the seeds
/// beside each other there are 1e-4 apart, what they sweep is 3 % of the area. Right is what 4000
/// seeds and 2000 steps of RK4 sweep, which 8000 and 1000 change by 2e-5 of it; the largest
/// tolerance here leaves 0.6 % out along the outlines.
TEST(UnitPathSurfaces, ADoubleGyreIsOneSheet) {
  const auto field = fields::make_field("double-gyre");
  SurfaceRequest request;
  request.field = field.get();
  request.seed = segment_seed({0.2, 0.5, 0}, {1.8, 0.5, 0});
  request.duration = 10;
  request.path = true;
  for (const char* integrator :
       {"hultquist:tolerance=3e-2", "hultquist:tolerance=1e-2", "hultquist:tolerance=1e-3",
        "adaptive-front:tolerance=1e-2", "adaptive-front:tolerance=1e-3"}) {
    const auto surface = integrate_surface(integrator, request);
    EXPECT_EQ(measure_quality(surface.mesh).sheets, 1u) << integrator;
    EXPECT_EQ(surface.stats.ends.count(EndReason::torn), 0u) << integrator;
    EXPECT_NEAR(testing::area_of(surface.mesh), 6.6058, 0.01 * 6.6058) << integrator;
  }
}

}  // namespace
}  // namespace pellucid::integrators
