// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  options.only = only;
  return run_study(study, options);
}

inline const ResultRow& row_of(const StudyOutcome& outcome, std::string_view scene,
                               std::string_view method) {
  for (const ResultRow& row : outcome.rows)
    if (row.scene == scene && row.method == method) return row;
  throw std::runtime_error("no such row");
}

}  // namespace pellucid::compare::testing
