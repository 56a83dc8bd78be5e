// SPDX-License-Identifier: GPL-3.0-or-later
// Streak and time surfaces against their closed forms: facets by the surface's equation, normals,
// and the measure of error.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "fields/make_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_error.h"
#include "tests/integrators/closed_forms.h"
#include "tests/integrators/sheets/sheet_requests.h"

namespace pellucid::integrators {
namespace {

using testing::ClosedForm;
using testing::streak_of;
using testing::time_surface_of;

/// Implicit surfaces at the end of the journey.
struct SheetForm {
  ClosedForm form;
  std::function<SheetRequest(const fields::VectorField&)> request;
  std::string integrator;
};

std::ostream& operator<<(std::ostream& out, const SheetForm& form) { return out << form.form; }

/// Particles that are let go at T - a from x arrive at x + (sin T - sin(T - a), cos(T - a) - cos T,
/// 0): on the unit circle about x + (sin T, -cos T, 0). Path lines lie on one about x + (0, 1, 0).
double streak_of_drift(const Vec3& x, double end) {
  return std::hypot(x.x - 0.3 * x.z - std::sin(end), x.y + std::cos(end)) - 1;
}

std::vector<SheetForm> sheet_forms() {
  constexpr double end = 1.7, stretch = 1.2;
  std::vector<SheetForm> forms;
  for (const ClosedForm& form : testing::closed_forms())
    if (!form.path)
      forms.push_back({form,
                       [=](const fields::VectorField& field) {
                         return streak_of(field, form.seed, form.duration);
                       },
                       "streak-surface"});
  forms.push_back({{"StreakOfDrift",
                    "drift",
                    {},
                    end,
                    true,
                    [](const Vec3& x) { return streak_of_drift(x, end); }},
                   [](const fields::VectorField& field) {
                     return streak_of(field, segment_seed({0, 0, 0}, {0.3, 0, 1}), end);
                   },
                   "streak-surface"});
  forms.push_back({{"StreakOfPulse", "pulsing-saddle", {}, end, true, testing::wave},
                   [](const fields::VectorField& field) {
                     return streak_of(field, testing::wave_seed(0.2, 1, 0.2, 3), 0.8, 0.7);
                   },
                   "streak-surface"});
  // x = X exp(sin T), y = Y exp(-sin T): the plane Z = X Y / 5 goes to itself, and a sphere becomes
  // an ellipsoid.
  const double factor = std::exp(std::sin(stretch));
  const auto pulse_sphere = [=](const Vec3& x) {
    return std::hypot(x.x / factor - 1, x.y * factor, x.z) - 0.5;
  };
  forms.push_back({{"SphereInPulse", "pulsing-saddle", {}, stretch, true, pulse_sphere},
                   [=](const fields::VectorField& field) {
                     return time_surface_of(field, sphere_seed({1, 0, 0}, 0.5), stretch);
                   },
                   "time-surface"});
  // A plane that goes up by x² in a unit of time.
  forms.push_back({{"PatchInShear",
                    "formula:u=0,v=0,w=x*x",
                    {},
                    1,
                    true,
                    [](const Vec3& x) { return x.z - x.x * x.x; }},
                   [](const fields::VectorField& field) {
                     return time_surface_of(field, patch_seed({-1, 0, 0}, {2, 0, 0}, {0, 1, 0}), 1);
                   },
                   "time-surface"});
  return forms;
}

class PropertySheets : public ::testing::TestWithParam<SheetForm> {};

TEST_P(PropertySheets, LieWithinTheToleranceOfTheirClosedForm) {
  const SheetForm& form = GetParam();
  const auto field = fields::make_field(form.form.field);
  const SheetRequest request = form.request(*field);
  for (const char* tolerance : {"1e-2", "1e-3"}) {
    const std::string call = form.integrator + ":particles=9,tolerance=" + tolerance;
    const IntegratedSheet sheet = integrate_sheet(call, request);
    EXPECT_LE(testing::largest_distance(form.form, sheet.mesh),
              std::stod(tolerance) + testing::trajectory_error)
        << call;
    const MeshQuality quality = measure_quality(sheet.mesh);
    EXPECT_TRUE(quality.manifold) << call;
    EXPECT_EQ(quality.sheets, 1u) << call;
    EXPECT_LE(testing::worst_facet(form.form, sheet.mesh), 30) << call;
  }
}

/// The normal that goes with the flow is that of the surface's equation, to 1e-6 of the variational
/// equation's own tolerance, some tens of steps of it.
TEST_P(PropertySheets, NormalsAreThoseOfTheClosedForm) {
  const SheetForm& form = GetParam();
  const auto field = fields::make_field(form.form.field);
  const IntegratedSheet sheet = integrate_sheet(form.integrator, form.request(*field));
  const geometry::TriangleMesh& mesh = sheet.mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 wanted = glm::normalize(testing::gradient(form.form, mesh.positions[i]));
    EXPECT_NEAR(std::abs(glm::dot(mesh.normals[i], wanted)), 1, 1e-6) << i;
  }
  // One side of the mesh is the normals' side.
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 facet =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    EXPECT_GT(glm::dot(facet, mesh.normals[a]), 0);
  }
}

TEST_P(PropertySheets, TheMeasureOfErrorAgreesWithTheClosedForm) {
  const SheetForm& form = GetParam();
  const auto field = fields::make_field(form.form.field);
  const SheetRequest request = form.request(*field);
  const std::string call = form.integrator + ":particles=9,tolerance=1e-2";
  const IntegratedSheet sheet = integrate_sheet(call, request);
  const SurfaceError error =
      measure_sheet_error(sheet, request, 4 * sheet.mesh.triangles.size(), sheet_parameters(call));
  const double truth = testing::largest_distance(form.form, sheet.mesh);
  // The closed form goes on beyond the sheet, whose measure also counts where the mesh's border
  // leaves the sheet's. It is looked at in quarters of facets, the measure at the middles of facets
  // and sides and at places by lot.
  EXPECT_GE(error.max, 0.9 * truth - testing::trajectory_error);
  EXPECT_LE(error.max, 1e-2);
  EXPECT_LE(error.mean, error.rms);
  EXPECT_LE(error.rms, error.max);
  EXPECT_LE(error.max_from_surface, 1e-2);
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, PropertySheets, ::testing::ValuesIn(sheet_forms()),
                         [](const auto& of) { return of.param.form.name; });

}  // namespace
}  // namespace pellucid::integrators
