// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "compare/run/run_study.h"
#include "tests/compare/fake_methods.h"
#include "tests/compare/study_folder.h"

namespace pellucid::compare::testing {

inline constexpr const char* two_methods = R"(["shifted:by=0.5", "exact-shifted"])";

inline StudyOutcome run(const StudyFolder& folder, const std::string& methods, bool resume = false,
                        const std::string& only = "") {
  const Study study = load_study(folder.study(methods), fake_methods());
  StudyOptions options;
  options.folder = folder / "results";
  options.resume = resume;
  if (!only.empty()) options.only = {only};
  return run_study(study, options);
}

/// What has to be equal however a study was run: everything but times.
inline nlohmann::json without_times(const ResultRow& row) {
  nlohmann::json json = to_json(row);
  if (json.contains("seconds"))
    for (const char* measured : {"setup", "calibrations"}) json["seconds"].erase(measured);
  return json;
}

inline const ResultRow& row_of(const StudyOutcome& outcome, std::string_view scene,
                               std::string_view method) {
  for (const ResultRow& row : outcome.rows)
    if (row.scene == scene && row.method == method) return row;
  throw std::runtime_error("no such row");
}

}  // namespace pellucid::compare::testing
