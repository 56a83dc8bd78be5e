// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/line_directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrators/paths/backward.h"

namespace pellucid::integrators {
namespace {

using Run = std::function<IntegratedLines(const LineRequest&)>;

IntegratedLines run_backward(LineRequest request, const Run& run) {
  const auto field = reversed_view(*request.field, request.start_time);
  request.field = field.get();
  request.duration = std::abs(request.duration);
  IntegratedLines result = run(request);
  turn_back(result.lines, *field);
  return result;
}

/// Copies vertices of `from` to the end of `to`; both have the same scalars.
class Copier {
 public:
  Copier(const geometry::LineSet& from, geometry::LineSet& to) : from_(from), to_(to) {}

  void copy(std::uint64_t vertex) {
    to_.positions.push_back(from_.positions[vertex]);
    for (const auto& [name, values] : from_.scalars) to_.scalars[name].push_back(values[vertex]);
  }

 private:
  const geometry::LineSet& from_;
  geometry::LineSet& to_;
};

/// Line by line: the way back from its end to the seed, and on; the seed is there once.
geometry::LineSet joined(const geometry::LineSet& back, const geometry::LineSet& ahead) {
  geometry::LineSet lines;
  for (const auto& [name, values] : ahead.scalars) lines.scalars[name];
  Copier from_back(back, lines), from_ahead(ahead, lines);
  for (std::size_t i = 0; i < ahead.line_count(); ++i) {
    const bool goes_ahead = ahead.offsets[i] < ahead.offsets[i + 1];
    for (std::uint64_t k = back.offsets[i + 1]; k > back.offsets[i] + goes_ahead; --k)
      from_back.copy(k - 1);
    for (std::uint64_t k = ahead.offsets[i]; k < ahead.offsets[i + 1]; ++k) from_ahead.copy(k);
    lines.offsets.push_back(lines.positions.size());
  }
  return lines;
}

void add(const LineStats& stats, LineStats& sum) {
  sum.particles += stats.particles;
  sum.evaluations += stats.evaluations;
  sum.seconds += stats.seconds;
  sum.bytes += stats.bytes;
  for (const auto& [reason, count] : stats.ends) sum.ends[reason] += count;
}

}  // namespace

IntegratedLines run_in_directions(const LineRequest& request, const Run& run) {
  if (!request.both) return request.duration < 0 ? run_backward(request, run) : run(request);
  LineRequest backward = request, forward = request;
  backward.progress = part_of(request.progress, 0, 0.5, "lines");
  forward.progress = part_of(request.progress, 0.5, 1, "lines");
  forward.duration = std::abs(request.duration);
  const IntegratedLines back = run_backward(std::move(backward), run);
  IntegratedLines result = run(forward);
  result.lines = joined(back.lines, result.lines);
  add(back.stats, result.stats);
  return result;
}

}  // namespace pellucid::integrators
