// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/pictures/metrics.h"
#include "compare/results/error_budget.h"
#include "compare/timing/timing_rule.h"
#include "core/machine/calibration.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// A CoverageCheck tells where a method that is exact, or makes layers of its own, sees another
/// number of layers than the reference. An exact one does at the very edge of a triangle, which two
/// renderers may give to either side.
struct CoverageCheck {
  std::uint64_t differing = 0;          // pixels with another number of layers
  std::uint64_t differing_by_more = 0;  // … by more than one
  std::uint64_t pixels = 0;
  std::optional<double> rmse_elsewhere;  // over the pixels with equal numbers, if there are any
};

/// A further picture of a cell: images/SCENE/METHOD.NAME.png.
struct RowPicture {
  std::string name, title;
  double min = 0, max = 1;  // ends of its logarithmic scale
};

/// Numbers over numbers. The report draws those of one name in one plot, whichever rows they are
/// of.
struct RowCurve {
  std::string name;
  std::string label;  // of the curve; empty: its row's name
  std::string title, x_title, y_title;
  std::vector<double> x, y;
};

/// A ResultRow is what one cell of a study found out.
struct ResultRow {
  std::string scene, method, parameters;  // parameters as given: "bands=5"
  bool reference = false;
  std::string given;  // where a picture from elsewhere comes from: "command", "picture"
  std::string error;  // empty: the cell is done, and what follows holds

  std::string fingerprint;  // of the cell: scene's text, methods, parameters, repeats, driver
  std::map<std::string, std::string> files_read;  // path → hash of the content
  RawOptions parameter_values;                    // defaults included
  int repeats = 0;
  Comparison metrics;
  /// Of a method of random numbers: where each metric lies by several draws, by its name.
  std::map<std::string, Interval> metric_intervals;
  Spread seconds;
  std::vector<std::pair<std::string, Spread>> steps;
  double setup_seconds = 0;  // geometry uploaded, hierarchies built
  double first_seconds = 0;  // of the first picture, in which drivers compile what they left open
  std::optional<double> gl_seconds;  // median, by the driver's own clock, where it has one
  std::optional<bool> settled;       // whether the interval became as narrow as asked, where it was
  std::vector<Calibration> calibrations;  // of the machine, from before to after the cell
  std::vector<scene::NamedBytes> bytes;
  std::uint64_t fragments = 0;
  std::uint64_t stored = 0, dropped = 0, truncated = 0;  // see RenderStats
  std::uint32_t max_layers = 0;
  std::optional<CoverageCheck> coverage;
  std::vector<std::string> given_faults;  // what looks wrong with a picture from elsewhere
  std::vector<scene::Measure> measures;   // that only some methods have
  std::vector<RowPicture> pictures;
  std::vector<RowCurve> curves;
  std::optional<ErrorBudget> budget;     // of the picture's error, where the study asks for it
  std::vector<std::string> explanation;  // what the method modelled, and why
  std::map<std::string, std::string> scene_provenance;  // how the scene was made
  std::map<std::string, std::string> machine;           // with the method's own facts: driver, …

  std::uint64_t total_bytes() const;
  /// Returns the seconds to the first picture: setting up, and drawing it.
  double first_frame_seconds() const { return setup_seconds + first_seconds; }
  /// "fourier:bands=5", as MethodCall::text() of its cell.
  std::string call() const { return parameters.empty() ? method : method + ':' + parameters; }
};

/// Returns the first row of a scene and call; null where there is none.
const ResultRow* row_of_cell(const std::string& scene, const std::string& call,
                             std::span<const ResultRow> rows);

/// Writes all of a row, as results.json and a cell's file have it.
nlohmann::json to_json(const ResultRow& row);

/// Throws nlohmann's exceptions when `json` was not made by to_json.
ResultRow row_from_json(const nlohmann::json& json);

/// Writes the metrics of the float pictures, and under "displayed" those of the 8-bit values.
nlohmann::json to_json(const Comparison& comparison);

}  // namespace pellucid::compare
