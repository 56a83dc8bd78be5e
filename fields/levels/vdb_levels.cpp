// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/vdb_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"
#include "fields/files/grid_choice.h"
#include "fields/files/staggered_grid.h"
#include "fields/files/vdb_box.h"
#include "fields/files/vdb_values.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/narrow_band.h"
#include "readers/vdb/vdb_file.h"

namespace pellucid::fields {
namespace {

namespace fs = std::filesystem;

constexpr double affine_rounding = 1e-9;  // of a voxel, in the transform of cubes along the axes

constexpr double most_voxels = 0x1p30;  // of a level

glm::vec3 sample_of(const openvdb::Vec3s& v) { return {v[0], v[1], v[2]}; }
Vec3 sample_of(const openvdb::Vec3d& v) { return {v[0], v[1], v[2]}; }
float sample_of(float v) { return v; }
double sample_of(double v) { return v; }

/// Sets origin and width of the level whose first sample has the index `first`.
template <class T>
void place(const openvdb::GridBase& grid, const openvdb::Coord& first, const std::string& name,
           Level<T>& level) {
  if (!grid.transform().isLinear())
    throw InputError(fmt::format("{}: its transform is not affine; accepted: cubes", name));
  const openvdb::Mat4d m = readers::affine_of(grid);
  level.width = m(0, 0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (const double wanted = row == column ? level.width : 0;
          !(std::abs(m(row, column) - wanted) <= affine_rounding * level.width))
        throw InputError(fmt::format(
            "{}: its voxels are not cubes along the axes; accepted: one width, no rotation", name));
  const openvdb::Vec3d origin = m.transform(first.asVec3d());
  level.origin = {origin[0], origin[1], origin[2]};
}

/// Of a level set the band says more than the level does: it keeps its voxels.
template <class Grid>
auto level_of(Grid& grid, const std::string& name) {
  Level<decltype(sample_of(typename Grid::ValueType()))> level;
  const openvdb::CoordBBox box = box_of_values(grid);
  if (box.empty()) throw InputError(fmt::format("{}: it has no active voxels", name));
  if (!fills_a_box(grid, box) && !has_values_beyond(grid))
    throw InputError(
        fmt::format("{}: its active voxels do not fill a box; accepted: a full box per level, a "
                    "level set, a fog "
                    "volume",
                    name));
  if (const openvdb::Vec3d size = box.dim().asVec3d(); size.product() > most_voxels)
    throw InputError(
        fmt::format("{}: its box has {} voxels; accepted: at most 2^30", name, size.product()));
  place(grid, box.min(), name, level);
  const openvdb::Coord size = box.dim();
  level.size = {size.x(), size.y(), size.z()};
  level.samples = values_in(
      grid, box, grid.getGridClass() == openvdb::GRID_LEVEL_SET ? GridUse::kept : GridUse::emptied,
      [](const typename Grid::ValueType& value) { return sample_of(value); });
  check_level(name, level);
  return level;
}

/// The levels of the grids of this kind of values.
template <class Grid>
auto levels_of_kind(std::span<const openvdb::GridBase::Ptr> grids, const std::string& name) {
  std::vector<decltype(level_of(std::declval<Grid&>(), name))> levels;
  for (const openvdb::GridBase::Ptr& grid : grids)
    if (const auto typed = openvdb::gridPtrCast<Grid>(grid))
      levels.push_back(level_of(*typed, name));
  return levels;
}

ExactLevels scalar_levels(std::span<const openvdb::GridBase::Ptr> grids, const std::string& name) {
  ExactLevels levels = levels_of_kind<openvdb::FloatGrid>(grids, name);
  append(exact(levels_of_kind<openvdb::DoubleGrid>(grids, name)), levels);
  return levels;
}

ExactLevels derived_levels(std::span<const openvdb::GridBase::Ptr> grids, const std::string& name,
                           std::string_view scalar) {
  ExactLevels levels = scalars_of(levels_of_kind<openvdb::Vec3SGrid>(grids, name), scalar);
  append(exact(scalars_of(levels_of_kind<openvdb::Vec3DGrid>(grids, name), scalar)), levels);
  return levels;
}

std::vector<GridEntry> entries_of(std::span<const readers::VdbGrid> grids) {
  std::vector<GridEntry> entries;
  for (const readers::VdbGrid& grid : grids)
    entries.push_back({grid.name, grid.value_type, readers::holds_vectors(grid)});
  return entries;
}

std::vector<openvdb::GridBase::Ptr> grids_called(std::span<const readers::VdbGrid> grids,
                                                 std::string_view name) {
  std::vector<openvdb::GridBase::Ptr> found;
  for (const readers::VdbGrid& grid : grids)
    if (grid.name == name && grid.grid) found.push_back(grid.grid);
  return found;
}

Vec2 joined(const Vec2& a, const Vec2& b) { return {std::min(a.x, b.x), std::max(a.y, b.y)}; }

/// Of the active voxels, tiles among them.
template <class Grid>
Vec2 active_range(const Grid& grid) {
  Vec2 range = sample_range({});
  for (auto value = grid.cbeginValueOn(); value; ++value)
    range = joined(range, Vec2(sample_of(*value)));
  return range;
}

/// Of a level set of numbers; none of another grid.
std::optional<Vec2> band_range(const openvdb::GridBase::Ptr& grid) {
  if (!grid || grid->getGridClass() != openvdb::GRID_LEVEL_SET) return std::nullopt;
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid))
    return active_range(*floats);
  if (const auto doubles = openvdb::gridPtrCast<openvdb::DoubleGrid>(grid))
    return active_range(*doubles);
  return std::nullopt;
}

openvdb::Vec3s voxel_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }
float voxel_of(float v) { return v; }

