// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/error_budget.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace pellucid::compare {
namespace {

using nlohmann::json;

json line_json(const BudgetLine& line) {
  if (!line.why_not.empty()) return {{"stage", line.stage}, {"why_not", line.why_not}};
  return {{"stage", line.stage}, {"refinement", line.refinement},
          {"share", line.share}, {"first", line.first},
          {"last", line.last},   {"rmse", line.rmse},
          {"gain", line.gain},   {"seconds", line.seconds}};  // NaN is null
}

BudgetLine line_from(const json& j) {
  BudgetLine line;
  line.stage = j.at("stage");
  line.why_not = j.value("why_not", "");
  if (!line.why_not.empty()) return line;
  line.refinement = j.at("refinement");
  line.share = j.at("share");
  line.first = j.at("first");
  line.last = j.at("last");
  line.rmse = j.at("rmse");
  line.gain = j.at("gain");
  line.seconds = j.at("seconds").is_null() ? std::nan("") : j.at("seconds").get<double>();
  return line;
}

}  // namespace

json to_json(const ErrorBudget& budget) {
  json lines = json::array();
  for (const BudgetLine& line : budget.lines) lines.push_back(line_json(line));
  return {{"rmse", budget.rmse},
          {"seconds", budget.seconds},
          {"interaction", budget.interaction},
          {"stages", lines}};
}

ErrorBudget budget_from_json(const json& j) {
  ErrorBudget budget{j.at("rmse"), j.at("seconds"), j.at("interaction"), {}};
  for (const json& line : j.at("stages")) budget.lines.push_back(line_from(line));
  return budget;
}

}  // namespace pellucid::compare
