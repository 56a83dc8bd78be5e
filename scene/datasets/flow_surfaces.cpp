// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include "fields/make_field.h"
#include "integrators/surfaces/integrate_surface.h"
#include "scene/datasets/flow_quantity.h"
#include "scene/datasets/stand_in.h"

namespace pellucid::scene {
namespace {

struct FlowSurfaces {
  std::size_t count;  // surfaces by default
  std::string_view field;
  double duration;
  ImportantShares shares;  // of the vorticity
  integrators::SeedCurve (*seed)(const IndexedRandom&);
};

/// A horizontal rake that reaches across the funnel.
integrators::SeedCurve rake_of_tornado(const IndexedRandom& random) {
  const double z = random.uniform(0, 0.08, 0.6), phi = random.uniform(1, 0, std::numbers::pi);
  const Vec3 middle(0.5, 0.5, z),
      half = random.uniform(2, 0.15, 0.32) * Vec3(std::cos(phi), std::sin(phi), 0);
  return integrators::segment_seed(middle - half, middle + half);
}

/// A rake along one of the vortices, near its core or on the way around it.
integrators::SeedCurve rake_of_wing(const IndexedRandom& random) {
  const double side = random.uniform(0) < 0.5 ? -1 : 1, off = random.uniform(1, -0.05, 0.25);
  const double from = random.uniform(2, 0.05, 0.3), lift = random.uniform(3, -0.05, 0.15);
  const auto beside_core = [&](double x) {
    return Vec3(x, side * (0.35 * x + off), 0.12 * x + lift);  // the field's b and h
  };
  return integrators::segment_seed(beside_core(from), beside_core(from + 0.8));
}

constexpr FlowSurfaces tornado{8, "tornado", 8, {.none = 0.5, .full = 0.95}, rake_of_tornado};
constexpr FlowSurfaces delta_wing{16, "delta-wing", 2.5, {.none = 0.5, .full = 0.85}, rake_of_wing};

void append(const geometry::TriangleMesh& part, geometry::TriangleMesh& whole) {
  const auto base = std::uint32_t(whole.positions.size());
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
  for (const auto& [a, b, c] : part.triangles)
    whole.triangles.push_back({base + a, base + b, base + c});
}

template <const FlowSurfaces& set>
struct FlowSurfacesOptions {
  static constexpr std::string_view unit = "surfaces";
  std::size_t count = set.count;
  std::uint64_t seed = 1;
};

template <const FlowSurfaces& set>
Dataset make(const Parameters& parameters, const Progress& progress) {
  const FlowSurfacesOptions<set> options =
      stand_in_options<FlowSurfacesOptions<set>>().read(parameters);
  const auto field = fields::make_field(set.field);
  const auto seeds = make_elements(options.count, options.seed, set.seed);
  geometry::TriangleMesh mesh;
  for (const integrators::SeedCurve& seed : seeds) {
    const integrators::SurfaceRequest request{
        .field = field.get(), .seed = seed, .duration = set.duration, .progress = progress};
    append(integrators::integrate_surface("hultquist:threshold=0.02,accuracy=1e-6", request).mesh,
           mesh);
  }
  set_importance("vorticity", measure_flow(FlowQuantity::vorticity, *field, mesh.positions),
                 set.shares, mesh);
  return mesh;
}

}  // namespace

// Each row makes stream surfaces of a flow, of random seed curves: in place of the surface data of
// Baeza Rojo et al. 2019, Figs. 7 and 8.
const DatasetRow& tornado_dataset() {
  static const DatasetRow row{"tornado", "Stream surfaces of the Crawfis tornado",
                              "R. A. Crawfis, The Ohio State University; field: tornado",
                              stand_in_options<FlowSurfacesOptions<tornado>>().specs(),
                              make<tornado>};
  return row;
}

const DatasetRow& delta_wing_dataset() {
  static const DatasetRow row{
      "delta-wing", "Stream surfaces of leading-edge vortices (stand-in: a model flow)",
      "in place of M. Ruetten's simulation; field: delta-wing",
      stand_in_options<FlowSurfacesOptions<delta_wing>>().specs(), make<delta_wing>};
  return row;
}

}  // namespace pellucid::scene
