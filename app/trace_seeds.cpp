// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trace_seeds.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/options/keyed_words.h"
#include "core/options/parameters.h"
#include "core/options/split.h"
#include "geometry/files/mesh_file.h"
#include "geometry/files/mesh_formats.h"
#include "integrators/lines/integrate_lines.h"

namespace pellucid::app {
namespace {

constexpr std::string_view circle_prefix = "circle:", grid_prefix = "grid:";
constexpr double most_seeds = 1e7;  // of a grid

/// What a text stands for: points, of lines one each; a curve, of lines evenly many; or both.
struct Seeds {
  std::vector<Vec3> points;
  std::optional<integrators::SeedCurve> curve;
};

Vec3 parse_point(std::string_view text) {
  const auto parts = split(text, ',');
  Vec3 x;
  bool valid = parts.size() == 3;
  for (int i = 0; valid && i < 3; ++i) valid = parse_number(parts[std::size_t(i)], x[i]);
  if (!valid)
    throw InputError(fmt::format("--seed: '{}'; accepted: X,Y,Z:X,Y,Z[:...] in numbers", text));
  return x;
}

Seeds polyline(std::string_view text, bool closed) {
  std::vector<Vec3> points;
  for (const std::string_view point : split(text, ':')) points.push_back(parse_point(point));
  if (points.size() == 1) return {points, std::nullopt};
  return {{}, integrators::polyline_seed(points, closed)};
}

integrators::SeedCurve circle(std::string_view text) {
  constexpr std::array<std::string_view, 3> keys{"center", "radius", "normal"};
  constexpr std::string_view option = "--seeds circle";
  const KeyedWords words = keyed_words(option, text, keys);
  return integrators::circle_seed(vector_of_key(option, words, "center"),
                                  vector_of_key(option, words, "normal"),
                                  number_of_key(option, words, "radius"));
}

std::vector<Vec3> grid(std::string_view text) {
  constexpr std::array<std::string_view, 3> keys{"from", "to", "count"};
  constexpr std::string_view option = "--seeds grid";
  const KeyedWords words = keyed_words(option, text, keys);
  const Vec3 from = vector_of_key(option, words, "from"), to = vector_of_key(option, words, "to"),
             count = vector_of_key(option, words, "count");
  const bool whole = count == glm::floor(count) && count.x >= 1 && count.y >= 1 && count.z >= 1;
  if (!whole || count.x * count.y * count.z > most_seeds)
    throw InputError(
        fmt::format("{}: count={:.15g},{:.15g},{:.15g}; accepted: three whole numbers from 1 on, "
                    "{:.0f} seeds in all at most",
                    option, count.x, count.y, count.z, most_seeds));
  return integrators::seeds_in({from, to}, int(count.x), int(count.y), int(count.z));
}

/// The lines of a file that may hold points instead.
std::optional<geometry::LineSet> lines_of(const std::string& file) {
  const geometry::FormatRow* format = geometry::mesh_format(file);
  if (!format || !format->read_lines) return std::nullopt;
  if (!format->read_points && !format->read_mesh) return geometry::read_lines(file);
  try {
    return geometry::read_lines(file);
  } catch (const InputError&) {
    return std::nullopt;  // reading its points says what is wrong, if anything is
  }
}

/// The points of a file, or a mesh's vertices where its format knows no points.
std::vector<Vec3> points_of(const std::string& file) {
  const geometry::FormatRow* format = geometry::mesh_format(file);
  if (format && format->read_mesh && !format->read_points)
    return geometry::read_mesh(file).positions;
  return geometry::read_points(file).positions;
}

integrators::SeedCurve curve_of(const std::string& file, const geometry::LineSet& lines,
                                bool closed) {
  std::optional<std::size_t> only;
  std::size_t count = 0;
  for (std::size_t k = 0; k < lines.line_count(); ++k)
    if (lines.offsets[k + 1] - lines.offsets[k] > 1) only = k, ++count;
  if (count != 1)
    throw InputError(
        fmt::format("--seeds: {}: it holds {} polylines; accepted: one, or points", file, count));
  const auto first = lines.positions.begin() + std::ptrdiff_t(lines.offsets[*only]);
  const auto end = lines.positions.begin() + std::ptrdiff_t(lines.offsets[*only + 1]);
  return integrators::polyline_seed({first, end}, closed || *first == *(end - 1));
}

Seeds of_file(const std::string& file, bool closed) {
  if (const auto lines = lines_of(file)) return {{}, curve_of(file, *lines, closed)};
  return {points_of(file), std::nullopt};
}

Seeds of_seeds(const SeedTexts& texts) {
  const std::string_view text = texts.seeds;
  const bool is_circle = text.starts_with(circle_prefix), is_grid = text.starts_with(grid_prefix);
  if (texts.closed && (is_circle || is_grid))
    throw InputError("--closed: accepted: with --seed, or with a file as --seeds");
  if (is_circle) return {{}, circle(text.substr(circle_prefix.size()))};
  if (is_grid) return {grid(text.substr(grid_prefix.size())), std::nullopt};
  return of_file(texts.seeds, texts.closed);
}

Seeds seeds_of(const SeedTexts& texts) {
  if (texts.seed.empty() == texts.seeds.empty())
    throw InputError(fmt::format("--seed, --seeds: {}; accepted: exactly one of them",
                                 texts.seed.empty() ? "neither is given" : "both are given"));
  return texts.seeds.empty() ? polyline(texts.seed, texts.closed) : of_seeds(texts);
}

}  // namespace

integrators::SeedCurve surface_seed(const SeedTexts& texts) {
  if (texts.seeds.starts_with(grid_prefix))
    throw InputError("--seeds: a grid is no curve; accepted of a surface: circle:…, or a file");
  const Seeds seeds = seeds_of(texts);
  return seeds.curve ? *seeds.curve : integrators::polyline_seed(seeds.points, texts.closed);
}

integrators::SeedSurface sheet_seed(const SeedTexts& texts) {
  constexpr std::string_view option = "--seeds", patch_prefix = "patch:", sphere_prefix = "sphere:";
  const std::string_view text = texts.seeds;
  if (text.empty() || !texts.seed.empty() || texts.closed)
    throw InputError(
        "--seeds: accepted of a time surface, alone: patch:corner=X,Y,Z,u=X,Y,Z,v=X,Y,Z, "
        "sphere:center=X,Y,Z,radius=R, or a FILE of a mesh");
  if (text.starts_with(patch_prefix)) {
    constexpr std::array<std::string_view, 3> keys{"corner", "u", "v"};
    const KeyedWords words = keyed_words(option, text.substr(patch_prefix.size()), keys);
    return integrators::patch_seed(vector_of_key(option, words, "corner"),
                                   vector_of_key(option, words, "u"),
                                   vector_of_key(option, words, "v"));
  }
  if (text.starts_with(sphere_prefix)) {
    constexpr std::array<std::string_view, 2> keys{"center", "radius"};
    const KeyedWords words = keyed_words(option, text.substr(sphere_prefix.size()), keys);
    return integrators::sphere_seed(vector_of_key(option, words, "center"),
                                    number_of_key(option, words, "radius"));
  }
  return integrators::mesh_seed(geometry::read_mesh(texts.seeds));
}

std::vector<Vec3> line_seeds(const SeedTexts& texts, const std::string& integrator) {
  const Seeds seeds = seeds_of(texts);
  if (!seeds.curve) {
    integrators::check_seeds_are_points(integrator);
    return seeds.points;
  }
  return integrators::seeds_on(*seeds.curve, integrators::line_particles(integrator));
}

}  // namespace pellucid::app
