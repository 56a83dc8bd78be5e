// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/integrate_lines.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "core/parallel.h"
#include "geometry/finite_vertices.h"
#include "integrators/lines/line_budget.h"
#include "integrators/lines/line_directions.h"
#include "integrators/lines/line_options.h"
#include "integrators/lines/seeds_extent.h"
#include "integrators/lines/vertex_spacing.h"
#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/seed_place.h"
#include "integrators/paths/trajectory_options.h"

namespace pellucid::integrators {
namespace {

/// One particle's line before the lines are joined.
struct Line {
  struct Point {
    Vec3 x;
    double t, time, speed;
  };
  std::vector<Point> points;
  std::vector<std::size_t> breaks;  // points at which a line of its own begins, beyond a gap
  EndCounts ends;
  bool is_cut = false;  // it would have had more points than it may have
};

Line::Point line_point(const FlowPoint& flow, double t, double time) {
  return {flow.x, t, time, magnitude(flow.v)};
}

Line cut(Line line) {
  line.is_cut = true;
  ++line.ends[EndReason::vertices];
  return line;
}

Line follow(const TrajectoryOptions& options, const Vec3& seed, VertexSpacing spacing,
            std::uint64_t most_vertices, fields::FieldSampler& sampler) {
  // Of the way so far: who has come to a sink stays there, and turns about within rounding.
  constexpr double resolution = 1e-6;
  Line line;
  Trajectory path(options, seed, Vec3(0), sampler);
  const auto add = [&](double t) {
    if (t > 0)
      spacing.shortest += resolution * glm::distance(line.points.back().x, path.position_at(t));
    line.points.push_back(line_point(path.at(t), t, options.start_time + (options.path ? t : 0)));
  };
  for (double t = 0; path.exists();) {
    if (line.points.size() == most_vertices) return cut(std::move(line));
    add(t);
    path.release(t);
    // The first step's own acceleration is not known before it is made.
    path.reach(std::nextafter(t, options.duration), sampler);
    const double wanted = next_vertex_time(path, t, spacing, sampler);
    path.reach(wanted, sampler);
    const double next = std::min(wanted, path.time());
    if (!(next > t)) break;
    t = next;
  }
  ++line.ends[path.end().value_or(EndReason::steps)];
  return line;
}

/// A streak line at the end of the journey: of the particles let go at the seed one after another,
/// the youngest first. Where some of them are gone it has a gap, and goes on beyond it. Only in a
/// field that does not change are those let go before gone, too.
Line streak(TrajectoryOptions options, const Vec3& seed, int releases, std::uint64_t most_vertices,
            fields::FieldSampler& sampler) {
  const double duration = options.duration, begin = options.start_time;
  Line line;
  Vec3 v;
  if (sampler.velocity(seed, begin + duration, v) == fields::SampleStatus::ok)
    line.points.push_back({seed, 0, begin + duration, magnitude(v)});
  bool beyond_gap = false;
  for (int i = 1; i <= releases; ++i) {
    if (line.points.size() == most_vertices) return cut(std::move(line));
    options.duration = duration * i / releases;
    options.start_time = begin + duration - options.duration;
    Trajectory path(options, seed, Vec3(0), sampler);
    const bool arrives = path.exists() && path.reach(options.duration, sampler);
    if (path.end()) ++line.ends[*path.end()];
    if (!arrives && !options.changing) break;
    if (!arrives) {
      beyond_gap = !line.points.empty();
      continue;
    }
    if (beyond_gap) line.breaks.push_back(line.points.size());
    beyond_gap = false;
    line.points.push_back(
        line_point(path.at(options.duration), options.duration, begin + duration));
  }
  return line;
}

/// The lines of the seed, one more than it has gaps.
void append(const Line& line, std::uint32_t seed, IntegratedLines& result) {
  geometry::LineSet& set = result.lines;
  const auto end_line = [&] {
    set.offsets.push_back(set.positions.size());
    result.seeds.push_back(seed);
  };
  auto next_break = line.breaks.begin();
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (next_break != line.breaks.end() && *next_break == i) end_line(), ++next_break;
    const Line::Point& point = line.points[i];
    set.positions.push_back(point.x);
    set.scalars["t"].push_back(point.t);
    set.scalars["time"].push_back(point.time);
    set.scalars["speed"].push_back(point.speed);
  }
  end_line();
  for (const auto& [reason, count] : line.ends) result.stats.ends[reason] += count;
}

IntegratedLines joined(std::span<const Line> lines) {
  IntegratedLines result;
  for (const char* name : {"t", "time", "speed"}) result.lines.scalars[name];
  for (std::size_t i = 0; i < lines.size(); ++i) append(lines[i], std::uint32_t(i), result);
  return result;
}

void check(const LineRequest& request) {
  if (!request.field || request.seeds.empty())
    throw InputError("integrate: a field and at least one seed are needed");
  for (const Vec3& x : request.seeds)
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
      throw InputError(fmt::format("seed ({}, {}, {}) is not finite", x.x, x.y, x.z));
}

/// A line goes somewhere when it has two vertices. When none does, since the field ends where they
/// begin or they rest, there is nothing to write.
void refuse_if_nowhere(const LineRequest& request, const IntegratedLines& result) {
  const auto& offsets = result.lines.offsets;
  for (std::size_t i = 1; i < offsets.size(); ++i)
    if (offsets[i] > offsets[i - 1] + 1) return;
  throw InputError(fmt::format("seeds: no line comes of {}, the first at {}; {}",
                               request.seeds.size(), in_words(request.seeds.front()),
                               ended_in_words(result.stats.ends, *request.field)));
}

/// What the lines of one direction may have; a line has two at least.
std::uint64_t vertex_budget(const LineRequest& request, std::uint64_t max_vertices) {
  const std::uint64_t budget = request.both ? max_vertices / 2 : max_vertices;
  if (budget / 2 < request.seeds.size())
    throw InputError(fmt::format("max-vertices={}; accepted: at least 2 of each of {} lines{}",
                                 max_vertices, request.seeds.size(),
                                 request.both ? ", in both directions" : ""));
  return budget;
}

/// Runs `one(options, seed, most_vertices, sampler)` for all seeds in parallel.
template <class One>
IntegratedLines run_all(const LineRequest& request, const SteppingOptions& stepping, bool path,
                        std::uint64_t max_vertices, const One& one) {
  const Stopwatch watch;
  const Journey journey{request.duration, request.start_time, path};
  const TrajectoryOptions options =
      trajectory_options(*request.field, journey, seeds_extent(request, path), stepping);
  const Box3 domain = request.field->domain();
  tbb::enumerable_thread_specific<CountingSampler> samplers(
      [&] { return CountingSampler(*request.field); });
  CountedProgress integrated(request.progress, request.seeds.size(), "lines");
  const std::vector<Line> lines =
      lines_within<Line>(vertex_budget(request, max_vertices), request.seeds.size(),
                         [&](std::size_t i, std::uint64_t most_vertices) {
                           const Vec3 seed = onto_edge(domain, request.seeds[i]);
                           Line line = one(options, seed, most_vertices, samplers.local());
                           integrated.add(1);
                           return line;
                         });
  IntegratedLines result = joined(lines);
  for (const auto& [reason, count] : result.stats.ends) result.stats.particles += count;
  for (const CountingSampler& sampler : samplers) result.stats.evaluations += sampler.evaluations();
  // Position and three scalars, once in the single lines and once in the set.
  result.stats.bytes = result.lines.positions.size() * 2 * sizeof(Line::Point);
  result.stats.seconds = watch.seconds();
  return result;
}

VertexSpacing spacing_of(const LineRequest& request, const FollowingOptions& options) {
  constexpr double radians = 0.017453292519943295769;
  return {positive("step", options.step, 0), radians * options.turn, request.duration / 20};
}

template <bool path>
IntegratedLines run_following(const LineRequest& request, const Parameters& parameters) {
  const FollowingOptions options = following_options().read(parameters);
  const VertexSpacing spacing = spacing_of(request, options);
  return run_all(request, options.stepping, path, options.max_vertices,
                 [&](const TrajectoryOptions& trajectory, const Vec3& seed,
                     std::uint64_t most_vertices, fields::FieldSampler& sampler) {
                   return follow(trajectory, seed, spacing, most_vertices, sampler);
                 });
}

IntegratedLines run_streaks(const LineRequest& request, const Parameters& parameters) {
  const StreakOptions options = streak_options().read(parameters);
  check_end(*request.field, {request.duration, request.start_time, true});
  return run_all(request, options.stepping, true, options.max_vertices,
                 [&](const TrajectoryOptions& trajectory, const Vec3& seed,
                     std::uint64_t most_vertices, fields::FieldSampler& sampler) {
                   return streak(trajectory, seed, options.releases, most_vertices, sampler);
                 });
}

int following_particles(const Parameters& parameters) {
  return following_options().read(parameters).particles;
}
int streak_particles(const Parameters& parameters) {
  return streak_options().read(parameters).particles;
}

constexpr std::string_view survey =
    "McLoughlin et al. 2010, Over Two Decades of Integration-Based, Geometric Flow Visualization";

}  // namespace

