// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/vdb_components.h"

#include <fmt/format.h>
#include <openvdb/tools/ValueTransformer.h>

#include "core/files/bad_file.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;
using Three = std::array<const readers::VdbGrid*, 3>;

void require_same_places(const Three& grids, const Path& path) {
  for (const readers::VdbGrid* grid : grids)
    if (readers::affine_of(*grid->grid) != readers::affine_of(*grids[0]->grid))
      bad_file(path,
               fmt::format("the grids '{}' and '{}' have different transforms, as on staggered "
                           "faces; accepted: three with the same, so resample them to one",
                           grids[0]->name, grid->name));
}

/// A component that is its grid's background is not active there, as 0 on a wall or a plane of
/// symmetry: it counts where another one is. A tile of the union is constant in all three, since
/// one that any of them divides is divided.
template <class Vectors, class Scalars>
openvdb::GridBase::Ptr joined(const std::array<const Scalars*, 3>& parts) {
  const auto vectors = Vectors::create();
  for (const Scalars* part : parts) vectors->topologyUnion(*part);
  const auto set = [x = parts[0]->getConstAccessor(), y = parts[1]->getConstAccessor(),
                    z = parts[2]->getConstAccessor()](const auto& value) {
    const openvdb::Coord at = value.getCoord();
    value.setValue({x.getValue(at), y.getValue(at), z.getValue(at)});
  };
  constexpr bool threaded = true, shared = false;
  openvdb::tools::foreach (vectors->beginValueOn(), set, threaded, shared);
  return vectors;
}

template <class Vectors, class Scalars>
openvdb::GridBase::Ptr joined_if(const Three& grids) {
  std::array<const Scalars*, 3> parts{};
  for (std::size_t i = 0; i < 3; ++i) parts[i] = dynamic_cast<Scalars*>(grids[i]->grid.get());
  if (!parts[0] || !parts[1] || !parts[2]) return nullptr;
  return joined<Vectors, Scalars>(parts);
}

}  // namespace

openvdb::GridBase::Ptr joined_components(const Three& grids, const Path& path) {
  auto vectors = joined_if<openvdb::Vec3SGrid, openvdb::FloatGrid>(grids);
  if (!vectors) vectors = joined_if<openvdb::Vec3DGrid, openvdb::DoubleGrid>(grids);
  if (!vectors)
    bad_file(path,
             fmt::format("the grids '{}', '{}' and '{}' are of {}, {} and {}; accepted: three "
                         "of float or three of double",
                         grids[0]->name, grids[1]->name, grids[2]->name, grids[0]->value_type,
                         grids[1]->value_type, grids[2]->value_type));
  require_same_places(grids, path);
  vectors->insertMeta(*grids[0]->grid);  // its transform's own matrix is among it
  vectors->setTransform(grids[0]->grid->transformPtr());
  vectors->setName(fmt::format("{},{},{}", grids[0]->name, grids[1]->name, grids[2]->name));
  return vectors;
}

}  // namespace pellucid::fields
