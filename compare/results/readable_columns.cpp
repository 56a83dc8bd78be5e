// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/readable_columns.h"

#include <fmt/format.h>

#include <cmath>

namespace pellucid::compare {
namespace {

std::string scientific(double x) { return x == 0 ? "0" : fmt::format("{:.2e}", x); }
std::string four_decimals(double x) { return fmt::format("{:.4f}", x); }
std::string one_decimal(double x) { return std::isinf(x) ? "∞" : fmt::format("{:.1f}", x); }
std::string whole(double x) { return fmt::format("{:.0f}", x); }

using Better = scene::Measure::Better;

constexpr ReadableColumn table[] = {
    {"rmse", "RMSE", [](const ResultRow& r) { return std::optional(r.metrics.linear.rmse); },
     scientific, Better::lower},
    {"ssim", "SSIM", [](const ResultRow& r) { return r.metrics.linear.ssim; }, four_decimals,
     Better::higher},
    {"psnr", "PSNR [dB]", [](const ResultRow& r) { return std::optional(r.metrics.linear.psnr); },
     one_decimal, Better::higher},
    {"seconds", "Time [ms]",
     [](const ResultRow& r) { return std::optional(r.seconds.median * 1e3); }, one_decimal,
     Better::lower},
    {"bytes", "Memory [MB]",
     [](const ResultRow& r) { return std::optional(double(r.total_bytes()) / 1e6); }, one_decimal,
     Better::lower},
    {"fragments", "Fragments",
     [](const ResultRow& r) { return std::optional(double(r.fragments)); }, whole, Better::neither},
    {"max_layers", "Layers", [](const ResultRow& r) { return std::optional(double(r.max_layers)); },
     whole, Better::neither}};

}  // namespace

std::span<const ReadableColumn> readable_columns() { return table; }

bool is_better(const ReadableColumn& column, double a, double b) {
  if (column.better == Better::neither) return false;
  return column.better == Better::lower ? a < b : a > b;
}

}  // namespace pellucid::compare
