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

/// Appends the lines of one seed: the way back from its end to the seed, and on; the seed is there
/// once. What a streak line has beyond gaps are lines before and after. Where one of both ways does
/// not begin at the seed, since particles just let go are gone, they are two lines.
class SeedJoiner {
 public:
  SeedJoiner(const IntegratedLines& back, const IntegratedLines& ahead, IntegratedLines& joined)
      : back_(back), ahead_(ahead), joined_(joined) {
    for (const auto& [name, values] : ahead.lines.scalars) joined.lines.scalars[name];
  }

  void append(std::uint32_t seed) {
    const auto [back_begin, back_end] = lines_of(back_, seed);
    const auto [ahead_begin, ahead_end] = lines_of(ahead_, seed);
    for (std::size_t k = back_end; k > back_begin + 1; --k) {
      copy_back(k - 1, 0);
      end_line(seed);
    }
    const bool meet =
        begins_at_seed(back_.lines, back_begin) && begins_at_seed(ahead_.lines, ahead_begin);
    copy_back(back_begin, meet ? 1 : 0);
    if (!meet && !is_empty(back_.lines, back_begin) && !is_empty(ahead_.lines, ahead_begin))
      end_line(seed);
    for (std::size_t k = ahead_begin; k < ahead_end; ++k) {
      copy_ahead(k);
      end_line(seed);
    }
  }

 private:
  static std::pair<std::size_t, std::size_t> lines_of(const IntegratedLines& all,
                                                      std::uint32_t seed) {
    const auto [begin, end] = std::ranges::equal_range(all.seeds, seed);
    return {std::size_t(begin - all.seeds.begin()), std::size_t(end - all.seeds.begin())};
  }
  static bool is_empty(const geometry::LineSet& lines, std::size_t k) {
    return lines.offsets[k] == lines.offsets[k + 1];
  }
  static bool begins_at_seed(const geometry::LineSet& lines, std::size_t k) {
    return !is_empty(lines, k) && lines.scalars.at("t")[lines.offsets[k]] == 0;
  }

  /// From the line's end to its beginning, but for the first vertices.
  void copy_back(std::size_t k, std::uint64_t but_for) {
    const auto& offsets = back_.lines.offsets;
    for (std::uint64_t i = offsets[k + 1]; i > offsets[k] + but_for; --i) copy(back_.lines, i - 1);
  }
  void copy_ahead(std::size_t k) {
    const auto& offsets = ahead_.lines.offsets;
    for (std::uint64_t i = offsets[k]; i < offsets[k + 1]; ++i) copy(ahead_.lines, i);
  }
  void copy(const geometry::LineSet& from, std::uint64_t vertex) {
    joined_.lines.positions.push_back(from.positions[vertex]);
    for (const auto& [name, values] : from.scalars)
      joined_.lines.scalars[name].push_back(values[vertex]);
  }
  void end_line(std::uint32_t seed) {
    joined_.lines.offsets.push_back(joined_.lines.positions.size());
    joined_.seeds.push_back(seed);
  }

  const IntegratedLines &back_, &ahead_;
  IntegratedLines& joined_;
};

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
  const IntegratedLines back = run_backward(std::move(backward), run), ahead = run(forward);
  IntegratedLines result;
  SeedJoiner joiner(back, ahead, result);
  for (std::uint32_t seed = 0; seed < request.seeds.size(); ++seed) joiner.append(seed);
  result.stats = ahead.stats;
  add(back.stats, result.stats);
  return result;
}

}  // namespace pellucid::integrators
