// SPDX-License-Identifier: GPL-3.0-or-later
// Formats of other programs: what files of known content hold, and that whatever is cut off one is
// refused or leaves a whole. The numbers of files that those programs wrote are compared in
// tests/app/compare_readers.py.

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

constexpr float infinity = std::numeric_limits<float>::infinity();

class UnitOtherFormats : public ::testing::Test {
 protected:
  fs::path file(const std::string& name, std::string_view content) const {
    write_text(folder_ / name, content);
    return folder_ / name;
  }
  template <class Read>
  static std::string refusal(const Read& read) {
    try {
      read();
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "accepted";
    return {};
  }
  /// Of a file cut off anywhere nothing but a refusal that names it leaves the reader.
  template <class Read>
  void expect_cuts_are_refused(const std::string& name, const std::string& whole,
                               const Read& read) const {
    for (std::size_t size = 0; size + 1 < whole.size(); size += 1 + whole.size() / 200)
      EXPECT_THAT(refusal([&] { read(file(name, whole.substr(0, size))); }), HasSubstr(name))
          << size;
  }

  TemporaryFolder folder_;
};

template <class T>
std::string bytes_of(const std::vector<T>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const T number : numbers) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    if (big_endian) std::reverse(raw, raw + sizeof raw);
    bytes.append(raw, sizeof raw);
  }
  return bytes;
}

// --- .off -------------------------------------------------------------------------------------

