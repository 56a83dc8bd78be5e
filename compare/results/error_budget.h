// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace pellucid::compare {

/// A BudgetLine is one stage's part of a picture's error. Shares are of the whole error's square:
/// with the stage's difference picture d and the whole error e, share = <d, e> / <e, e>.
struct BudgetLine {
  std::string stage;       // "mesh"
  std::string refinement;  // what its finer version is: "threshold=0.0125"
  std::string why_not;     // where the stage does not apply, why; no number then holds
  double share = 0;        // the mean of the next two
  double first = 0;        // share where it is refined before all others
  double last = 0;         // share where all others were refined before
  double rmse = 0;         // of the mean difference picture: how much it changes at all
  double gain = 0;         // by which the picture's RMSE falls when this stage alone is refined
  double seconds = 0;      // more that the picture then takes; NaN: not told apart
};

/// An ErrorBudget splits a picture's error into its stages' parts: shares and `interaction` add up
/// to 1.
struct ErrorBudget {
  double rmse = 0;         // of the picture, as drawn, against all stages refined
  double seconds = 0;      // of the picture as drawn: to make its scene, and to draw it
  double interaction = 0;  // what no single stage accounts for: of three stages or more together
  std::vector<BudgetLine> lines;
};

/// Writes all of a budget, as results.json has it.
nlohmann::json to_json(const ErrorBudget& budget);

/// Throws nlohmann's exceptions when `json` was not made by to_json.
ErrorBudget budget_from_json(const nlohmann::json& json);

}  // namespace pellucid::compare
