// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/grid_blocks.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/files/pages.h"
#include "core/parallel.h"

namespace pellucid::readers {
namespace {

constexpr const char* affine_name = "pellucid.affine";  // of metadata
constexpr std::int32_t leaf_width = 8;
constexpr std::size_t leaf_size = 512, mask_words = 8, tile_words = 5;
/// Leaves after which the memory of those that are copied goes back to the system: 32 MiB of
/// floats, so that what is there twice is little, and what giving it back takes is little too.
constexpr std::size_t leaves_between = 1 << 14;
/// Coordinates of voxels stay below 2^30, a tile's 4096 voxels included: the width of any box is an
/// int then, and a loop up to its last voxel ends.
constexpr std::int32_t farthest = (1 << 30) - 4096;

template <class Value>
struct Components {
  using Number = Value;
  static constexpr std::uint32_t count = 1;
};
template <class Number_>
struct Components<openvdb::math::Vec3<Number_>> {
  using Number = Number_;
  static constexpr std::uint32_t count = 3;
};

/// Values of a grid as a block of their numbers.
template <class Value>
void add_values(const std::string& name, std::span<const Value> values, BlockWriter& out) {
  using Parts = Components<Value>;
  static_assert(sizeof(Value) == Parts::count * sizeof(typename Parts::Number));
  out.add(name, number_type<typename Parts::Number>(), Parts::count, values.size(), values.data());
}

template <class Value>
std::span<const Value> values_of(const Block& block) {
  using Parts = Components<Value>;
  if (block.components != Parts::count) block.fail("has another number of components");
  const auto numbers = block.values<typename Parts::Number>();
  return {reinterpret_cast<const Value*>(numbers.data()), block.tuples};
}

/// Writes the leaves, each of which loses its values when they are written.
template <class Grid>
void write_leaves(const std::string& prefix, Grid& grid, BlockWriter& out) {
  using Value = typename Grid::ValueType;
  using Leaf = typename Grid::TreeType::LeafNodeType;
  using Parts = Components<Value>;
  std::vector<std::int32_t> origins;
  std::vector<std::uint64_t> masks;
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    const openvdb::Coord origin = leaf->origin();
    origins.insert(origins.end(), {origin.x(), origin.y(), origin.z()});
    for (openvdb::Index word = 0; word < mask_words; ++word)
      masks.push_back(leaf->valueMask().template getWord<openvdb::Index64>(word));
  }
  out.add(prefix + ".origins", std::span<const std::int32_t>(origins), 3);
  out.add(prefix + ".masks", std::span<const std::uint64_t>(masks), mask_words);
  out.begin(prefix + ".values", number_type<typename Parts::Number>(), Parts::count,
            origins.size() / 3 * leaf_size);
  std::size_t written = 0;
  for (auto leaf = grid.tree().beginLeaf(); leaf; ++leaf) {
    typename Leaf::Buffer values(openvdb::PartialCreate(), grid.background());  // none yet
    leaf->swap(values);
    out.append(values.data(), leaf_size * sizeof(Value));
    if (++written % leaves_between == 0) ::malloc_trim(0);
  }
}

template <class Grid>
void write_tiles(const std::string& prefix, const Grid& grid, BlockWriter& out) {
  std::vector<std::int32_t> places;
  std::vector<typename Grid::ValueType> values;
  auto tile = grid.tree().cbeginValueAll();
  tile.setMaxDepth(decltype(tile)::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    if (!tile.isValueOn() && tile.getValue() == grid.background()) continue;
    const openvdb::Coord at = tile.getCoord();
    places.insert(places.end(), {std::int32_t(tile.getLevel()), at.x(), at.y(), at.z(),
                                 std::int32_t(tile.isValueOn())});
    values.push_back(tile.getValue());
  }
  out.add(prefix + ".tiles", std::span<const std::int32_t>(places), tile_words);
  add_values<typename Grid::ValueType>(prefix + ".tile_values", values, out);
}

template <class Grid>
void write_tree(const std::string& prefix, Grid& grid, BlockWriter& out) {
  const typename Grid::ValueType background = grid.background();
  add_values<typename Grid::ValueType>(prefix + ".background", {&background, 1}, out);
  write_leaves(prefix, grid, out);
  write_tiles(prefix, grid, out);
}

/// Throws BlockError for a place that is too far out; `what` is "leaf" or "tile".
void check_place(const std::string& prefix, std::string_view what, std::size_t number,
                 const openvdb::Coord& at) {
  for (int axis = 0; axis < 3; ++axis)
    if (at[axis] < -farthest || at[axis] > farthest)
      throw BlockError(fmt::format("grid {}: {} {} is at voxel {}; accepted: up to ±{}", prefix,
                                   what, number, at[axis], farthest));
}

/// The leaves of a grid as blocks have them.
template <class Grid>
class Leaves {
 public:
  using Leaf = typename Grid::TreeType::LeafNodeType;

