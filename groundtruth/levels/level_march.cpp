// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/levels/level_march.h"

#include <algorithm>
#include <cmath>

#include "fields/levels/surface_cells.h"

namespace pellucid::groundtruth {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();
constexpr int block_side = 4;  // lattice cells
constexpr int halvings = 52;   // of a step: to the last bits of a double

/// The block that holds a lattice cell; the cells of a hat basis begin at -1.
std::array<int, 3> block_of(const std::array<int, 3>& cell) {
  return {(cell[0] + 1) / block_side, (cell[1] + 1) / block_side, (cell[2] + 1) / block_side};
}

/// The bit of a lattice cell among those of its block.
std::uint64_t bit_of(const std::array<int, 3>& cell) {
  const auto within = [&](int axis) { return (cell[std::size_t(axis)] + 1) % block_side; };
  return std::uint64_t(1) << (within(0) + block_side * (within(1) + block_side * within(2)));
}

/// From where to where the ray is within a box, from t = 0 on.
std::array<double, 2> within(const Box3& box, const WorldRay& ray) {
  double begin = 0, end = no_bound;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min[axis] - ray.start[axis], high = box.max[axis] - ray.start[axis];
    if (ray.direction[axis] == 0) {
      if (low > 0 || high < 0) end = 0;
      continue;
    }
    const auto [first, last] = std::minmax({low / ray.direction[axis], high / ray.direction[axis]});
    begin = std::max(begin, first);
    end = std::min(end, last);
  }
  return {begin, end};
}

bool is_inside(const std::optional<double>& height) { return height && *height >= 0; }

bool differ(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b && (*a < 0) != (*b < 0);
}

}  // namespace

LevelMarch::LevelMarch(const fields::LevelField& field, double value, const MarchOptions& options)
    : field_(field), value_(value), options_(options) {
  if (!options.skip_empty) return;
  for (const fields::ScalarLevel& level : field.levels()) {
    Blocks blocks{block_of(level.size), {}};
    for (int& n : blocks.size) ++n;
    blocks.occupied.resize(std::size_t(blocks.size[0]) * std::size_t(blocks.size[1]) *
                           std::size_t(blocks.size[2]));
    blocks_.push_back(std::move(blocks));
  }
  for (const fields::LatticeCell& cell : fields::surface_cells(field, value))
    blocks_[cell.level].occupied[block_index(cell.level, block_of(cell.low))] |= bit_of(cell.low);
}

std::size_t LevelMarch::block_index(std::uint32_t level, const std::array<int, 3>& block) const {
  const auto& size = blocks_[level].size;
  return std::size_t(block[0]) +
         std::size_t(size[0]) *
             (std::size_t(block[1]) + std::size_t(size[1]) * std::size_t(block[2]));
}

std::optional<double> LevelMarch::height_at(const Vec3& x,
                                            std::span<const std::uint32_t> levels) const {
  fields::LevelField::Cells cells;
  bool owned = false;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    cells[i] = field_.cell_at(levels[i], x);
    owned |= field_.reconstruction().kind != fields::Reconstruction::hat ||
             field_.domain(levels[i]).contains(x);
  }
  if (!owned) return std::nullopt;
  const auto [sum, weight] =
      field_.sum<double>(std::span(cells).first(levels.size()), {x.x, x.y, x.z}, value_);
  if (weight == 0) return std::nullopt;  // no hat reaches here
  return sum / weight;
}

bool LevelMarch::is_hit(const Sample& a, const Sample& b) const {
  if (options_.refinement == HitRefinement::sample)
    return !is_inside(a.height) && is_inside(b.height);
  return differ(a.height, b.height);
}

