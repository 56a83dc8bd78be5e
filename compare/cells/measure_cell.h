// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "compare/cells/cell.h"
#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// So many pictures a method of random numbers is judged by: the fewest that have an interval.
constexpr std::uint32_t judged_draws = 5;

/// A CellMeter measures one cell while others are measured in turn with it. It throws what the
/// method throws.
class CellMeter {
 public:
  /// Makes the renderer, and renders once to warm up and to count layers; with `first_is_timed`
  /// that picture is the first of those that are timed. The scene has to outlive the meter.
  CellMeter(const Cell& cell, const scene::Scene& scene, const scene::RenderContext& context,
            bool first_is_timed = false);

  /// Renders once against the clock.
  void time_once();
  /// Returns the times until now, in seconds.
  std::span<const double> seconds() const { return seconds_; }
  /// Returns what is known of the row until now: of the first picture.
  const ResultRow& row() const { return result_.row; }
  /// Returns the picture that was timed first.
  const Image& image() const { return result_.image; }
  /// Returns, of a method of random numbers, further pictures by others, judged_draws with
  /// image(); none of all other methods. Draws those that were not timed.
  const std::vector<Image>& draws();
  /// Returns what was measured, after one time at least. Throws WorkError when the picture has
  /// pixels that are not finite.
  CellMeasurement finish(const TimingRule& timing);

 private:
  void warm_up(bool is_timed);
  void keep(scene::Rendering rendering);

  Cell cell_;
  const scene::Scene& scene_;
  CellMeasurement result_;
  std::unique_ptr<scene::Renderer> renderer_;
  std::vector<scene::RenderStats> runs_;
  std::vector<double> seconds_;
};

/// Returns whether the first picture of a cell is the one that is timed: of one that is timed once,
/// by a ray tracer, which has nothing to warm up.
bool is_drawn_once(const Cell& cell, const TimingRule& timing);

/// Measures one cell alone: a CellMeter that is timed until the rule is met.
CellMeasurement measure_cell(const Cell& cell, const scene::Scene& scene, const TimingRule& timing,
                             const scene::RenderContext& context);

/// Checks how an exact method's numbers of layers, and its picture where they agree, fit the
/// reference. All have one size.
CoverageCheck check_coverage(const Image& reference, const CountImage& reference_layers,
                             const Image& test, const CountImage& test_layers);

}  // namespace pellucid::compare
