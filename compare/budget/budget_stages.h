// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compare/methods/method_call.h"
#include "compare/study/study.h"
#include "scene/view/pixel_samples.h"

namespace pellucid::compare {

/// A DrawPlan says how a picture comes about, from the scene's text to the display.
struct DrawPlan {
  nlohmann::json scene;  // as its file has it
  scene::PixelSampling samples;
  std::optional<MethodCall> opacities;  // see Study
  MethodCall call;
  bool displayed = true;  // rounded to 8 bits
};

/// BudgetTools are what stages are refined to.
struct BudgetTools {
  BudgetOptions options;
  MethodCall lists;            // composites every layer exactly, in float
  MethodCall reference;        // … in double
  MethodCall exact_opacities;  // optimizes by exact sums
};

/// A StageRefinement says what a stage was refined to, or why it does not apply.
struct StageRefinement {
  std::string what, why_not;
};

/// A BudgetStage is a stage between data and display whose part of the error is measured.
struct BudgetStage {
  std::string_view name;   // "mesh"
  std::string_view title;  // for people
  /// Refines the stage in the plan; leaves the plan where it does not apply.
  StageRefinement (*refine)(const BudgetTools& tools, DrawPlan& plan);
  std::string_view upon = {};  // the stage that has to be refined before
};

/// Returns the table of stages, in the order from data to display.
std::span<const BudgetStage> budget_stages();

/// Returns the title of the stage of this name; the name where there is none.
std::string title_of_stage(std::string_view name);

}  // namespace pellucid::compare