template <class T>
openvdb::GridBase::Ptr grid_of(const std::string& name, const Level<T>& level) {
  using Voxel = decltype(voxel_of(T()));
  using Tree = typename openvdb::tree::Tree4<Voxel, 5, 4, 3>::Type;
  const auto grid = openvdb::Grid<Tree>::create();
  grid->setName(name);
  const auto transform = openvdb::math::Transform::createLinearTransform(level.width);
  transform->postTranslate({level.origin.x, level.origin.y, level.origin.z});
  grid->setTransform(transform);
  auto accessor = grid->getAccessor();
  for (int k = 0; k < level.size[2]; ++k)
    for (int j = 0; j < level.size[1]; ++j)
      for (int i = 0; i < level.size[0]; ++i)
        accessor.setValueOn({i, j, k}, voxel_of(level.at(i, j, k)));
  return grid;
}

/// OpenVDB does not notice a disk that is full: what it has written is read back.
void check_written(const fs::path& written, const fs::path& path,
                   const openvdb::GridPtrVec& grids) {
  const auto fails = [&] {
    throw WorkError(fmt::format("{}: cannot write: is the disk full?", path.string()));
  };
  try {
    const auto back = readers::read_vdb_grids(written);
    if (back.size() != grids.size()) fails();
    for (std::size_t i = 0; i < grids.size(); ++i)
      if (!back[i].grid || back[i].grid->activeVoxelCount() != grids[i]->activeVoxelCount())
        fails();
  } catch (const InputError&) {
    fails();
  }
}

template <class T>
void write(const fs::path& path, const std::string& name, std::span<const Level<T>> levels) {
  if (small_ending(path) != ".vdb")
    bad_file(path, fmt::format("ending '{}'; accepted: .vdb", path.extension().string()));
  if (levels.empty()) bad_file(path, "no level to write");
  openvdb::initialize();
  openvdb::GridPtrVec grids;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    check_level(fmt::format("level {}", i), levels[i]);
    grids.push_back(grid_of(name, levels[i]));
  }
  OutputFile out(path);
  try {
    openvdb::io::File(out.temporary().string()).write(grids);
  } catch (const openvdb::Exception& error) {
    throw WorkError(fmt::format("{}: {}", path.string(), error.what()));
  }
  check_written(out.temporary(), path, grids);
  out.commit();
}

}  // namespace

void write_vdb_levels(const fs::path& path, const std::string& name,
                      std::span<const ScalarLevel> levels) {
  write(path, name, levels);
}
void write_vdb_levels(const fs::path& path, const std::string& name,
                      std::span<const VectorLevel> levels) {
  write(path, name, levels);
}

Vec2 value_range(std::span<const readers::VdbGrid> grids, std::string_view scalar,
                 const ExactLevels& levels) {
  Vec2 range = sample_range({});
  std::size_t bands = 0;
  for (const readers::VdbGrid& grid : grids)
    if (const auto band = grid.name == scalar ? band_range(grid.grid) : std::nullopt) {
      range = joined(range, *band);
      ++bands;
    }
  const std::size_t count = std::visit([](const auto& all) { return all.size(); }, levels);
  return bands == count ? range : joined(range, sample_range(levels));
}

ValueGaps value_gaps(std::span<const readers::VdbGrid> grids, std::string_view scalar) {
  ValueGaps gaps;
  for (const readers::VdbGrid& grid : grids)
    if (grid.name == scalar) add_gaps_beyond_band(grid.grid, gaps);
  return gaps;
}

ExactLevels levels_of(std::span<const readers::VdbGrid> grids, const fs::path& path,
                      std::string_view scalar, std::string_view velocity) {
  const std::vector<GridEntry> entries = entries_of(grids);
  const std::string place = path.string();
  const auto name_in_file = [&](std::string_view name) {
    return fmt::format("{}: grid {}", place, name);
  };
  // Stored under that name, it need not be derived.
  if (ExactLevels levels = scalar_levels(grids_called(grids, scalar), name_in_file(scalar));
      !is_empty(levels))
    return levels;
  if (!is_derived(scalar) || std::ranges::none_of(entries, &GridEntry::vector))
    bad_file(path, fmt::format("no grid has the scalar '{}'; grids: {}", scalar,
                               describe_grids(entries)));
  const std::string chosen = choose_velocity(entries, velocity, place);
  std::vector<openvdb::GridBase::Ptr> velocities = grids_called(grids, chosen);
  for (openvdb::GridBase::Ptr& grid : velocities) grid = at_centres(grid, name_in_file(chosen));
  return derived_levels(velocities, name_in_file(chosen), scalar);
}

}  // namespace pellucid::fields
