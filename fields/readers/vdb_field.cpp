// SPDX-License-Identifier: GPL-3.0-or-later
// The vector grid of an OpenVDB file. Where its active voxels fill a box it becomes a dense array,
// whose look-ups are several times faster; otherwise each sampler keeps one accessor. Samples
// exist where all voxels of the stencil are active: the background never leaks in.

#include "fields/readers/vdb_field.h"

#include <fmt/format.h>

#include <cmath>

#include "core/files/bad_file.h"
#include "fields/files/grid_choice.h"
#include "fields/files/staggered_grid.h"
#include "fields/files/vdb_box.h"
#include "fields/files/vdb_values.h"
#include "fields/finite.h"
#include "fields/lazy.h"
#include "fields/readers/vdb_components.h"
#include "fields/readers/vdb_sampler.h"
#include "fields/sampled/dense_field.h"
#include "readers/vdb/vdb_file.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

template <class Grid>
class VdbField final : public VectorField {
 public:
  VdbField(typename Grid::ConstPtr grid, const GridFrame& frame, std::string description)
      : grid_(std::move(grid)), frame_(frame), description_(std::move(description)) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<VdbSampler<Grid>>(*grid_, frame_);
  }
  Box3 domain() const override {
    const openvdb::CoordBBox box = grid_->evalActiveVoxelBoundingBox();
    return frame_.world_box({Vec3(box.min().x(), box.min().y(), box.min().z()),
                             Vec3(box.max().x(), box.max().y(), box.max().z())});
  }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override { return frame_.smallest_unit(); }

  std::optional<double> sampling_error() const override {
    return sampling_error_.get([this] { return estimate_sampling_error(); });
  }
  std::string description() const override { return description_; }

 private:
  /// As for a dense grid: second differences along the axes over 8, where three voxels are active.
  double estimate_sampling_error() const {
    double largest = 0;
    const auto accessor = grid_->getConstAccessor();
    for (auto voxel = grid_->cbeginValueOn(); voxel; ++voxel) {
      if (!voxel.isVoxelValue()) continue;  // a tile is constant
      const openvdb::Coord at = voxel.getCoord();
      double error = 0;
      for (int axis = 0; axis < 3; ++axis) {
        openvdb::Coord step(0);
        step[axis] = 1;
        typename Grid::ValueType before, behind;
        if (accessor.probeValue(at - step, before) && accessor.probeValue(at + step, behind))
          error += (before - voxel.getValue() * 2 + behind).length() / 8;
      }
      if (std::isfinite(error)) largest = std::max(largest, error);
    }
    return largest;
  }

  typename Grid::ConstPtr grid_;
  GridFrame frame_;
  std::string description_;
  Lazy<double> sampling_error_;
};

GridFrame frame_of(const openvdb::GridBase& grid, const Path& path) {
  if (!grid.transform().isLinear()) bad_file(path, "its transform is not affine");
  const openvdb::Mat4d m = readers::affine_of(grid);
  Mat3 world_from_index;  // OpenVDB multiplies rows from the left
  for (int j = 0; j < 3; ++j) world_from_index[j] = Vec3(m(j, 0), m(j, 1), m(j, 2));
  const GridFrame frame{glm::inverse(world_from_index), Vec3(m(3, 0), m(3, 1), m(3, 2))};
  if (!is_finite(world_from_index) || !is_finite(frame.grid_from_world) || !is_finite(frame.origin))
    bad_file(path, "its transform is not finite, or flat");
  return frame;
}

template <class Grid>
std::unique_ptr<VectorField> make_dense(Grid& grid, const openvdb::CoordBBox& box,
                                        const GridFrame& frame, Interpolation interpolation,
                                        std::string description) {
  const openvdb::Coord size = box.dim();
  const auto axis = [&](int a) { return Axis::uniform(box.min()[a], 1, std::size_t(size[a])); };
  using Sample = glm::vec<3, typename Grid::ValueType::ValueType>;
  DenseGrid<Sample> dense{
      {axis(0), axis(1), axis(2)},
      values_in(grid, box, GridUse::emptied,
                [](const typename Grid::ValueType& v) { return Sample(v[0], v[1], v[2]); }),
      frame};
  return make_dense_field(std::move(dense), interpolation, std::move(description));
}

/// Voxels that the file does not hold one by one are spread out where they are few, 200 MB of
/// floats.
template <class Grid>
bool is_dense(const Grid& grid, const openvdb::CoordBBox& box) {
  constexpr double most_of_tiles = 1 << 24;
  const openvdb::Coord size = box.dim();
  if (std::min({size.x(), size.y(), size.z()}) < 2 || !fills_a_box(grid, box)) return false;
  return grid.tree().activeTileCount() == 0 || box.dim().asVec3d().product() <= most_of_tiles;
}

