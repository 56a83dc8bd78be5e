// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/conform/diagnosis/diagnose.h"
#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// A CaseResult is what became of one case.
struct CaseResult {
  std::string name, family, what;
  double n = 0;
  Verdict verdict;
  std::optional<Image> picture = std::nullopt;  // that was judged
};

/// A ConformRequest asks for a renderer's pictures of the suite: by a call, which may be an
/// external command, or from a folder that holds NAME.exr or NAME.png of each case.
struct ConformRequest {
  std::optional<MethodCall> call = std::nullopt;
  std::filesystem::path pictures = {};
  std::string only = {};  // shell pattern of names; empty: every case
  double tolerance = conformance_tolerance;
  scene::RenderContext context = {};
  std::function<void(double, const CaseResult&)> on_case =
      {};  // the share that is done, and the case
};

/// Judges the cases in their order. A picture that is missing, or cannot be made, fails its case.
/// Throws InputError when nothing fits `only`.
std::vector<CaseResult> conform(const ConformRequest& request);

/// Leaves the suite in the folder, which has to exist: NAME/scene.json and so on, as export_scene()
/// writes it, NAME/expected.exr, the right picture, and cases.json, a list of all.
void make_conformance_scenes(const std::filesystem::path& folder, const std::string& only);

/// A FamilySummary says how far a renderer comes in one family.
struct FamilySummary {
  std::string family;
  int passed = 0;
  int cases = 0;
  const CaseResult* first_failed = nullptr;
};

/// Returns a summary of each family, in their order; points into `results`.
std::vector<FamilySummary> summarize(const std::vector<CaseResult>& results);

}  // namespace pellucid::compare
