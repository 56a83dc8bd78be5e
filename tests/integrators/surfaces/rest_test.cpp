// SPDX-License-Identifier: GPL-3.0-or-later
// Path surfaces whose particles set off from rest, rest on their way, or turn back: flat sheets
// whose areas are known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "fields/make_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

const char* const all[] = {"hultquist:tolerance=1e-3", "hultquist:threshold=0.1",
                           "adaptive-front:particles=9,tolerance=1e-3",
                           "adaptive-front:particles=9,threshold=0.1",
                           "fixed-front:particles=17,rows=50"};

/// From the z axis between 0 and 1, for two units of time.
IntegratedSurface rest_sweep(const std::string& velocity, std::string_view integrator) {
  const auto field = fields::make_field("formula:" + velocity);
  SurfaceRequest request;
  request.field = field.get();
  request.seed = segment_seed({0, 0, 0}, {0, 0, 1});
  request.duration = 2;
  request.path = true;
  return integrate_surface(integrator, request);
}

struct Sheet {
  const char* velocity;
  double area;
  double relative;
};

/// Along x alone the sheet is flat, and its edge at the end is straight, or is followed to within
/// the tolerance.
constexpr Sheet sheets[] = {{"u=max(0,z-0.5)+t,v=0,w=0", 2.25, 1e-3},
                            {"u=t+z,v=0,w=0", 3, 1e-6},
                            {"u=t,v=0,w=0", 2, 1e-6},
                            {"u=1e-12+t,v=0,w=0", 2, 1e-6},
                            {"u=sin(t),v=0,w=0", 1.4161468365471424, 1e-6},
                            {"u=t*t,v=0,w=0", 8. / 3, 1e-6},
                            {"u=max(0,t-1),v=0,w=0", 0.5, 1e-6},
                            {"u=(t<1)?0:1,v=0,w=0", 1, 1e-6},
                            {"u=(t<1)?1:0,v=0,w=0", 1, 1e-6},
                            {"u=t*(1+z),v=0,w=0", 3, 1e-6}};

TEST(UnitRest, SheetsOfParticlesThatSetOffFromRestAreWhole) {
  for (const auto& [velocity, area, relative] : sheets)
    for (const char* integrator : all) {
      const auto surface = rest_sweep(velocity, integrator);
      const MeshQuality quality = measure_quality(surface.mesh);
      EXPECT_NEAR(testing::area_of(surface.mesh), area, relative * area)
          << velocity << ' ' << integrator;
      EXPECT_EQ(quality.sheets, 1u) << velocity << ' ' << integrator;
      EXPECT_EQ(quality.degenerate_triangles, 0u) << velocity << ' ' << integrator;
      EXPECT_EQ(quality.duplicate_vertices, 0u) << velocity << ' ' << integrator;
      EXPECT_LE(surface.mesh.triangles.size(), 10'000u) << velocity << ' ' << integrator;
    }
}

/// Four periods of 0.5: ∫ |v| dt = 4 / π. Every turn may cost a row what the tolerance lets pass,
/// 1e-3 each, and by threshold or fixed rows what lies between two of them. Facets that lie on
/// others are not mended, which takes time.
TEST(UnitRest, ThereAndBackIsSweptEachTime) {
  for (const char* velocity : {"u=sin(4*pi*t),v=0,w=0", "u=cos(4*pi*t),v=0,w=0"})
    for (const char* integrator :
         {"hultquist:tolerance=1e-3,facet-angle=180", "hultquist:threshold=0.04,facet-angle=180",
          "adaptive-front:particles=9,tolerance=1e-3,facet-angle=180",
          "adaptive-front:particles=9,threshold=0.04,facet-angle=180",
          "fixed-front:particles=17,rows=50"})
      EXPECT_NEAR(testing::area_of(rest_sweep(velocity, integrator).mesh), 4 / 3.14159265, 0.016)
          << velocity << ' ' << integrator;
}

/// Mending splits edges between particles that rest, but makes no lines of them.
TEST(UnitRest, APulseLeavesNoTriangleWithoutAnArea) {
  const auto field = fields::make_field("formula:u=0,v=0,w=exp(-((t-1.5)/0.05)^2)");
  const SurfaceRequest request{field.get(), segment_seed({0, 0, 0}, {1, 0, 0}), 3, 0, true, {}};
  for (const char* integrator : {"hultquist:tolerance=1e-3", "adaptive-front:tolerance=1e-3"}) {
    const auto surface = integrate_surface(integrator, request);
    const MeshQuality quality = measure_quality(surface.mesh);
    EXPECT_EQ(quality.degenerate_triangles, 0u) << integrator;
    // 0.05 √π; where the pulse sets in, ribbons overlap by up to two thousandths of it.
    EXPECT_NEAR(testing::area_of(surface.mesh), 0.088622692545, 2e-4) << integrator;
  }
}

/// Particles that follow each other sweep no area, whatever a curve's triangles have.
TEST(UnitRest, NoSurfaceComesOfAStreamLine) {
  const auto straight = fields::make_field("shear:b=1"), round = fields::make_field("rotation:c=0");
  const SurfaceRequest requests[] = {
      {straight.get(), segment_seed({0, 1, 0}, {1, 1, 0}), 1, 0, false, {}},
      {round.get(), circle_seed({0, 0, 0}, {0, 0, 1}, 0.5), 3, 0, false, {}}};
  for (const IntegratorRow& row : integrators())
    for (const SurfaceRequest& request : requests) try {
        integrate_surface(row.name, request);
        ADD_FAILURE() << row.name;
      } catch (const InputError& error) {
        EXPECT_NE(std::string_view(error.what()).find("run along the flow"), std::string::npos)
            << error.what();
      }
}

}  // namespace
}  // namespace pellucid::integrators
