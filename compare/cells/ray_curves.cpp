// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/ray_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "groundtruth/sums/ray_sums.h"

namespace pellucid::compare {
namespace {

constexpr int intervals = 512;

/// An opaque layer's optical depth is infinite; nothing shows behind this.
constexpr double deepest = 60;

std::vector<double> depths() {
  std::vector<double> d;
  for (int i = 0; i <= intervals; ++i) d.push_back(double(i) / intervals);
  return d;
}

RowCurve depth_curve(const Pixel& pixel, std::vector<double> tau) {
  return {fmt::format("optical depth {} {}", pixel.x, pixel.y),
          "",
          fmt::format("Optical depth along the ray of pixel ({}, {})", pixel.x, pixel.y),
          "d",
          "τ(d)",
          depths(),
          std::move(tau)};
}

scene::OpticalDepth exact_depth(const groundtruth::RayProbe& probe, const Pixel& pixel) {
  const groundtruth::RaySums sums = probe.at(pixel.x + 0.5, pixel.y + 0.5);
  scene::OpticalDepth result;
  for (const double d : depths()) result.values.push_back(std::min(sums.optical_depth(d), deepest));
  return result;
}

/// Of all rows in one plot: a shorter series has the same coefficients, as far as it goes.
void add_harmonics(const Pixel& pixel, const scene::OpticalDepth& depth, ResultRow& row) {
  RowCurve a{fmt::format("coefficients {} {}", pixel.x, pixel.y),
             "|a_k|",
             fmt::format("Fourier coefficients of pixel ({}, {})", pixel.x, pixel.y),
             "k",
             "|a_k|, |b_k|",
             {},
             {}};
  RowCurve b = a;
  b.label = "|b_k|";
  for (std::size_t k = 0; k < depth.harmonics.size(); ++k)
    for (auto& [curve, value] :
         {std::pair(&a, depth.harmonics[k].first), std::pair(&b, depth.harmonics[k].second)}) {
      curve->x.push_back(double(k));
      curve->y.push_back(std::abs(value));
    }
  row.curves.push_back(std::move(a));
  row.curves.push_back(std::move(b));
}

}  // namespace

void add_ray_curves(const Cell& cell, const scene::Scene& scene, scene::Renderer& renderer,
                    CellMeasurement& measured) {
  if (cell.probes.empty()) return;
  const bool exact = cell.reference && cell.call.row->promises.exact;
  std::optional<groundtruth::RayProbe> probe;
  if (exact) probe.emplace(scene);
  for (const Pixel& pixel : cell.probes) {
    if (pixel.x >= scene.width || pixel.y >= scene.height)
      throw InputError(fmt::format("probe [{}, {}]: outside the picture of {} x {} pixels", pixel.x,
                                   pixel.y, scene.width, scene.height));
    const auto depth =
        probe ? exact_depth(*probe, pixel) : renderer.optical_depth(pixel.x, pixel.y, depths());
    if (!depth) continue;
    measured.row.curves.push_back(depth_curve(pixel, depth->values));
    if (!depth->harmonics.empty()) add_harmonics(pixel, *depth, measured.row);
  }
}

}  // namespace pellucid::compare
