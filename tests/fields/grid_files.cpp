#include "tests/fields/grid_files.h"

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

namespace pellucid {
namespace {

namespace fs = std::filesystem;
using Positions = std::vector<Vec3>;

constexpr std::array<int, 3> size = {5, 6, 7};

/// Position of a sample along an axis; `warp` bends the spacing but keeps the ends.
double along(int axis, int i, double warp) {
  const double s = double(i) / (size[axis] - 1);
  return glm::mix(grid_box.min[axis], grid_box.max[axis], s + warp * s * (1 - s));
}

Positions rectilinear(double warp) {
  Positions positions;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        positions.emplace_back(along(0, i, warp), along(1, j, warp), along(2, k, warp));
  return positions;
}

/// Inner points are moved about, so that cells are general hexahedra; the box stays.
Positions curvilinear() {
  Positions positions = rectilinear(0.2);
  for (Vec3& x : positions) {
    const Vec3 s = (x - grid_box.min) / (grid_box.max - grid_box.min);
    const Vec3 inside = s * (1.0 - s);
    x += 2.0 * inside.x * inside.y * inside.z * Vec3(1, -0.7, 0.5) * std::sin(9 * s.x + 5 * s.z);
  }
  return positions;
}

Positions evaluate(const Positions& positions, const Velocity& velocity) {
  Positions vectors;
  for (const Vec3& x : positions) vectors.push_back(velocity(x));
  return vectors;
}

std::string numbers(const Positions& vectors) {
  std::string text;
  for (const Vec3& v : vectors) text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
  return text;
}

std::string coordinates(int axis, double warp) {
  std::string text;
  for (int i = 0; i < size[axis]; ++i) text += fmt::format("{} ", along(axis, i, warp));
  return text + "\n";
}

template <class T>
std::string native_bytes(const Positions& vectors) {
  std::string bytes;
  for (const Vec3& v : vectors)
    for (int c = 0; c < 3; ++c) {
      const T number = T(v[c]);
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  return bytes;
}

/// Legacy binary files are big-endian.
template <class T>
std::string big_endian_bytes(const Positions& vectors) {
  std::string bytes = native_bytes<T>(vectors);
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(T))
    std::reverse(bytes.begin() + long(i), bytes.begin() + long(i + sizeof(T)));
  return bytes;
}

std::string xml(std::string_view type, std::string_view body) {
  return fmt::format(
      "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "{}</VTKFile>\n",
      type, body);
}

std::string array(std::string_view name, std::string_view type, int components,
                  std::string_view text) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n"
      "{}</DataArray>\n",
      type, name, components, text);
}

std::string point_data(const Positions& vectors) {
  return "<PointData>\n" + array("velocity", "Float64", 3, numbers(vectors)) + "</PointData>\n";
}

std::string extent() {
  return fmt::format("0 {} 0 {} 0 {}", size[0] - 1, size[1] - 1, size[2] - 1);
}

std::string origin_and_spacing() {
  const auto step = [](int axis) { return along(axis, 1, 0) - along(axis, 0, 0); };
  return fmt::format("Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", grid_box.min.x, grid_box.min.y,
                     grid_box.min.z, step(0), step(1), step(2));
}

void write_vti(const fs::path& path, const Velocity& velocity) {
  write_bytes(path, xml("ImageData", fmt::format("<ImageData WholeExtent=\"{0}\" {1}>\n"
                                                 "<Piece Extent=\"{0}\">\n{2}</Piece></ImageData>",
                                                 extent(), origin_and_spacing(),
                                                 point_data(evaluate(rectilinear(0), velocity)))));
}

std::string appended_image(std::string_view whole_extent, std::string_view geometry,
                           const std::string& bytes) {
  const std::uint64_t length = bytes.size();
  const std::string header(reinterpret_cast<const char*>(&length), sizeof length);
  return xml("ImageData",
             fmt::format("<ImageData WholeExtent=\"{0}\" {1}>\n<Piece Extent=\"{0}\"><PointData>"
                         "<DataArray type=\"Float64\" Name=\"velocity\" NumberOfComponents=\"3\" "
                         "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n"
                         "<AppendedData encoding=\"raw\">\n_{2}{3}</AppendedData>\n",
                         whole_extent, geometry, header, bytes));
}

void write_appended_vti(const fs::path& path, const Velocity& velocity) {
  write_bytes(path, appended_image(extent(), origin_and_spacing(),
                                   native_bytes<double>(evaluate(rectilinear(0), velocity))));
}

