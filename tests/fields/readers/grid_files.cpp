// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fields/readers/grid_files.h"

#include <fmt/format.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/fields/readers/vtk_files.h"
#include "tests/fields/sampled/grid_samples.h"

namespace pellucid::fields {
namespace {

namespace fs = std::filesystem;

void write_mha(const fs::path& path, const Velocity& velocity) {
  const std::string header = fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      "Offset = {} {} {}\nElementSpacing = {} {} {}\nDimSize = {} {} {}\n"
      "ElementNumberOfChannels = 3\nElementType = MET_DOUBLE\nElementDataFile = LOCAL\n",
      grid_box.min.x, grid_box.min.y, grid_box.min.z, step(0), step(1), step(2), grid_size[0],
      grid_size[1], grid_size[2]);
  write_bytes(path, header + native_bytes<double>(evaluate(rectilinear(0), velocity)));
}

/// Two voxels wider than the box along x, where they are left inactive unless `full`.
void write_vdb(const fs::path& path, const Velocity& velocity, bool full) {
  openvdb::initialize();
  auto grid = openvdb::Vec3SGrid::create(openvdb::Vec3s(99));  // a background that would show
  auto accessor = grid->getAccessor();
  std::size_t n = 0;
  const Positions positions = rectilinear(0);
  for (int k = 0; k < grid_size[2]; ++k)
    for (int j = 0; j < grid_size[1]; ++j)
      for (int i = 0; i < grid_size[0]; ++i) {
        const Vec3 v = velocity(positions[n++]);
        accessor.setValueOn({i - 3, j + 2, k}, openvdb::Vec3s(float(v.x), float(v.y), float(v.z)));
      }
  if (!full) accessor.setValueOn({40, 40, 40}, openvdb::Vec3s(0));
  grid->setName("velocity");
  auto transform = openvdb::math::Transform::createLinearTransform(1);
  transform->preScale(openvdb::Vec3d(step(0), step(1), step(2)));
  transform->postTranslate(
      openvdb::Vec3d(grid_box.min.x + 3 * step(0), grid_box.min.y - 2 * step(1), grid_box.min.z));
  grid->setTransform(transform);
  openvdb::io::File(path.string()).write({grid});
}

constexpr GridKind kinds[] = {
    {"vti", ".vti", false, true, vtk_files::write_vti},
    {"vti_appended", ".vti", false, true, vtk_files::write_appended_vti},
    {"vti_turned", ".vti", false, true, vtk_files::write_turned_vti},
    {"vtr", ".vtr", false, true, vtk_files::write_vtr},
    {"vts", ".vts", false, false, vtk_files::write_vts},
    {"vtu", ".vtu", false, false, vtk_files::write_vtu},
    {"legacy_image", ".vtk", true, true, vtk_files::write_legacy_image},
    {"legacy_rectilinear", ".vtk", false, true, vtk_files::write_legacy_rectilinear},
    {"legacy_structured", ".vtk", false, false, vtk_files::write_legacy_structured},
    {"legacy_unstructured", ".vtk", false, false, vtk_files::write_legacy_unstructured},
    {"mha", ".mha", false, true, write_mha},
    {"vdb_box", ".vdb", true, true, [](const auto& p, const auto& v) { write_vdb(p, v, true); }},
    {"vdb_sparse", ".vdb", true, false,
     [](const auto& p, const auto& v) { write_vdb(p, v, false); }},
};

}  // namespace

std::span<const GridKind> grid_kinds() { return kinds; }

const GridKind& grid_kind(std::string_view name) {
  return *std::find_if(std::begin(kinds), std::end(kinds),
                       [&](const GridKind& kind) { return kind.name == name; });
}

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

fs::path write_grid(const TemporaryFolder& folder, const GridKind& kind, const Velocity& velocity) {
  const fs::path path = folder / (std::string(kind.name) + std::string(kind.ending));
  kind.write(path, velocity);
  return path;
}

void write_cube(const fs::path& path, int count, const Velocity& velocity) {
  const double step = 1.0 / (count - 1);
  Positions vectors;
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) vectors.push_back(velocity(step * Vec3(i, j, k)));
  const std::string whole = fmt::format("0 {0} 0 {0} 0 {0}", count - 1);
  const std::string geometry = fmt::format("Origin=\"0 0 0\" Spacing=\"{0} {0} {0}\"", step);
  write_bytes(path, vtk_files::appended_image(whole, geometry, native_bytes<double>(vectors)));
}

}  // namespace pellucid::fields