template <class Grid>
std::unique_ptr<VectorField> make_vdb_field(typename Grid::Ptr grid, const FileOptions& options,
                                            const Path& path) {
  const GridFrame frame = frame_of(*grid, path);
  const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
  if (box.empty()) bad_file(path, fmt::format("grid '{}' has no active voxels", grid->getName()));
  const std::string description =
      fmt::format("{}: {} active voxels of {}", path.filename().string(), grid->activeVoxelCount(),
                  grid->getName());
  if (is_dense(*grid, box))
    return make_dense(*grid, box, frame, options.interpolation, description);
  if (options.interpolation == Interpolation::c1)
    bad_file(path,
             "sampler=c1 needs active voxels that fill a box, and of tiles 2^24 at most; this grid "
             "takes "
             "sampler=linear");
  return std::make_unique<VdbField<Grid>>(grid, frame, description + ", linear");
}

void require_tree(const readers::VdbGrid& grid, const Path& path) {
  if (!grid.grid)
    bad_file(path,
             fmt::format("grid '{}', of {}, is of a kind or a tree that is not read; accepted: "
                         "of float, double, vec3s or vec3d, in a tree of 5, 4, 3",
                         grid.name, grid.value_type));
}

openvdb::GridBase::Ptr joined(std::span<const readers::VdbGrid> grids,
                              const std::array<std::size_t, 3>& three, const Path& path) {
  std::array<const readers::VdbGrid*, 3> parts{};
  for (std::size_t k = 0; k < 3; ++k) {
    parts[k] = &grids[three[k]];
    require_tree(*parts[k], path);
  }
  return joined_components(parts, path);
}

/// As choose_components() takes it: a scalar is the first of three grids of one number.
std::string wanted_grids(const FileOptions& options) {
  const std::string& name = wanted_array(options);
  return options.quantity == Quantity::scalar ? fmt::format("{0},{0},{0}", name) : name;
}

/// The grid that is meant, or the three.
openvdb::GridBase::Ptr choose_grid(std::span<const readers::VdbGrid> grids,
                                   const FileOptions& options, const Path& path) {
  std::vector<GridEntry> entries;
  for (const readers::VdbGrid& grid : grids)
    entries.push_back({grid.name, grid.value_type, readers::holds_vectors(grid)});
  if (const auto three = choose_components(entries, wanted_grids(options))) {
    keep_array(options, wanted_array(options));
    return joined(grids, *three, path);
  }
  if (options.quantity == Quantity::scalar)
    bad_file(path, fmt::format("no scalar '{}'; accepted: a grid of float or double; grids: {}",
                               wanted_array(options), describe_grids(entries)));
  const readers::VdbGrid& chosen =
      grids[choose_vector_grid(entries, wanted_array(options), path.string())];
  keep_array(options, chosen.name);
  require_tree(chosen, path);
  const bool is_staggered = chosen.grid->getGridClass() == openvdb::GRID_STAGGERED;
  if (is_staggered && !options.average_faces)
    bad_file(path, fmt::format("grid '{}' is staggered; accepted: with staggered=averaged, or "
                               "resampled to one position per voxel",
                               chosen.name));
  return at_centres(chosen.grid, fmt::format("{}: grid '{}'", path.string(), chosen.name));
}

}  // namespace

std::unique_ptr<VectorField> field_of(std::span<const readers::VdbGrid> grids,
                                      const FileOptions& options, const Path& path) {
  const openvdb::GridBase::Ptr grid = choose_grid(grids, options, path);
  if (const auto doubles = openvdb::gridPtrCast<openvdb::Vec3DGrid>(grid))
    return make_vdb_field<openvdb::Vec3DGrid>(doubles, options, path);
  return make_vdb_field<openvdb::Vec3SGrid>(openvdb::gridPtrCast<openvdb::Vec3SGrid>(grid), options,
                                            path);
}

namespace {

/// Of the grids that are not meant only names and types are read where a name is given.
std::unique_ptr<VectorField> read_vdb_field(const Path& path, const FileOptions& options) {
  refuse_grid_options(options, path);
  return field_of(readers::read_vdb_grids(path, wanted_grids(options)), options, path);
}

}  // namespace

std::vector<FileFormatRow> vdb_formats() {
  return {
      {".vdb", "OpenVDB", read_vdb_field,
       "a staggered grid with staggered=averaged: the means of both faces, in the middle of each "
       "voxel that has both; isosurfaces take them"}};
}

}  // namespace pellucid::fields