TEST_F(UnitOtherFormats, OffHasPolygonsCommentsAndCounts) {
  const TriangleMesh mesh = read_mesh(
      file("a.off",
           "OFF # a comment\n\n4 2 0\n0 0 0\n1 0 0\n1 1 0 # another\n0 1 0.5\n4 0 1 2 3 255 0 0\n"
           "3 0 1 3\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[3], Vec3(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.triangles[2], (std::array<std::uint32_t, 3>{0, 1, 3}));
  EXPECT_EQ(read_mesh(file("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).triangles.size(),
            1u);
}

TEST_F(UnitOtherFormats, OffHasNormalsAndColoursOfBytesOrShares) {
  const TriangleMesh bytes = read_mesh(
      file("a.off",
           "CNOFF\n3 1 0\n0 0 0 0 0 2 255 0 51 255\n1 0 0 0 0 2 0 0 0 0\n0 1 0 0 1 0 1 2 3\n"
           "3 0 1 2\n"));
  EXPECT_EQ(bytes.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(bytes.colors[0], Rgba(1, 0, 0.2f, 1));
  EXPECT_EQ(bytes.colors[1], Rgba(0));
  EXPECT_EQ(bytes.colors[2], Rgba(1 / 255.f, 2 / 255.f, 3 / 255.f, 1));
  const TriangleMesh shares = read_mesh(
      file("b.off", "COFF\n3 1 0\n0 0 0 1 0 0.5 0.25\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0.5\n3 0 1 2\n"));
  EXPECT_EQ(shares.colors[0], Rgba(1, 0, 0.5f, 0.25f));
  EXPECT_EQ(shares.colors[1], Rgba(1));
}

TEST_F(UnitOtherFormats, OffRefusesWhatItIsNot) {
  for (const auto& [content, said] :
       {std::pair("4OFF\n3 1 0\n", "'4OFF'; accepted"), std::pair("OFF BINARY\n", "BINARY"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ":6: a face's vertex 3"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0\n", ":4: a vertex of 2 numbers"),
        std::pair("OFF\n1e15 1 0\n0 0 0\n", "number of vertices"),
        std::pair("OFF\n3 1 0\n0 0 x\n", "'x': expected a number"),
        std::pair("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n", "number of corners")})
    EXPECT_THAT(refusal([&] { read_mesh(file("a.off", content)); }), HasSubstr(said));
}

// --- .tck -------------------------------------------------------------------------------------

std::string tck(const std::string& type, const std::string& data) {
  std::string head = "mrtrix tracks\nfoo: bar\ndatatype: " + type + "\nfile: . 100\nEND\n";
  return head + std::string(100 - head.size(), '\0') + data;
}

TEST_F(UnitOtherFormats, TckHasTracksOfBothOrdersAndSizes) {
  const std::vector<float> points{1,   2, 3,   4,   5,   6,        NAN,      NAN,
                                  NAN, 7, 8,   9,   -1,  0,        0.5f,     0,
                                  0,   1, NAN, NAN, NAN, infinity, infinity, infinity};
  const std::vector<double> wide(points.begin(), points.end());
  for (const std::string& content :
       {tck("Float32LE", bytes_of(points)), tck("Float32BE", bytes_of(points, true)),
        tck("Float64LE", bytes_of(wide)), tck("Float64BE", bytes_of(wide, true))}) {
    const LineSet lines = read_lines(file("a.tck", content));
    EXPECT_EQ(lines.offsets, (std::vector<std::uint64_t>{0, 2, 5}));
    EXPECT_EQ(lines.positions[1], Vec3(4, 5, 6));
    EXPECT_EQ(lines.positions[3], Vec3(-1, 0, 0.5));
  }
  expect_cuts_are_refused("cut.tck", tck("Float32LE", bytes_of(points)), read_lines);
  EXPECT_THAT(refusal([&] { read_lines(file("b.tck", tck("Int16LE", ""))); }),
              HasSubstr("datatype: Int16LE; accepted: Float32LE"));
}

TEST_F(UnitOtherFormats, TckIsWrittenAsItIsRead) {
  LineSet lines;
  for (int i = 0; i < 12345; ++i) lines.positions.emplace_back(0.5 * i, -i, 3);
  lines.offsets = {0, 4, 12345};
  for (const std::size_t count : {std::size_t(2), std::size_t(12345)}) {
    lines.positions.resize(count);
    lines.offsets = {0, count};
    write_lines(folder_ / "a.tck", lines);
    const LineSet back = read_lines(folder_ / "a.tck");
    EXPECT_EQ(back.positions, lines.positions);
    EXPECT_EQ(back.offsets, lines.offsets);
  }
}

// --- .trk -------------------------------------------------------------------------------------

/// One track of two points, one scalar and a property of two numbers; voxels of 1 × 2 × 4 mm, whose
/// axes run to the right, to the front and up, as those of the image at (10, 20, 30) do.
std::string trk(const std::string& order, bool big_endian) {
  std::string header(1000, '\0');
  const auto put = [&](std::size_t at, const std::string& bytes) {
    header.replace(at, bytes.size(), bytes);
  };
  put(0, "TRACK");
  put(6, bytes_of<std::int16_t>({8, 6, 5}, big_endian));
  put(12, bytes_of<float>({1, 2, 4}, big_endian));
  put(36, bytes_of<std::int16_t>({1}, big_endian));
  put(38, "fa");
  put(238, bytes_of<std::int16_t>({2}, big_endian));
  put(240, std::string("pair\0002", 6));
  put(440, bytes_of<float>({1, 0, 0, 10, 0, 2, 0, 20, 0, 0, 4, 30, 0, 0, 0, 1}, big_endian));
  put(948, order);
  put(996, bytes_of<std::int32_t>({1000}, big_endian));
  return header + bytes_of<std::int32_t>({2}, big_endian) +
         bytes_of<float>({0.5f, 1, 2, 0.25f, 2.5f, 3, 10, 0.75f, -7, 7}, big_endian);
}

TEST_F(UnitOtherFormats, TrkIsInTheScannersCoordinates) {
  for (const bool big_endian : {false, true}) {
    const LineSet lines = read_lines(file("a.trk", trk("RAS", big_endian)));
    // The first point is the centre of voxel (0, 0, 0), the second of (2, 1, 2).
    EXPECT_EQ(lines.positions, (std::vector<Vec3>{{10, 20, 30}, {12, 22, 38}}));
    EXPECT_EQ(lines.scalars.at("fa"), (std::vector<double>{0.25, 0.75}));
    EXPECT_EQ(lines.scalars.at("pair_0"), (std::vector<double>{-7, -7}));
    EXPECT_EQ(lines.scalars.at("pair_1"), (std::vector<double>{7, 7}));
  }
  // The file's first two axes run the other way: voxel (0, 0, 0) of it is (7, 5, 0) of the image.
  EXPECT_EQ(read_lines(file("b.trk", trk("LPS", false))).positions[0], Vec3(17, 30, 30));
  EXPECT_THAT(refusal([&] { read_lines(file("c.trk", trk("RAX", false))); }),
              HasSubstr("voxel_order 'RAX'"));
  const std::string whole = trk("RAS", false);
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_THAT(refusal([&] { read_lines(file("cut.trk", whole.substr(0, size))); }),
                HasSubstr("cut.trk"));
}

// --- .hair ------------------------------------------------------------------------------------

std::string hair(std::uint32_t arrays, const std::string& data) {
  return "HAIR" + bytes_of<std::uint32_t>({2, 5, arrays, 1}) +
         bytes_of<float>({0.5f, 0.25f, 1, 0.5f, 0}) + std::string(88, 'i') + data;
}

TEST_F(UnitOtherFormats, HairHasStrandsWithOpacityAndColour) {
  const std::string segments = bytes_of<std::uint16_t>({2, 1});
  const std::string points = bytes_of<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5, 6, 6, 6});
  const LineSet plain = read_lines(file("a.hair", hair(3, segments + points)));
  EXPECT_EQ(plain.offsets, (std::vector<std::uint64_t>{0, 3, 5}));
  EXPECT_EQ(plain.positions[3], Vec3(5));
  EXPECT_EQ(plain.colors[4], Rgba(1, 0.5f, 0, 0.75f));
  EXPECT_EQ(plain.scalars.at("thickness"), std::vector<double>(5, 0.5));
  const std::string whole = hair(31, segments + points + bytes_of<float>({1, 2, 3, 4, 5}) +
                                         bytes_of<float>({0, 0.25f, 0.5f, 0.75f, 1}) +
                                         bytes_of(std::vector<float>(15, 0.5f)));
  const LineSet full = read_lines(file("b.hair", whole));
  EXPECT_EQ(full.colors[3], Rgba(0.5f, 0.5f, 0.5f, 0.25f));
  EXPECT_EQ(full.scalars.at("thickness")[4], 5);
  expect_cuts_are_refused("cut.hair", whole, read_lines);
  EXPECT_THAT(refusal([&] { read_lines(file("c.hair", hair(2, points))); }),
              HasSubstr("strands have 4 points, but there are 5"));
}

// --- .gltf, .glb ------------------------------------------------------------------------------

/// A triangle and a line strip over the same four points (floats, 48 bytes), colours in bytes (16),
/// speeds (16), indices of 16 bits (6).
std::string gltf_buffer() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         bytes_of<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 51, 0, 0, 255, 0, 255, 255, 255, 255}) +
         bytes_of<float>({1, 2, 3, 4}) + bytes_of<std::uint16_t>({2, 1, 0});
}

std::string gltf(const std::string& buffer, const std::string& alpha_mode) {
  return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [1]}],
 "nodes": [{"mesh": 0, "scale": [2, 1, 1]},
           {"children": [0], "translation": [10, 0, 0],
            "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}],
 "meshes": [{"primitives": [
   {"attributes": {"POSITION": 0, "COLOR_0": 1, "_SPEED": 2}, "indices": 3, "material": 0},
   {"attributes": {"POSITION": 0}, "mode": 3}]}],
 "materials": [{"alphaMode": ")" +
         alpha_mode + R"(",
   "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
   {"bufferView": 0, "byteOffset": 48, "componentType": 5121, "normalized": true, "count": 4,
    "type": "VEC4"},
   {"bufferView": 0, "byteOffset": 64, "componentType": 5126, "count": 4, "type": "SCALAR"},
   {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 80},
                 {"buffer": 0, "byteOffset": 80, "byteLength": 6}],
 "buffers": [{)" +
         buffer + R"("byteLength": 86}]})";
}

std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto size = std::uint32_t(28 + json.size() + binary.size());
  return "glTF" + bytes_of<std::uint32_t>({2, size, std::uint32_t(json.size()), 0x4E4F534A}) +
         json + bytes_of<std::uint32_t>({std::uint32_t(binary.size()), 0x004E4942}) + binary;
}

TEST_F(UnitOtherFormats, GltfHasItsNodesItsColoursAndItsLines) {
  write_text(folder_ / "a.bin", gltf_buffer());
  for (const fs::path& path : {file("a.gltf", gltf(R"("uri": "a.bin", )", "BLEND")),
                               file("a.glb", glb(gltf("", "BLEND"), gltf_buffer()))}) {
    const TriangleMesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{2, 1, 0}));
    // Scaled by 2 along x, turned by a quarter, shifted by 10 along x; √½ rounds.
    EXPECT_NEAR(glm::length(mesh.positions[1] - Vec3(10, 2, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::length(mesh.positions[2] - Vec3(9, 0, 0)), 0, 2e-15);
    EXPECT_EQ(mesh.colors[1], Rgba(0, 1, 0, 0.1f));
    EXPECT_EQ(mesh.scalars.at("speed"), (std::vector<double>{1, 2, 3, 4}));
    const LineSet lines = read_lines(path);
    EXPECT_EQ(lines.offsets, (std::vector<std::uint64_t>{0, 4}));
    EXPECT_NEAR(glm::length(lines.positions[3] - Vec3(10, 0, 1)), 0, 1e-15);
  }
  EXPECT_EQ(read_mesh(file("b.glb", glb(gltf("", "OPAQUE"), gltf_buffer()))).colors[1],
            Rgba(0, 1, 0, 1));
  expect_cuts_are_refused("cut.glb", glb(gltf("", "BLEND"), gltf_buffer()), read_mesh);
}

TEST_F(UnitOtherFormats, GltfInTextMayHoldItsBuffer) {
  // A buffer of 36 bytes: three points, (0, 0, 0), (1, 0, 0) and (0, 1, 0), in base 64.
  const std::string content = R"({"asset": {"version": "2.0"}, "meshes": [{"primitives": [
    {"attributes": {"POSITION": 0}}]}], "accessors": [{"bufferView": 0, "componentType": 5126,
    "count": 3, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers":
    [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                              R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  EXPECT_EQ(read_mesh(file("a.gltf", content)).positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(UnitOtherFormats, GltfRefusesWhatDoesNotFit) {
  const auto changed = [](std::string from, const std::string& to) {
    std::string text = gltf("", "BLEND");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return glb(text.replace(at, from.size(), to), gltf_buffer());
  };
  for (const auto& [from, to, said] :
       {std::tuple("\"2.0\"", "\"1.0\"", "asset.version"),
        std::tuple("\"children\": [0]", "\"children\": [1]", "two parents"),
        std::tuple("\"children\": [0]", "\"children\": [7]", "nodes[7]: there is none"),
        std::tuple("\"count\": 3", "\"count\": 4", "accessors[3]: 4 × 2 bytes"),
        std::tuple("\"byteLength\": 80", "\"byteLength\": 90", "bufferViews[0]"),
        std::tuple("\"byteLength\": 80", "\"byteLength\": -1", "byteLength: -1"),
        std::tuple("\"componentType\": 5123, \"count\": 3", "\"componentType\": 5121, \"count\": 6",
                   ""),
        std::tuple("\"mode\": 3", "\"mode\": 9", "mode 9"),
        std::tuple(
            "\"scenes\":", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"scenes\":",
            "KHR_draco_mesh_compression"),
        std::tuple("[{\"nodes\": [1]}]", "3", "scenes[0]")}) {
    const fs::path path = file("a.glb", changed(from, to));
    if (*said) {
      EXPECT_THAT(refusal([&] { read_mesh(path); }), HasSubstr(said)) << to;
    }
  }
}

// --- .csv -------------------------------------------------------------------------------------

TEST_F(UnitOtherFormats, CsvIsReadHoweverItIsHeaded) {
  for (const char* content :
       {"x,y,z,s\n1,2,3,4\n5,6,7,8\n", "\xEF\xBB\xBFx,y,z,s\n1,2,3,4\n5,6,7,8\n",
        "X,Y,Z,s\r\n1,2,3,4\r\n5,6,7,8\r\n",
        "\"s\",\"Points:0\",\"Points:1\",\"Points:2\"\n4,1,2,3\n8,5,6,7\n",
        "s,Points_0,Points_1,Points_2\n4,1,2,3\n8,5,6,7\n", "//X;Y;Z;s\n1;2;3;4\n5;6;7;8\n",
        "x\ty\tz\ts\n1\t2\t3\t4\n5\t6\t7\t8\n", "# made by x\nx,y,z,s\n1,2,3,4\n5,6,7,8\n\n",
        "x [m], y [m], z [m], s\n1, 2, 3, 4\n5 ,6, 7, 8\n", "x  y z s\n1 2  3 4\n 5 6 7 8 \n",
        "x;y;z;s\n1,0;2;3;4\n5;6,0;7;8\n",
        "x-coordinate, y-coordinate, z-coordinate, s\n1,2,3,4\n5,6,7,8\n"}) {
    const PointSet points = read_points(file("a.csv", content));
    EXPECT_EQ(points.positions, (std::vector<Vec3>{{1, 2, 3}, {5, 6, 7}})) << content;
    ASSERT_TRUE(points.scalars.contains("s")) << content;
    EXPECT_EQ(points.scalars.at("s"), (std::vector<double>{4, 8})) << content;
  }
}

TEST_F(UnitOtherFormats, CsvHasColoursInBytesOrShares) {
  const PointSet bytes = read_points(file("a.csv", "//X Y Z R G B\n0 0 0 255 0 51\n1 1 1 0 1 0\n"));
  EXPECT_EQ(bytes.colors[0], Rgba(1, 0, 0.2f, 1));
  EXPECT_EQ(bytes.colors[1], Rgba(0, 1 / 255.f, 0, 1));
  const PointSet shares =
      read_points(file("b.csv", "x,y,z,red,green,blue,alpha\n0,0,0,1,0,0.5,1\n1,1,1,0,1,0,0\n"));
  EXPECT_EQ(shares.colors[0], Rgba(1, 0, 0.5f, 1));
  EXPECT_EQ(shares.colors[1], Rgba(0, 1, 0, 0));
  const PointSet mixed = read_points(
      file("c.csv", "x,y,z,red,green,blue,alpha\n0,0,0,255,0,0,0.5\n1,1,1,0,255,0,1\n"));
  EXPECT_EQ(mixed.colors[0], Rgba(1, 0, 0, 0.5f));
}

TEST_F(UnitOtherFormats, CsvSaysWhichColumnOrLineIsWrong) {
  for (const auto& [content, said] :
       {std::pair("x,y,s\n0,0,1\n", "no columns x, y, z among x, y, s"),
        std::pair("x,y,z,s\n0,0,0,1\n1,0,0,\n", ":3: column 's': '': expected a number"),
        std::pair("x,y,z\n0,0,0\n1,0,0,5\n", ":3: more than the 3 columns"),
        std::pair("x,y,z,name\n0,0,0,a\n", ":2: column 'name': 'a'"),
        std::pair("# x\n# y\n", "no line that names the columns"),
        std::pair("x,y,z\n1,5;2;3\n", "'5;2;3'")})
    EXPECT_THAT(refusal([&] { read_points(file("a.csv", content)); }), HasSubstr(said));
}

// --- .ply -------------------------------------------------------------------------------------

TEST_F(UnitOtherFormats, PlyStripsAreTrianglesThatFaceOneWay) {
  const TriangleMesh mesh =
      read_mesh(file("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                     "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 1 3 2\n"));
  ASSERT_EQ(mesh.triangles.size(), 4u);
  for (const auto& [a, b, c] : mesh.triangles)
    EXPECT_GT(
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z,
        0);
  EXPECT_THAT(
      refusal([&] {
        read_mesh(file("b.ply",
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
                       "float y\nproperty float z\nelement tristrips 1\nproperty list int "
                       "int vertex_indices\nend_header\n0 0 0\n3 0 -2 0\n"));
      }),
      HasSubstr("vertex index -2"));
}

TEST_F(UnitOtherFormats, PlyOfGaussiansHasTheirColoursOpacitiesAndSizes) {
  const PointSet points = read_points(
      file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
           "property float z\nproperty float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
           "property float f_rest_0\nproperty float opacity\nproperty float scale_0\n"
           "property float scale_1\nproperty float scale_2\nend_header\n"
           "1 2 3 0 1 -100 9 0 0 0 0\n4 5 6 0 0 0 9 1.0986122886681098 -3 -1 1\n"));
  // 1 / (2 √π) = 0.28209479; a float's rounding.
  EXPECT_NEAR(points.colors[0].g, 0.5 + 0.28209479, 1e-7);
  EXPECT_EQ(points.colors[0].r, 0.5f);
  EXPECT_EQ(points.colors[0].b, 0);
  EXPECT_EQ(points.colors[0].a, 0.5f);
  EXPECT_NEAR(points.colors[1].a, 0.75, 1e-7);  // the logit is ln 3
  EXPECT_EQ(points.scalars.at("radius")[0], 1);
  EXPECT_NEAR(points.scalars.at("radius")[1], std::exp(-1), 1e-15);
  EXPECT_FALSE(points.scalars.contains("f_rest_0"));
}

TEST_F(UnitOtherFormats, LinesKeepWhatTheyCarryWhereTheFormatCan) {
  LineSet lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {5, 5, 5}, {6, 6, 7}};
  lines.offsets = {0, 3, 5};
  lines.colors = {Rgba(1, 0, 0, 0.5f), Rgba(0, 1, 0, 1), Rgba(0), Rgba(1), Rgba(0, 0, 1, 0.25f)};
  lines.importance = {0, 0.5f, 1, 0.25f, 0};
  lines.scalars["speed"] = {1, 2, 3, 4, 1e-300};
  for (const char* name : {"a.ply", "a.vtp", "a.vtu"}) {
    write_lines(folder_ / name, lines);
    const LineSet back = read_lines(folder_ / name);
    EXPECT_EQ(back.positions, lines.positions) << name;
    EXPECT_EQ(back.offsets, lines.offsets) << name;
    EXPECT_EQ(back.colors, lines.colors) << name;
    EXPECT_EQ(back.importance, lines.importance) << name;
    EXPECT_EQ(back.scalars, lines.scalars) << name;
  }
  EXPECT_THAT(read_text(folder_ / "a.ply"), HasSubstr("element edge 3\n"));
}

}  // namespace
}  // namespace pellucid::geometry
