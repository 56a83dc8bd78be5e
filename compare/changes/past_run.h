// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A PastRun is what a run of a study has left in its folder.
struct PastRun {
  std::filesystem::path folder;
  std::string study;            // its name
  std::vector<ResultRow> rows;  // of every cell, those that failed too
  std::string title = "";       // the study's, for people
};

/// Returns whether the path is a folder, and so meant as the results of a run.
bool is_run_folder(const std::filesystem::path& path);

/// Reads a run's results.json. Throws InputError, which names the file, when there is none, or one
/// of another format or version.
PastRun read_past_run(const std::filesystem::path& folder);

/// Returns the name of a row's cell: "abc/fourier:bands=5".
std::string cell_name(const ResultRow& row);

/// Returns the run's row of the cell of this name; nullptr where it has none.
const ResultRow* find_row_of(const PastRun& run, const std::string& cell);

/// Returns where OpenGL ran, as --gl takes it. Rows that do not say it are of an earlier version,
/// and are taken for those of the default.
std::string gl_of(const ResultRow& row);

/// Returns the files that the row's cell has read, with the hashes of their contents; without the
/// program's own helpers, which read files for it.
std::map<std::string, std::string> inputs_of(const ResultRow& row);

}  // namespace pellucid::compare
