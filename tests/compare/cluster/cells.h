// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/cluster/collect_study.h"
#include "compare/cluster/compute_cell.h"
#include "compare/cluster/study_plan.h"
#include "core/error.h"
#include "tests/compare/run/studies.h"

namespace pellucid::compare::testing {

/// A study of both scenes whose cells are computed one by one.
class CellByCell {
 public:
  explicit CellByCell(const std::string& methods = two_methods,
                      const std::string& more = R"("repeats": 2)")
      : study(load_study(folder.study(methods, more), fake_methods())) {
    options.folder = folder / "results";
    options.calibrate = [] { return Calibration{1, 1}; };  // a machine that nothing disturbs
  }

  ResultRow compute(const std::string& cell) const { return compute_cell(study, cell, options); }
  Collection collect() const { return collect_study(study, options); }

  std::string refusal(const std::string& cell) const {
    try {
      compute(cell);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "accepted";
  }

  StudyFolder folder;
  Study study;
  StudyOptions options;
};

}  // namespace pellucid::compare::testing
