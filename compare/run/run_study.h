// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compare/report/report_form.h"
#include "compare/results/result_row.h"
#include "compare/study/study.h"
#include "core/machine/build_info.h"

namespace pellucid::compare {

/// StudyOptions say which cells of a study a run computes, and where results go.
struct StudyOptions {
  std::filesystem::path folder;  // where results go
  bool resume = false;  // keep cells that this build finished for the same scenes and parameters
  std::vector<std::string> only;  // shell patterns; none: every cell
  scene::RenderContext context;
  std::string build = build_id();  // of the program whose rows these are
  ReportForm report;
  Progress progress;
  std::function<Calibration()> calibrate = pellucid::calibrate;  // between the cells
  std::function<void(const ResultRow&)> on_row;  // called when a cell is done or has failed
};

/// A StudyOutcome holds what is known of a study after a run.
struct StudyOutcome {
  std::vector<ResultRow> rows;  // of every cell that is known, in the study's order
  std::size_t computed = 0;     // by this run
  std::size_t kept = 0;         // finished before
};

/// Runs the cells whose scene, method, or "SCENE/METHOD:PARAMETERS" fits one of `only`, each
/// scene's reference first, and leaves in the folder:
///
///     cells/SCENE/METHOD.json                the cell's row, written last, whole or not at all
///     images/SCENE/METHOD.{exr,png}          the picture; METHOD.error.png, METHOD.flip.png,
///     METHOD.layers.exr results.{csv,json}, table.{md,tex}     made from the cells' rows; the CSV
///     after every cell report.html, and report/ where it is a folder
///
/// Cells share nothing but their scene's reference picture, which is computed where it is missing:
/// several runs may share the work by `only` and a folder, and a last one with `resume` collects
/// it. With `resume` a row is kept when the same build made it of the same files, by their content;
/// the rows that `only` leaves out are kept whichever build made them, and the report says so where
/// builds or machines differ. Where the study has a ScreenRule, cells that fall out by it have no
/// row; screened.csv and a note in the report tell which. A cell that fails becomes a row with its
/// error, and the study goes on. Throws InputError when the folder cannot be written or one of
/// `only` fits nothing.
StudyOutcome run_study(const Study& study, const StudyOptions& options);

}  // namespace pellucid::compare