/// The image's own axes are the world's, turned: y, z, x.
void write_turned_vti(const fs::path& path, const Velocity& velocity) {
  Positions vectors;
  for (int i = 0; i < size[0]; ++i)
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        vectors.push_back(velocity({along(0, i, 0), along(1, j, 0), along(2, k, 0)}));
  const std::string whole = fmt::format("0 {} 0 {} 0 {}", size[1] - 1, size[2] - 1, size[0] - 1);
  const auto step = [](int axis) { return along(axis, 1, 0) - along(axis, 0, 0); };
  const std::string geometry =
      fmt::format("Origin=\"{} {} {}\" Spacing=\"{} {} {}\" Direction=\"0 0 1 1 0 0 0 1 0\"",
                  grid_box.min.x, grid_box.min.y, grid_box.min.z, step(1), step(2), step(0));
  write_bytes(path, appended_image(whole, geometry, native_bytes<double>(vectors)));
}

void write_vtr(const fs::path& path, const Velocity& velocity) {
  std::string axes;
  for (int axis = 0; axis < 3; ++axis)
    axes += array(std::string(1, "xyz"[axis]), "Float64", 1, coordinates(axis, 0.3));
  write_bytes(path,
              xml("RectilinearGrid",
                  fmt::format("<RectilinearGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">\n{1}"
                              "<Coordinates>\n{2}</Coordinates></Piece></RectilinearGrid>",
                              extent(), point_data(evaluate(rectilinear(0.3), velocity)), axes)));
}

std::string points(const Positions& positions) {
  return "<Points>\n" + array("Points", "Float64", 3, numbers(positions)) + "</Points>\n";
}

void write_vts(const fs::path& path, const Velocity& velocity) {
  const Positions positions = curvilinear();
  write_bytes(
      path,
      xml("StructuredGrid",
          fmt::format("<StructuredGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">\n{1}{2}"
                      "</Piece></StructuredGrid>",
                      extent(), point_data(evaluate(positions, velocity)), points(positions))));
}

struct Cells {
  std::vector<std::vector<int>> points;
  std::vector<int> types;

  void add(int type, std::vector<int> corners) {
    points.push_back(std::move(corners));
    types.push_back(type);
  }
};

/// Hexahedra, columns of six tetrahedra or two wedges in turn; and a triangle and a line, which
/// have no volume.
Cells mixed_cells() {
  constexpr int tetra = 10, hexahedron = 12, wedge = 13, triangle = 5, line = 3;
  Cells cells;
  cells.add(triangle, {0, 1, size[0]});
  for (int k = 0; k + 1 < size[2]; ++k)
    for (int j = 0; j + 1 < size[1]; ++j)
      for (int i = 0; i + 1 < size[0]; ++i) {
        const int a = (k * size[1] + j) * size[0] + i, row = size[0], layer = size[0] * size[1];
        const int c[8] = {a,         a + 1,         a + row + 1,         a + row,
                          a + layer, a + layer + 1, a + layer + row + 1, a + layer + row};
        if (i % 3 == 0) {
          cells.add(hexahedron, {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
        } else if (i % 3 == 1) {
          const int ring[7] = {1, 2, 3, 7, 4, 5, 1};  // the edges around the diagonal 0-6
          for (int e = 0; e < 6; ++e) cells.add(tetra, {c[0], c[ring[e]], c[ring[e + 1]], c[6]});
        } else {
          cells.add(wedge, {c[0], c[1], c[2], c[4], c[5], c[6]});
          cells.add(wedge, {c[0], c[2], c[3], c[4], c[6], c[7]});
        }
      }
  cells.add(line, {0, 1});
  return cells;
}

void write_vtu(const fs::path& path, const Velocity& velocity) {
  const Positions positions = rectilinear(0.2);
  const Cells cells = mixed_cells();
  std::string connectivity, offsets, types;
  std::size_t offset = 0;
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    connectivity += fmt::format("{}\n", fmt::join(cells.points[i], " "));
    offsets += fmt::format("{}\n", offset += cells.points[i].size());
    types += fmt::format("{}\n", cells.types[i]);
  }
  write_bytes(
      path, xml("UnstructuredGrid",
                fmt::format(
                    "<UnstructuredGrid><Piece NumberOfPoints=\"{}\" "
                    "NumberOfCells=\"{}\">\n{}{}<Cells>\n{}{}{}</Cells></Piece>"
                    "</UnstructuredGrid>",
                    positions.size(), cells.types.size(), point_data(evaluate(positions, velocity)),
                    points(positions), array("connectivity", "Int64", 1, connectivity),
                    array("offsets", "Int64", 1, offsets), array("types", "UInt8", 1, types))));
}

std::string legacy(bool binary, std::string_view geometry, std::string_view vectors) {
  return fmt::format(
      "# vtk DataFile Version 3.0\nwritten by a test\n{}\n{}\nPOINT_DATA {}\n"
      "VECTORS velocity {}\n{}\n",
      binary ? "BINARY" : "ASCII", geometry, size[0] * size[1] * size[2],
      binary ? "float" : "double", vectors);
}

std::string dimensions() { return fmt::format("DIMENSIONS {} {} {}", size[0], size[1], size[2]); }

void write_legacy_image(const fs::path& path, const Velocity& velocity) {
  const auto step = [](int axis) { return along(axis, 1, 0) - along(axis, 0, 0); };
  const std::string geometry =
      fmt::format("DATASET STRUCTURED_POINTS\n{}\nORIGIN {} {} {}\nSPACING {} {} {}", dimensions(),
                  grid_box.min.x, grid_box.min.y, grid_box.min.z, step(0), step(1), step(2));
  write_bytes(path,
              legacy(true, geometry, big_endian_bytes<float>(evaluate(rectilinear(0), velocity))));
}

void write_legacy_rectilinear(const fs::path& path, const Velocity& velocity) {
  std::string geometry = "DATASET RECTILINEAR_GRID\n" + dimensions() + "\n";
  for (int axis = 0; axis < 3; ++axis)
    geometry += fmt::format("{}_COORDINATES {} double\n{}", "XYZ"[axis], size[axis],
                            coordinates(axis, 0.3));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(rectilinear(0.3), velocity))));
}

