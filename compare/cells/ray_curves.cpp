// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/ray_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "compare/cells/ray_functions.h"
#include "core/error.h"
#include "groundtruth/sums/ray_sums.h"

namespace pellucid::compare {
namespace {

/// The paper's number of bands, and what it says that no term beyond exceeds, of the whole sum
/// (Baeza Rojo et al. 2019, Fig. 9b).
constexpr std::size_t marked_band = 5;
constexpr double marked_percent = 5;

/// What is measured of the terms, after the sum's name.
constexpr std::string_view fifth = "term_5", beyond_fifth = "terms_beyond_5";

RowCurve depth_curve(const RayFunction& quantity, const Pixel& pixel, std::vector<double> values) {
  return {fmt::format("{} {} {}", quantity.title, pixel.x, pixel.y),
          "",
          fmt::format("Sum of the {} along the ray of pixel ({}, {})", quantity.title, pixel.x,
                      pixel.y),
          "d",
          quantity.symbol,
          curve_depths(),
          std::move(values)};
}

/// Eq. 5's terms of band k ≥ 1 are at most these parts of the sum's end F(1) = a_0 / 2, in percent:
/// a_k / (2 π k) and b_k / (2 π k), without their waves.
struct Term {
  double a, b;

  double larger() const { return std::max(a, b); }
};

/// Of a sum of nothing there are no parts.
bool has_terms(const scene::RaySeries& series) {
  return series.harmonics.size() > 1 && series.harmonics[0].first > 0;
}

Term term(const scene::RaySeries& series, std::size_t k) {
  const double whole = 2 * std::numbers::pi * double(k) * series.harmonics[0].first / 2;
  const auto percent = [&](double c) { return 100 * std::abs(c) / whole; };
  return {percent(series.harmonics[k].first), percent(series.harmonics[k].second)};
}

/// Of all rows in one plot: a shorter series has the same coefficients, as far as it goes.
void add_terms(const RayFunction& quantity, const Pixel& pixel, const scene::RaySeries& series,
               ResultRow& row) {
  const auto curve = [&](const char* label) {
    return RowCurve{
        fmt::format("terms of the {} {} {}", quantity.title, pixel.x, pixel.y),
        label,
        fmt::format("Terms of the {}'s series at pixel ({}, {})", quantity.title, pixel.x, pixel.y),
        "k",
        "part of the whole sum [%]",
        {},
        {}};
  };
  RowCurve a = curve("|a_k| / (2πk)"), b = curve("|b_k| / (2πk)");
  RowCurve least = curve("5 %"), marked = curve("m = 5");
  for (std::size_t k = 1; k < series.harmonics.size(); ++k) {
    const Term here = term(series, k);
    for (auto& [of, value] : {std::pair(&a, here.a), std::pair(&b, here.b)}) {
      of->x.push_back(double(k));
      of->y.push_back(value);
    }
  }
  least.x = {1, a.x.back()};
  least.y = {marked_percent, marked_percent};
  marked.x = {double(marked_band), double(marked_band)};
  marked.y = {0, std::max({marked_percent, a.y.front(), b.y.front()})};
  for (RowCurve* of : {&a, &b, &least, &marked}) row.curves.push_back(std::move(*of));
}

/// The largest terms over all probes, as far as a series has them.
class TermMeasures {
 public:
  void add(const scene::RaySeries& series) {
    for (std::size_t k = marked_band; k < series.harmonics.size(); ++k) {
      std::optional<double>& largest = k == marked_band ? at_ : beyond_;
      largest = std::max(largest.value_or(0), term(series, k).larger());
    }
  }

  void append_to(const RayFunction& quantity, ResultRow& row) const {
    const auto append = [&](std::string_view name, const char* title,
                            std::optional<double> percent) {
      if (percent)
        row.measures.push_back({fmt::format("{}_{}", quantity.name, name),
                                fmt::format("{} of the {}'s series", title, quantity.title), "%",
                                *percent, Better::lower});
    };
    append(fifth, "Fifth term", at_);
    append(beyond_fifth, "Largest term beyond the fifth", beyond_);
  }

 private:
  std::optional<double> at_, beyond_;
};

/// Whether the reference's row has the exact sums: G is the scene's, whatever is composited.
bool has_exact(const RayFunction& quantity, const Cell& cell, const scene::Scene& scene) {
  if (!cell.reference) return false;
  return quantity.sum == scene::RaySum::importance ? has_importance(scene)
                                                   : cell.call.row->promises.exact;
}

void check(const Pixel& pixel, const scene::Scene& scene) {
  if (pixel.x >= scene.width || pixel.y >= scene.height)
    throw InputError(fmt::format("probe [{}, {}]: outside the picture of {} x {} pixels", pixel.x,
                                 pixel.y, scene.width, scene.height));
}

}  // namespace

bool is_of_probes(std::string_view measure) {
  return std::ranges::any_of(ray_functions(), [&](const RayFunction& quantity) {
    return measure == fmt::format("{}_{}", quantity.name, fifth) ||
           measure == fmt::format("{}_{}", quantity.name, beyond_fifth);
  });
}

void add_ray_curves(const Cell& cell, const scene::Scene& scene, scene::Renderer& renderer,
                    CellMeasurement& measured) {
  for (const Pixel& pixel : cell.probes) check(pixel, scene);
  std::optional<groundtruth::RayProbe> probe;
  for (const RayFunction& quantity : ray_functions()) {
    const bool exact = has_exact(quantity, cell, scene);
    if (exact && !cell.probes.empty() && !probe) probe.emplace(scene);
    TermMeasures terms;
    for (const Pixel& pixel : cell.probes) {
      const auto series =
          exact
              ? scene::RaySeries{exact_curve(quantity, probe->at(pixel.x + 0.5, pixel.y + 0.5)), {}}
              : renderer.ray_series(quantity.sum, pixel.x, pixel.y, curve_depths());
      if (!series) continue;
      measured.row.curves.push_back(depth_curve(quantity, pixel, series->values));
      if (!has_terms(*series)) continue;
      add_terms(quantity, pixel, *series, measured.row);
      terms.add(*series);
    }
    terms.append_to(quantity, measured.row);
  }
}

}  // namespace pellucid::compare
