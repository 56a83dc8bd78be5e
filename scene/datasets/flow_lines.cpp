// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include <fmt/format.h>

#include "fields/make_field.h"
#include "integrators/lines/integrate_lines.h"
#include "scene/datasets/flow_quantity.h"
#include "scene/datasets/stand_in.h"

namespace pellucid::scene {
namespace {

/// A data set of this family: data.
struct FlowLines {
  std::size_t count;  // lines by default
  std::string_view field;
  std::string_view integrator;
  double duration;
  FlowQuantity quantity;
  std::string_view scalar;  // what the quantity is called
  ImportantShares shares;
  Vec3 (*seed)(const IndexedRandom&);
};

// A planet's winds on spheres, free of divergence: v = x × ∇ψ with jets towards the east in both
// hemispheres, ψ_z = 4z²(1 - z²) - 0.2 + 2bzh, and planetary waves of number five,
// ψ = b z² h(x, y) with h = Re (x + iy)^5.
constexpr std::string_view winds =
    "formula:u=y*(4*z^2*(1-z^2)-0.2+0.7*z*(x^5-10*x^3*y^2+5*x*y^4))"
    "-0.35*z^3*(20*x*y^3-20*x^3*y),"
    "v=0.35*z^3*(5*x^4-30*x^2*y^2+5*y^4)"
    "-x*(4*z^2*(1-z^2)-0.2+0.7*z*(x^5-10*x^3*y^2+5*x*y^4)),"
    "w=0.35*z^2*(x*(20*x*y^3-20*x^3*y)-y*(5*x^4-30*x^2*y^2+5*y^4))";

// A rotor of radius 1 in forward flight at a height of 1 above the ground, z = 0, in wind of speed
// 1: a Lamb-Oseen vortex of circulation g trails from either side, y = 1 and -1, and sinks; a
// vortex across the wind lies on the ground before the rotor; images below the ground keep the wind
// along it. With b = g / (2π) = 0.45 (1 + tanh 3x) and h = 0.95 - 0.06 x, each vortex adds b (1 -
// exp(-s / 0.02)) / s times the distances from its axis, s their squares' sum.
constexpr std::string_view forward_flight =
    "formula:u=1+0.35*exp(-y^4)*((z-0.35)*(1-exp(-((x+1.2)^2+(z-0.35)^2)/0.02))"
    "/((x+1.2)^2+(z-0.35)^2+1e-9)-(z+0.35)/((x+1.2)^2+(z+0.35)^2+1e-9)),"
    "v=0.45*(1+tanh(3*x))*(-(z-0.95+0.06*x)*(1-exp(-((y-1)^2+(z-0.95+0.06*x)^2)/0.02))"
    "/((y-1)^2+(z-0.95+0.06*x)^2+1e-9)"
    "+(z-0.95+0.06*x)*(1-exp(-((y+1)^2+(z-0.95+0.06*x)^2)/0.02))"
    "/((y+1)^2+(z-0.95+0.06*x)^2+1e-9)"
    "+(z+0.95-0.06*x)/((y-1)^2+(z+0.95-0.06*x)^2)"
    "-(z+0.95-0.06*x)/((y+1)^2+(z+0.95-0.06*x)^2)),"
    "w=-0.35*exp(-y^4)*((x+1.2)*(1-exp(-((x+1.2)^2+(z-0.35)^2)/0.02))"
    "/((x+1.2)^2+(z-0.35)^2+1e-9)-(x+1.2)/((x+1.2)^2+(z+0.35)^2+1e-9))"
    "+0.45*(1+tanh(3*x))*((y-1)*(1-exp(-((y-1)^2+(z-0.95+0.06*x)^2)/0.02))"
    "/((y-1)^2+(z-0.95+0.06*x)^2+1e-9)"
    "-(y+1)*(1-exp(-((y+1)^2+(z-0.95+0.06*x)^2)/0.02))"
    "/((y+1)^2+(z-0.95+0.06*x)^2+1e-9)"
    "-(y-1)/((y-1)^2+(z+0.95-0.06*x)^2)"
    "+(y+1)/((y+1)^2+(z+0.95-0.06*x)^2))";

/// Half of the lines start around the vortices, the others in the wind.
Vec3 around_rotor(const IndexedRandom& random) {
  const double kind = random.uniform(0, 0, 1);
  if (kind < 0.2)  // before the rotor
    return random.in_box(1, {Vec3(-1.5, -0.9, 0.1), Vec3(-0.9, 0.9, 0.6)});
  if (kind < 0.5)  // beside it
    return random.in_box(1, {Vec3(0, -0.12, -0.12), Vec3(0.4, 0.12, 0.12)}) +
           Vec3(0, kind < 0.35 ? -1 : 1, 0.95);
  return random.in_box(1, {Vec3(-2.5, -2, 0.05), Vec3(2.5, 2, 1.8)});
}

Vec3 on_shell(const IndexedRandom& random, double z_from, double phi_width) {
  const double z = random.uniform(0, z_from, 1), r = std::sqrt(1 - z * z);
  const double phi = random.uniform(1, -phi_width, phi_width);
  return random.uniform(2, 0.95, 1) * Vec3(r * std::cos(phi), r * std::sin(phi), z);
}

// Important are the stretches at the twelve atoms, where the paper's picture is red.
constexpr FlowLines benzene{32'000,
                            "benzene",
                            "stream-lines:turn=8,accuracy=1e-5,length=5,max-steps=120",
                            1e3,
                            FlowQuantity::nearness,
                            "nearness",
                            {.none = 0.6, .full = 0.9},
                            [](const IndexedRandom& random) {
                              return random.in_box(0, {Vec3(-3.5, -3.5, -2), Vec3(3.5, 3.5, 2)});
                            }};
constexpr FlowLines bfs{40'000,
                        "step",
                        "stream-lines:turn=6,accuracy=1e-5",
                        6,
                        FlowQuantity::vorticity,
                        "vorticity",
                        {.none = 0.7, .full = 0.97},
                        [](const IndexedRandom& random) {
                          return random.in_box(0, {Vec3(0.05, -0.98, 0.05), Vec3(11, 1.5, 5.95)});
                        }};
constexpr FlowLines trefoil{500,
                            "trefoil",
                            "stream-lines:turn=6,accuracy=1e-5,length=12",
                            1e3,
                            FlowQuantity::speed,
                            "strength",
                            {.none = 0.5, .full = 0.85},
                            [](const IndexedRandom& random) {
                              return random.in_box(0, {Vec3(-3, -3, -1.6), Vec3(3, 3, 1.6)});
                            }};
constexpr FlowLines helicopter{
    700,
    "rotor-wake",
    "stream-lines:turn=6,accuracy=1e-5,length=5",
    60,
    FlowQuantity::vorticity,
    "vorticity",
    {.none = 0.6, .full = 0.95},
    [](const IndexedRandom& random) {
      return random.in_box(0, {Vec3(-1.4, -1.4, -1.5), Vec3(1.4, 1.4, 0.3)});
    }};
constexpr FlowLines helicopter_forward{700,
                                       forward_flight,
                                       "stream-lines:turn=6,accuracy=1e-5,length=5",
                                       60,
                                       FlowQuantity::vorticity,
                                       "vorticity",
                                       {.none = 0.6, .full = 0.85},
                                       around_rotor};
// Lines of the funnel and of the air around it.
constexpr FlowLines tornado_lines{400,
                                  "tornado",
                                  "stream-lines:turn=5,accuracy=1e-5",
                                  30,
                                  FlowQuantity::vorticity,
                                  "vorticity",
                                  {.none = 0.5, .full = 0.95},
                                  [](const IndexedRandom& random) {
                                    return random.in_box(0, {Vec3(0.1, 0.1, 0.02), Vec3(0.9)});
                                  }};
constexpr FlowLines ecmwf{
    1500,
    winds,
    "stream-lines:turn=4,accuracy=1e-5",
    3,
    FlowQuantity::speed,
    "wind",
    {.none = 0.6, .full = 0.97},
    [](const IndexedRandom& random) { return on_shell(random, -1, std::numbers::pi); }};
constexpr FlowLines icon{11'500,
                         winds,
                         "stream-lines:turn=4,accuracy=1e-5",
                         0.8,
                         FlowQuantity::speed,
                         "wind",
                         {.none = 0.75, .full = 0.98},
                         [](const IndexedRandom& random) { return on_shell(random, 0.2, 0.9); }};

/// As many lines as are asked for, whole: their count is the data set's own bound.
geometry::LineSet all_lines(std::string_view integrator, const integrators::LineRequest& request) {
  return integrators::integrate_lines(fmt::format("{},max-vertices=10000000000", integrator),
                                      request)
      .lines;
}

template <const FlowLines& set>
struct FlowLinesOptions {
  static constexpr std::string_view unit = "lines";
  std::size_t count = set.count;
  std::uint64_t seed = 1;
};

template <const FlowLines& set>
Dataset make(const Parameters& parameters, const Progress& progress) {
  const FlowLinesOptions<set> options = stand_in_options<FlowLinesOptions<set>>().read(parameters);
  const auto field = fields::make_field(set.field);
  integrators::LineRequest request{.field = field.get(),
                                   .seeds = make_elements(options.count, options.seed, set.seed),
                                   .duration = set.duration,
                                   .progress = progress};
  geometry::LineSet lines = all_lines(set.integrator, request);
  set_importance(set.scalar, measure_flow(set.quantity, *field, lines.positions), set.shares,
                 lines);
  return lines;
}

/// Each particle starts near the foot of the funnel and has been carried for a time of its own.
struct TornadoParticlesOptions {
  static constexpr std::string_view unit = "particles";
  std::size_t count = 3000;
  std::uint64_t seed = 1;
};

Dataset make_tornado_particles(const Parameters& parameters, const Progress& progress) {
  const auto options = stand_in_options<TornadoParticlesOptions>().read(parameters);
  const auto field = fields::make_field("tornado");
  integrators::LineRequest request{
      .field = field.get(),
      .seeds = make_elements(options.count, options.seed,
                             [](const IndexedRandom& random) {
                               return random.in_box(0, {Vec3(0.4, 0.4, 0.05), Vec3(0.6, 0.6, 0.3)});
                             }),
      .duration = 12,
      .progress = progress};
  const geometry::LineSet lines = all_lines("stream-lines:turn=5,accuracy=1e-5", request);
  geometry::PointSet points;
  for (std::size_t i = 0; i < lines.line_count(); ++i) {
    const std::size_t first = lines.offsets[i], count = lines.offsets[i + 1] - first;
    const double share = IndexedRandom(options.seed, i).uniform(3, 0, 1);
    points.positions.push_back(lines.positions[first + std::size_t(share * double(count))]);
  }
  set_importance("vorticity", measure_flow(FlowQuantity::vorticity, *field, points.positions),
                 {.none = 0.5, .full = 0.95}, points);
  return points;
}

}  // namespace

// Each row makes stream lines, path lines or vortex lines of a flow, from random seeds: in place
// of the line data of Baeza Rojo et al. 2019.
const DatasetRow& benzene_dataset() {
  static const DatasetRow row{"benzene",
                              "Field lines of a benzene molecule (stand-in: point charges)",
                              "in place of Zoeckler et al. 1996; field: benzene",
                              stand_in_options<FlowLinesOptions<benzene>>().specs(), make<benzene>};
  return row;
}

const DatasetRow& bfs_dataset() {
  static const DatasetRow row{"bfs",
                              "Stream lines behind a backward-facing step (stand-in: a model flow)",
                              "in place of Niemann and Froehlich; field: step",
                              stand_in_options<FlowLinesOptions<bfs>>().specs(), make<bfs>};
  return row;
}

const DatasetRow& trefoil_dataset() {
  static const DatasetRow row{"trefoil", "Field lines of a magnetic trefoil knot",
                              "after Candelaresi and Brandenburg 2011; field: trefoil",
                              stand_in_options<FlowLinesOptions<trefoil>>().specs(), make<trefoil>};
  return row;
}

const DatasetRow& helicopter_dataset() {
  static const DatasetRow row{"helicopter", "Stream lines in a rotor's wake (stand-in: hover)",
                              "in place of Kutz et al. 2012; field: rotor-wake",
                              stand_in_options<FlowLinesOptions<helicopter>>().specs(),
                              make<helicopter>};
  return row;
}

const DatasetRow& helicopter_forward_dataset() {
  static const DatasetRow row{
      "helicopter-forward",
      "Stream lines around a rotor in forward flight near the ground (stand-in: line vortices)",
      "in place of Kutz et al. 2012; formula in its source",
      stand_in_options<FlowLinesOptions<helicopter_forward>>().specs(), make<helicopter_forward>};
  return row;
}

const DatasetRow& tornado_lines_dataset() {
  static const DatasetRow row{"tornado-lines", "Stream lines of the Crawfis tornado",
                              "R. A. Crawfis, The Ohio State University; field: tornado",
                              stand_in_options<FlowLinesOptions<tornado_lines>>().specs(),
                              make<tornado_lines>};
  return row;
}

const DatasetRow& tornado_particles_dataset() {
  static const DatasetRow row{"tornado-particles", "Particles that the Crawfis tornado carries up",
                              "R. A. Crawfis, The Ohio State University; field: tornado",
                              stand_in_options<TornadoParticlesOptions>().specs(),
                              make_tornado_particles};
  return row;
}

const DatasetRow& ecmwf_dataset() {
  static const DatasetRow row{
      "ecmwf", "Large-scale winds on a spherical shell (stand-in: jets and planetary waves)",
      "in place of Dee et al. 2011, ERA-Interim; stream function in its source",
      stand_in_options<FlowLinesOptions<ecmwf>>().specs(), make<ecmwf>};
  return row;
}

const DatasetRow& icon_dataset() {
  static const DatasetRow row{
      "icon", "Tracks of air over a part of the globe (stand-in: jets and planetary waves)",
      "in place of Heinze et al. 2017, HD(CP)2; stream function in its source",
      stand_in_options<FlowLinesOptions<icon>>().specs(), make<icon>};
  return row;
}

}  // namespace pellucid::scene