  Leaves(const std::string& prefix, const Blocks& blocks)
      : prefix_(prefix),
        origins_(blocks.at(prefix + ".origins").values<std::int32_t>()),
        masks_(blocks.at(prefix + ".masks").values<std::uint64_t>()),
        values_(values_of<typename Grid::ValueType>(blocks.at(prefix + ".values"))) {
    if (masks_.size() != count() * mask_words || values_.size() != count() * leaf_size)
      throw BlockError(fmt::format("grid {}: its leaves do not fit each other", prefix));
    for (std::size_t i = 0; i < count(); ++i) check(i);
  }

  std::size_t count() const { return origins_.size() / 3; }

  /// Without memory for values.
  std::unique_ptr<Leaf> make(std::size_t i, const typename Grid::ValueType& background) const {
    auto leaf = std::make_unique<Leaf>(openvdb::PartialCreate(), origin(i), background);
    typename Leaf::NodeMaskType mask;
    for (openvdb::Index word = 0; word < mask_words; ++word)
      mask.template getWord<openvdb::Index64>(word) = masks_[i * mask_words + word];
    leaf->setValueMask(mask);
    return leaf;
  }
  void fill(std::size_t i, Leaf& leaf) const {
    leaf.allocate();
    std::copy_n(values_.data() + i * leaf_size, leaf_size, leaf.buffer().data());
  }

  /// Gives the memory of the values of these leaves back: they are made.
  void forget(std::size_t first, std::size_t count) const {
    forget_pages(values_.data() + first * leaf_size,
                 count * leaf_size * sizeof(typename Grid::ValueType));
  }

 private:
  openvdb::Coord origin(std::size_t i) const {
    return {origins_[3 * i], origins_[3 * i + 1], origins_[3 * i + 2]};
  }
  void check(std::size_t i) const {
    if (origin(i) != (origin(i) & ~(leaf_width - 1)))
      throw BlockError(fmt::format("grid {}: leaf {} is off its lattice", prefix_, i));
    check_place(prefix_, "leaf", i, origin(i));
  }

  std::string prefix_;
  std::span<const std::int32_t> origins_;
  std::span<const std::uint64_t> masks_;
  std::span<const typename Grid::ValueType> values_;
};

/// Leaves are filled on all threads, since touching their memory first is what takes long, and put
/// into the tree one after another. Of many leaves the blocks keep no values that the tree has. Nor
/// is a leaf's memory beside that of its values, which is full pages then when they are freed.
template <class Grid>
void read_leaves(const std::string& prefix, const Blocks& blocks, Grid& grid) {
  const Leaves<Grid> leaves(prefix, blocks);
  std::vector<std::unique_ptr<typename Leaves<Grid>::Leaf>> made(leaves_between);
  for (std::size_t first = 0; first < leaves.count(); first += made.size()) {
    made.resize(std::min(leaves.count() - first, leaves_between));
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = leaves.make(first + i, grid.background());
    parallel_for(std::size_t(0), made.size(),
                 [&](std::size_t i) { leaves.fill(first + i, *made[i]); });
    if (made.size() == leaves_between) leaves.forget(first, made.size());
    for (auto& leaf : made) grid.tree().addLeaf(leaf.release());
  }
}

template <class Grid>
void read_tiles(const std::string& prefix, const Blocks& blocks, Grid& grid) {
  const auto places = blocks.at(prefix + ".tiles").values<std::int32_t>();
  const auto values = values_of<typename Grid::ValueType>(blocks.at(prefix + ".tile_values"));
  if (places.size() != values.size() * tile_words)
    throw BlockError(fmt::format("grid {}: its tiles do not fit each other", prefix));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int32_t* place = &places[i * tile_words];
    if (place[0] < 1 || place[0] > std::int32_t(Grid::TreeType::RootNodeType::LEVEL))
      throw BlockError(fmt::format("grid {}: tile {} is on level {}", prefix, i, place[0]));
    const openvdb::Coord at(place[1], place[2], place[3]);
    check_place(prefix, "tile", i, at);
    grid.tree().addTile(openvdb::Index(place[0]), at, values[i], place[4] != 0);
  }
}