void write_legacy_structured(const fs::path& path, const Velocity& velocity) {
  const Positions positions = curvilinear();
  const std::string geometry = fmt::format("DATASET STRUCTURED_GRID\n{}\nPOINTS {} double\n{}",
                                           dimensions(), positions.size(), numbers(positions));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(positions, velocity))));
}

void write_legacy_unstructured(const fs::path& path, const Velocity& velocity) {
  const Positions positions = rectilinear(0.2);
  const Cells cells = mixed_cells();
  std::string list;
  std::size_t length = 0;
  for (const auto& corners : cells.points) {
    list += fmt::format("{} {}\n", corners.size(), fmt::join(corners, " "));
    length += corners.size() + 1;
  }
  const std::string geometry =
      fmt::format("DATASET UNSTRUCTURED_GRID\nPOINTS {} double\n{}CELLS {} {}\n{}CELL_TYPES {}\n{}",
                  positions.size(), numbers(positions), cells.types.size(), length, list,
                  cells.types.size(), fmt::join(cells.types, "\n"));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(positions, velocity))));
}

void write_mha(const fs::path& path, const Velocity& velocity) {
  const auto step = [](int axis) { return along(axis, 1, 0) - along(axis, 0, 0); };
  const std::string header = fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      "Offset = {} {} {}\nElementSpacing = {} {} {}\nDimSize = {} {} {}\n"
      "ElementNumberOfChannels = 3\nElementType = MET_DOUBLE\nElementDataFile = LOCAL\n",
      grid_box.min.x, grid_box.min.y, grid_box.min.z, step(0), step(1), step(2), size[0], size[1],
      size[2]);
  write_bytes(path, header + native_bytes<double>(evaluate(rectilinear(0), velocity)));
}

/// Two voxels wider than the box along x, where they are left inactive unless `full`.
void write_vdb(const fs::path& path, const Velocity& velocity, bool full) {
  openvdb::initialize();
  const auto step = [](int axis) { return along(axis, 1, 0) - along(axis, 0, 0); };
  auto grid = openvdb::Vec3SGrid::create(openvdb::Vec3s(99));  // a background that would show
  auto accessor = grid->getAccessor();
  std::size_t n = 0;
  const Positions positions = rectilinear(0);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
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
    {"vti", ".vti", false, true, write_vti},
    {"vti_appended", ".vti", false, true, write_appended_vti},
    {"vti_turned", ".vti", false, true, write_turned_vti},
    {"vtr", ".vtr", false, true, write_vtr},
    {"vts", ".vts", false, false, write_vts},
    {"vtu", ".vtu", false, false, write_vtu},
    {"legacy_image", ".vtk", true, true, write_legacy_image},
    {"legacy_rectilinear", ".vtk", false, true, write_legacy_rectilinear},
    {"legacy_structured", ".vtk", false, false, write_legacy_structured},
    {"legacy_unstructured", ".vtk", false, false, write_legacy_unstructured},
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

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "pellucid-fields-XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() { fs::remove_all(path_); }

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
  write_bytes(path, appended_image(whole, geometry, native_bytes<double>(vectors)));
}

}  // namespace pellucid