double LevelMarch::refined(const WorldRay& ray, std::span<const std::uint32_t> levels,
                           const Sample& a, const Sample& b) const {
  if (options_.refinement == HitRefinement::sample) return b.t;
  if (options_.refinement == HitRefinement::linear)
    return a.t + (b.t - a.t) * (*a.height / (*a.height - *b.height));
  double low = a.t, high = b.t;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    const auto height = height_at(ray.at(middle), levels);
    (height && !differ(height, a.height) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

LevelMarch::Stretch LevelMarch::stretch_at(const WorldRay& ray,
                                           std::span<const std::uint32_t> levels, double t) const {
  Stretch stretch{true, no_bound};
  for (const std::uint32_t level : levels) {
    const fields::ScalarLevel& l = field_.levels()[level];
    const std::array<int, 3> cell = field_.cell_at(level, ray.at(t)).low, block = block_of(cell);
    const std::uint64_t occupied = blocks_[level].occupied[block_index(level, block)];
    if (occupied & bit_of(cell)) stretch.empty = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = ray.direction[int(axis)];
      if (along == 0) continue;
      const int low = occupied ? cell[axis] : block[axis] * block_side - 1;
      const int face = low + (along > 0 ? (occupied ? 1 : block_side) : 0);
      const double plane = l.origin[int(axis)] + l.width * face;
      stretch.end = std::min(stretch.end, (plane - ray.start[int(axis)]) / along);
    }
  }
  return stretch;
}

// A box that holds two samples holds those between them.
bool LevelMarch::owns(std::uint32_t level, const WorldRay& ray, const Samples& samples) const {
  const Box3 domain = field_.domain(level);
  return domain.contains(ray.at(samples.at(1))) &&
         domain.contains(ray.at(samples.at(samples.before(samples.end))));
}

// Amanatides, Woo, A Fast Voxel Traversal Algorithm for Ray Tracing (1987).
double LevelMarch::end_of_empty_blocks(const WorldRay& ray, std::uint32_t level, double t,
                                       double end) const {
  const fields::ScalarLevel& l = field_.levels()[level];
  const Blocks& blocks = blocks_[level];
  std::array<int, 3> block = block_of(field_.cell_at(level, ray.at(t)).low);
  const auto next_face = [&](int axis) {
    const double along = ray.direction[axis];
    if (along == 0) return no_bound;
    const int face = (block[std::size_t(axis)] + (along > 0 ? 1 : 0)) * block_side - 1;
    return (l.origin[axis] + l.width * face - ray.start[axis]) / along;
  };
  std::array<double, 3> faces{next_face(0), next_face(1), next_face(2)};
  double left = t;
  while (left < end && blocks.occupied[block_index(level, block)] == 0) {
    const auto axis = std::size_t(std::ranges::min_element(faces) - faces.begin());
    left = faces[axis];
    block[axis] += ray.direction[int(axis)] > 0 ? 1 : -1;
    if (block[axis] < 0 || block[axis] >= blocks.size[axis]) return end;
    faces[axis] = next_face(int(axis));
  }
  return std::min(left, end);
}

// Samples of an empty stretch lie on one side. So do those of the next one, if it is empty, too,
// and both are of one level alone: cells that follow each other have a corner in common. Outside of
// its domain a level's hats may end between two samples.
double LevelMarch::last_alike(const WorldRay& ray, std::span<const std::uint32_t> levels,
                              const Samples& samples, double i, bool alone,
                              Stretch& stretch) const {
  double last = std::max(i, samples.before(stretch.end));
  if (!alone || i < 1) return last;
  while (stretch.empty) {
    const double next = samples.at(last + 1);
    if (next >= samples.end) break;
    stretch = stretch_at(ray, levels, next);
    if (!stretch.empty) break;
    const double end = end_of_empty_blocks(ray, levels.front(), next, samples.end);
    stretch.end = std::max(stretch.end, end);
    last = std::max(last + 1, samples.before(stretch.end));
  }
  return last;
}

void LevelMarch::visit_crossings(const WorldRay& ray,
                                 const std::function<bool(double)>& visit) const {
  const auto [begin, end] = within(field_.bounds(), ray);
  thread_local std::vector<fields::RegionTree::Part> parts;
  parts.clear();
  field_.tree().append_parts(ray.start, ray.direction, begin, end, parts);
  Sample last;
  for (const fields::RegionTree::Part& part : parts) {
    const double width = field_.levels()[part.levels.front()].width;
    const double step = width / options_.steps_per_cell / glm::length(ray.direction);
    const Samples samples{part.begin, step, part.end};
    const bool alone = part.levels.size() == 1 && owns(part.levels.front(), ray, samples);
    Sample at{part.begin, height_at(ray.at(part.begin), part.levels)};
    // A reconstruction that jumps crosses on the face; a field that begins inside is a hit to the
    // report.
    const bool may_begin_inside = options_.refinement == HitRefinement::sample;
    if ((last.t == at.t || may_begin_inside) && is_hit(last, at) && !visit(at.t)) return;
    Stretch stretch{false, blocks_.empty() ? no_bound : part.begin};
    for (double i = 0; at.t < part.end; ++i) {
      last = at;
      if (at.t >= stretch.end) {
        stretch = stretch_at(ray, part.levels, at.t);
        // The last sample on this one's side is the next to be taken.
        if (stretch.empty)
          i = std::max(i, last_alike(ray, part.levels, samples, i, alone, stretch) - 1);
      }
      at.t = samples.at(i + 1);
      at.height = height_at(ray.at(at.t), part.levels);
      if (is_hit(last, at) && !visit(refined(ray, part.levels, last, at))) return;
    }
    last = at;
  }
}

std::uint64_t LevelMarch::bytes() const {
  std::uint64_t bytes = 0;
  for (const Blocks& blocks : blocks_) bytes += blocks.occupied.size();
  return bytes;
}

}  // namespace pellucid::groundtruth
