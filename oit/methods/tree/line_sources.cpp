// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/tree/line_sources.h"

#include <cmath>
#include <numeric>

namespace pellucid::oit {
namespace {

/// The step by which lines are taken: the part of n that is nearest to the golden ratio's and has
/// no divisor in common with n, so that every line comes once. See integrators::LineSeeds.
std::uint64_t golden_step(std::uint64_t n) {
  auto step = std::uint64_t(0.6180339887498949 * double(n));
  while (std::gcd(step, n) != 1) ++step;
  return step;
}

template <class T>
void append(const std::vector<T>& from, std::uint64_t first, std::uint64_t last,
            std::vector<T>& to) {
  if (from.empty()) return;
  to.insert(to.end(), from.begin() + std::ptrdiff_t(first), from.begin() + std::ptrdiff_t(last));
}

/// Appends what is drawn of line k.
void append_line(const geometry::LineSet& from, std::uint64_t k, geometry::LineSet& to) {
  const std::uint64_t first = from.offsets[k], last = from.offsets[k + 1];
  append(from.positions, first, last, to.positions);
  append(from.normals, first, last, to.normals);
  append(from.colors, first, last, to.colors);
  to.offsets.push_back(to.positions.size());
}

/// Appends the radii of the points of line k, unless all are one.
void append_radii(const scene::LineObject& from, std::uint64_t k, std::vector<double>& to) {
  if (!from.radius.vary()) return;
  for (std::uint64_t i = from.set.offsets[k]; i < from.set.offsets[k + 1]; ++i)
    to.push_back(from.radius.at(i));
}

/// Lines first … first + count - 1 of the order in which they are taken.
scene::SceneObject some_lines(const scene::SceneObject& object, std::uint64_t first,
                              std::uint64_t count) {
  const auto& all = std::get<scene::LineObject>(object.shape);
  const std::uint64_t n = all.set.line_count(), step = golden_step(n);
  scene::LineObject some;
  some.profile = all.profile;
  std::vector<double> radii;
  for (std::uint64_t i = first; i < first + count; ++i) {
    append_line(all.set, i * step % n, some.set);
    append_radii(all, i * step % n, radii);
  }
  some.radius = all.radius.vary() ? scene::Radii(std::move(radii)) : all.radius;
  scene::SceneObject drawn{object.name, std::move(some)};
  drawn.lighting = object.lighting;
  return drawn;
}

}  // namespace

std::uint64_t LineSources::add_surface(const scene::SceneObject& object, const scene::Scene& scene,
                                       const scene::DepthRange& range, std::uint64_t lines,
                                       const StripOptions& options, const PrimitiveRange& place) {
  const auto strips = std::make_shared<SurfaceStrips>(object, scene, range, lines, options);
  sources_.push_back({lines, [strips, &object](std::uint64_t first, std::uint64_t count) {
                        scene::SceneObject made;
                        made.shape = strips->lines(first, count);
                        made.lighting = object.lighting;
                        return made;
                      }});
  places_.push_back(place);
  return strips->bytes();
}

void LineSources::add_lines(const scene::SceneObject& object, const PrimitiveRange& place) {
  const std::uint64_t lines = std::get<scene::LineObject>(object.shape).set.line_count();
  sources_.push_back({lines, [&object](std::uint64_t first, std::uint64_t count) {
                        return some_lines(object, first, count);
                      }});
  places_.push_back(place);
}

std::uint64_t LineSources::line_count() const {
  std::uint64_t count = 0;
  for (const Source& source : sources_) count += source.lines;
  return count;
}

LineSources::LineBatch LineSources::batch(std::uint64_t first, std::uint64_t count) const {
  const double all = double(line_count());
  LineBatch batch;
  for (const Source& source : sources_) {
    // All of its lines when all lines of all sources are asked for.
    const auto before = [&](std::uint64_t n) {
      return std::uint64_t(std::floor(double(n) / all * double(source.lines)));
    };
    const std::uint64_t begin = before(first), end = before(first + count);
    batch.objects.push_back(source.make(begin, end - begin));
    batch.lines += end - begin;
  }
  return batch;
}

}  // namespace pellucid::oit
