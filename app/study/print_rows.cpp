// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study/print_rows.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "compare/results/provenance.h"
#include "core/error.h"
#include "core/options/name_list.h"

namespace pellucid::app {
namespace {

std::string milliseconds_and_memory(const compare::ResultRow& row) {
  if (!row.given.empty())
    return row.steps.empty() ? "given" : fmt::format("{:9.1f} ms, given", row.seconds.median * 1e3);
  return fmt::format("{:9.1f} ms {:9.1f} MB", row.seconds.median * 1e3,
                     double(row.total_bytes()) / 1e6);
}

/// On a terminal the line of the progress stands where the row goes.
void clear_progress_line() {
  if (::isatty(STDOUT_FILENO) != 0 && ::isatty(STDERR_FILENO) != 0) fmt::print("\r\x1b[K");
}

bool has_failed(const compare::ResultRow& row) { return !row.error.empty(); }

std::string text_of_missing(std::span<const compare::MissingCell> missing, std::size_t cells) {
  std::vector<std::string> names;
  for (const compare::MissingCell& cell : missing) names.push_back(cell.text());
  return fmt::format("{} of {} cells are missing: {}", missing.size(), cells, some_of(names, 8));
}

std::string text_of_failed(std::span<const compare::ResultRow> rows, std::size_t cells,
                           const std::filesystem::path& folder) {
  const auto first = std::ranges::find_if(rows, has_failed);
  return fmt::format("{} of {} cells failed, the first: {}/{}: {} (all: {})",
                     std::ranges::count_if(rows, has_failed), cells, first->scene, first->method,
                     first->error, (folder / "results.csv").string());
}

}  // namespace

void print_row(const compare::ResultRow& row) {
  clear_progress_line();
  const std::string name = row.scene + '/' + row.call();
  if (!row.error.empty()) return fmt::print("{:40} failed: {}\n", name, row.error);
  for (const std::string& fault : row.given_faults)
    fmt::print("{:40} the picture {}\n", name, fault);
  const compare::Metrics& m = row.metrics.linear;
  const std::optional<double> ssim = m.of("ssim");
  fmt::print("{:40} RMSE {:9.3e}  SSIM {}  {}\n", name, m.of("rmse").value_or(NAN),
             ssim ? fmt::format("{:.4f}", *ssim) : "none  ", milliseconds_and_memory(row));
  std::fflush(stdout);
}

void print_warnings(std::span<const compare::ResultRow> rows) {
  for (const std::string& warning : compare::provenance_warnings(rows))
    std::cerr << "pellucid: " << one_line(warning, warning.size() + 1) << '\n';
}

void check_complete(std::span<const compare::ResultRow> rows,
                    std::span<const compare::MissingCell> missing,
                    const std::filesystem::path& folder) {
  const std::size_t cells = rows.size() + missing.size();
  std::string text;
  if (!missing.empty()) text = text_of_missing(missing, cells);
  if (std::ranges::any_of(rows, has_failed))
    text += (text.empty() ? "" : "; ") + text_of_failed(rows, cells, folder);
  if (!text.empty()) throw WorkError(text);
}

}  // namespace pellucid::app