std::span<const LineIntegratorRow> line_integrators() {
  const auto following = following_options().specs(), streaks = streak_options().specs();
  static const LineIntegratorRow rows[] = {
      {"stream-lines", "Stream lines: the field stands still at the start time", survey, following,
       following_particles, false, run_following<false>},
      {"path-lines", "Path lines: the field's time runs along", survey, following,
       following_particles, true, run_following<true>},
      {"streak-lines", "Streak lines: particles let go at a seed one after another", survey,
       streaks, streak_particles, true, run_streaks},
  };
  return rows;
}

namespace {

struct RowAndParameters {
  const LineIntegratorRow& row;
  Parameters parameters;
};

RowAndParameters parse(std::string_view integrator) {
  const NameAndOptions parsed = parse_name_and_options(integrator);
  const LineIntegratorRow& row = find_row("line integrator", parsed.name, line_integrators());
  return {row, Parameters(row.name, row.parameters, parsed.options)};
}

}  // namespace

int line_particles(std::string_view integrator) {
  const auto [row, parameters] = parse(integrator);
  return row.particles(parameters);
}

void check_seeds_are_points(std::string_view integrator) {
  const RawOptions options = parse_name_and_options(integrator).options;
  if (const auto given = options.find("particles"); given != options.end() && given->second != "1")
    throw InputError(
        fmt::format("{}: particles={}: one starts at each seed that is a point; "
                    "accepted: without it, or a curve of seeds",
                    integrator, given->second));
}

