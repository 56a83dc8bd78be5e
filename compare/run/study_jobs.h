// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/cells/view_rows.h"
#include "compare/run/interleave.h"
#include "compare/run/run_study.h"
#include "compare/run/scene_at_hand.h"

namespace pellucid::compare {

/// A Job is a cell of this run, and its row once there is one.
struct Job {
  Cell cell;
  CellFiles files;
  std::string fingerprint;
  bool selected = true;
  std::optional<ResultRow> row = std::nullopt;
};

/// Returns the job of a cell of the study, selected.
Job make_job(const Study& study, const Cell& cell, const StudyOptions& options);

/// Returns the jobs of a study, those selected that fit `only`. Throws InputError where none does.
std::vector<Job> make_jobs(const Study& study, const StudyOptions& options);

/// Reads the rows of cells that this run does not have to compute: of all that its build has
/// finished when it resumes; and of those that it leaves out. Rows that this run will replace go
/// first, so that a kill can't leave them to be taken for its own.
void read_known_rows(std::vector<Job>& jobs, const StudyOptions& options);

/// The error of a cell that was not measured, since there is nothing to compare it with.
constexpr const char* reference_failed = "its scene's reference failed";

/// Returns the row of a cell that failed.
ResultRow failed_row(const Job& job, const std::string& why);

/// Writes what was measured of a cell from the view at hand, compares it with the reference, and
/// adds its row to those of the other views. Throws what comes in the way.
void finish_view(const Job& job, CellMeasurement measured, SceneAtHand& at_hand, const Study& study,
                 ViewRows& rows);

/// Returns the row of a cell that was measured from all views.
ResultRow finished_row(const Job& job, const ViewRows& rows, SceneAtHand& at_hand);

/// Writes the row of a job, whichever way it ended, and keeps it in the job.
void finish_job(Job& job, ResultRow row, const StudyOptions& options);

}  // namespace pellucid::compare