template <class Grid>
openvdb::GridBase::Ptr read_tree(const std::string& prefix, const Blocks& blocks) {
  const auto background = values_of<typename Grid::ValueType>(blocks.at(prefix + ".background"));
  if (background.size() != 1)
    throw BlockError(fmt::format("grid {}: {} backgrounds", prefix, background.size()));
  const auto grid = Grid::create(background[0]);
  read_tiles(prefix, blocks, *grid);  // first: a tile would replace the leaves below it
  read_leaves(prefix, blocks, *grid);
  return grid;
}

/// One row per type of values that is taken.
struct TypeRow {
  void (*write)(const std::string&, openvdb::GridBase&, BlockWriter&);
  openvdb::GridBase::Ptr (*read)(const std::string&, const Blocks&);
  std::string type;
};

template <class Grid>
TypeRow row_of() {
  return {[](const std::string& prefix, openvdb::GridBase& grid, BlockWriter& out) {
            write_tree(prefix, static_cast<Grid&>(grid), out);
          },
          read_tree<Grid>, Grid::gridType()};
}

const TypeRow* find_type(const std::string& grid_type) {
  static const TypeRow rows[] = {row_of<openvdb::FloatGrid>(), row_of<openvdb::DoubleGrid>(),
                                 row_of<openvdb::Vec3SGrid>(), row_of<openvdb::Vec3DGrid>()};
  for (const TypeRow& row : rows)
    if (row.type == grid_type) return &row;
  return nullptr;
}

void place(const std::string& prefix, const Blocks& blocks, openvdb::GridBase& grid) {
  const auto grid_class = blocks.at(prefix + ".class").values<std::int32_t>();
  if (grid_class.size() == 1) grid.setGridClass(openvdb::GridClass(grid_class[0]));
  const auto affine = blocks.at(prefix + ".affine").values<double>();
  if (affine.size() != 16)
    throw BlockError(fmt::format("grid '{}': its transform is not affine", grid.getName()));
  const openvdb::Mat4d matrix(affine.data());
  grid.insertMeta(affine_name, openvdb::TypedMetadata<openvdb::Mat4d>(matrix));
  try {
    grid.setTransform(openvdb::math::Transform::createLinearTransform(matrix));
  } catch (const openvdb::Exception& error) {
    throw BlockError(fmt::format("grid '{}': its transform is not affine, or flat: {}",
                                 grid.getName(), error.what()));
  }
}

}  // namespace

openvdb::Mat4d affine_of(const openvdb::GridBase& grid) {
  const auto matrix = grid.getMetadata<openvdb::TypedMetadata<openvdb::Mat4d>>(affine_name);
  return matrix ? matrix->value() : grid.transform().baseMap()->getAffineMap()->getMat4();
}

bool holds_vectors(const VdbGrid& grid) {
  return grid.value_type == openvdb::typeNameAsString<openvdb::Vec3s>() ||
         grid.value_type == openvdb::typeNameAsString<openvdb::Vec3d>();
}

void write_grid(int number, openvdb::GridBase& grid, bool with_tree, BlockWriter& out) {
  const std::string prefix = std::to_string(number);
  out.add_text(prefix + ".name", grid.getName());
  out.add_text(prefix + ".value", grid.valueType());
  const TypeRow* row = find_type(grid.type());
  if (!with_tree || !row) return;
  out.add_text(prefix + ".type", grid.type());
  const std::int32_t grid_class = grid.getGridClass();
  out.add(prefix + ".class", std::span<const std::int32_t>(&grid_class, 1));
  std::vector<double> affine;
  if (grid.transform().isLinear()) {
    const openvdb::Mat4d m = grid.transform().baseMap()->getAffineMap()->getMat4();
    affine.assign(m.asPointer(), m.asPointer() + 16);
  }
  out.add(prefix + ".affine", std::span<const double>(affine));
  row->write(prefix, grid, out);
}

std::vector<VdbGrid> grids_of(const Blocks& blocks) {
  std::vector<VdbGrid> grids;
  for (int number = 0;; ++number) {
    const std::string prefix = std::to_string(number);
    if (!blocks.find(prefix + ".name")) return grids;
    VdbGrid& grid = grids.emplace_back(
        VdbGrid{blocks.text(prefix + ".name"), blocks.text(prefix + ".value"), nullptr});
    const TypeRow* row = find_type(blocks.text(prefix + ".type"));
    if (!row) continue;
    grid.grid = row->read(prefix, blocks);
    grid.value_type = grid.grid->valueType();
    grid.grid->setName(grid.name);
    place(prefix, blocks, *grid.grid);
  }
}

}  // namespace pellucid::readers