void check_runs_along(std::string_view option, std::string_view integrator) {
  const LineIntegratorRow& row = parse(integrator).row;
  if (row.runs_along) return;
  std::string others;
  for (const LineIntegratorRow& other : line_integrators())
    if (other.runs_along) others += fmt::format("{}{}", others.empty() ? "" : ", ", other.name);
  throw InputError(fmt::format("{}: {}: the field stands still at the start time; accepted: {}",
                               option, row.name, others));
}

IntegratedLines integrate_lines(std::string_view integrator, const LineRequest& request) {
  const auto [row, parameters] = parse(integrator);
  check(request);
  IntegratedLines result =
      run_in_directions(request, [&, &row = row, &parameters = parameters](const LineRequest& one) {
        return row.run(one, parameters);
      });
  refuse_if_nowhere(request, result);
  geometry::check_finite(row.name, result.lines);
  return result;
}

std::vector<Vec3> seeds_on(const SeedCurve& curve, int count) {
  std::vector<Vec3> seeds;
  const int intervals = curve.closed ? count : count - 1;
  for (int i = 0; i < count; ++i)
    seeds.push_back(curve.point_at(intervals > 0 ? double(i) / intervals : 0.5));
  return seeds;
}

std::vector<Vec3> seeds_in(const Box3& box, int nx, int ny, int nz) {
  const auto part = [](int i, int n) { return n > 1 ? double(i) / (n - 1) : 0.5; };
  std::vector<Vec3> seeds;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        seeds.push_back(box.min +
                        Vec3(part(i, nx), part(j, ny), part(k, nz)) * (box.max - box.min));
  return seeds;
}

}  // namespace pellucid::integrators
