// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sums.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/pictures/image_file.h"
#include "compare/sums/draw_sums.h"
#include "compare/sums/merge_sums.h"
#include "core/error.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

using compare::SumsFile;
using compare::SumsInfo;

/// The first phase's totals, where the second's are merged.
SumsFile earlier_totals(const SumsMerge& request, const SumsInfo& second) {
  if (request.totals.empty())
    throw InputError(fmt::format(
        "{}: is of phase 2 of {}; accepted: with --totals, the totals of its first phase",
        request.files.front().string(), second.method));
  SumsFile totals = compare::read_sums_file(request.totals);
  compare::check_totals(request.totals, totals.info, request.files.front(), second);
  return totals;
}

/// The totals of all phases.
std::vector<SumsFile> all_totals(const SumsMerge& request, int parts, SumsFile merged,
                                 const GlobalOptions& globals) {
  std::vector<SumsFile> totals;
  if (merged.info.phase == 2) totals.push_back(earlier_totals(request, merged.info));
  totals.push_back(std::move(merged));
  if (totals.size() < std::size_t(totals.front().info.phases))
    totals.push_back(
        compare::draw_second_phase(totals[0], parts, globals.gl, console_progress(globals)));
  return totals;
}

void print_merged(const SumsMerge& request, const SumsInfo& info, int parts, bool as_json) {
  const std::string& file = request.picture.empty() ? request.partial : request.picture;
  if (!as_json) return fmt::print("{}: {} parts, {}\n", file, parts, info.method);
  fmt::print("{}\n", json_text({{"output", request.picture},
                                {"partial", request.partial},
                                {"parts", parts},
                                {"method", info.method},
                                {"phase", {info.phase, info.phases}}},
                               2));
}

}  // namespace

void print_sums(const std::string& file, const SumsInfo& info, const GlobalOptions& globals) {
  const scene::PartNumber& part = info.of.part;
  if (globals.json)
    fmt::print("{}\n", json_text({{"partial", file},
                                  {"method", info.method},
                                  {"part", {part.part, part.count}},
                                  {"phase", {info.phase, info.phases}}},
                                 2));
  else if (!globals.quiet)
    fmt::print("{}: sums of {}, phase {} of {}, part {} of {}\n", file, info.method, info.phase,
               info.phases, part.part, part.count);
}

void merge_sums(const SumsMerge& request, const GlobalOptions& globals) {
  const int parts = int(request.files.size());  // each part is there once
  SumsFile merged = compare::merge_sums(request.files, console_progress(globals));
  const SumsInfo info = merged.info;
  if (!request.totals.empty() && (info.phase != 2 || request.picture.empty()))
    throw InputError(
        fmt::format("--totals: accepted: with -o and sums of phase 2; {} is of phase {} of {}",
                    request.files.front().string(), info.phase, info.phases));
  if (request.picture.empty()) {
    compare::write_sums_file(request.partial, merged);
  } else {
    const std::vector<SumsFile> totals = all_totals(request, parts, std::move(merged), globals);
    // Before the first file is written: what is refused is refused here.
    const Image image = compare::composite_sums(totals, globals.gl);
    if (!request.partial.empty())
      compare::write_sums_file(request.partial, totals[std::size_t(info.phase - 1)]);
    compare::write_image(request.picture, image,
                         compare::form_of_picture(compare::origin_of(info.of, info.method)));
  }
  if (globals.json || !globals.quiet) print_merged(request, info, parts, globals.json);
}

}  // namespace pellucid::app
