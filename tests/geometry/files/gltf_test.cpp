// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitGltf = FormatFiles;

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

TEST_F(UnitGltf, GltfHasItsNodesItsColoursAndItsLines) {
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

TEST_F(UnitGltf, PointsOfAFileThatHasSomeAreThoseAlone) {
  std::string text = gltf("", "BLEND");
  EXPECT_EQ(read_points(file("a.glb", glb(text, gltf_buffer()))).positions.size(), 8u);
  text.replace(text.find("\"mode\": 3"), 9, "\"mode\": 0");
  const PointSet points = read_points(file("b.glb", glb(text, gltf_buffer())));
  ASSERT_EQ(points.positions.size(), 4u);
  EXPECT_NEAR(glm::length(points.positions[3] - Vec3(10, 0, 1)), 0, 1e-15);
}

TEST_F(UnitGltf, GltfInTextMayHoldItsBuffer) {
  // A buffer of 36 bytes: three points, (0, 0, 0), (1, 0, 0) and (0, 1, 0), in base 64.
  const std::string content = R"({"asset": {"version": "2.0"}, "meshes": [{"primitives": [
    {"attributes": {"POSITION": 0}}]}], "accessors": [{"bufferView": 0, "componentType": 5126,
    "count": 3, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers":
    [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                              R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  EXPECT_EQ(read_mesh(file("a.gltf", content)).positions,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(UnitGltf, GltfRefusesWhatDoesNotFit) {
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

/// Triangles of four points, which the text may say more about: floats of the points 0 to 3 along x
/// (bytes 0 to 47), then whatever follows.
std::string gltf_of(const std::string& position, const std::string& more, const std::string& rest) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "a%20b%.bin", "byteLength": 112}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 2},
   {"buffer": 0, "byteOffset": 52, "byteLength": 24}],
 "accessors": [{"componentType": 5126, "count": 4, "type": "VEC3")" +
         position +
         R"(}, {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"},
   {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 2,
    "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 2}}}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5)" +
         more + "}]" + rest + "}";
}

const std::string dense = ", \"bufferView\": 0";
const std::string sparse =
    R"(, "sparse": {"count": 2, "indices": {"bufferView": 1, "componentType": 5121},
        "values": {"bufferView": 2}})";

class UnitGltfMore : public FormatFiles {
 protected:
  UnitGltfMore() {
    write_text(folder_ / "a b%.bin", bytes_of<float>({0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 0, 0}) +
                                         bytes_of<std::uint8_t>({1, 3, 0, 0}) +
                                         bytes_of<float>({5, 6, 7, 8, 9, 10}) +
                                         std::string(36, '\0'));
  }
  std::vector<Vec3> positions(const std::string& text) const {
    return read_mesh(file("m.gltf", text)).positions;
  }
  std::string complaint(const std::string& text) const {
    return refusal([&] { read_mesh(file("m.gltf", text)); });
  }
};

TEST_F(UnitGltfMore, SparseAccessorsReplaceSomeTuples) {
  EXPECT_EQ(positions(gltf_of(dense + sparse, "", "}]")),
            (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {2, 1, 0}, {8, 9, 10}}));
  EXPECT_EQ(positions(gltf_of(sparse, "", "}]")),
            (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {0, 0, 0}, {8, 9, 10}}));
  std::string beyond = gltf_of(sparse, "", "}]");
  beyond.replace(beyond.find("\"count\": 4"), 10, "\"count\": 3");
  EXPECT_THAT(complaint(beyond), HasSubstr("accessors[0].sparse.indices: 3 of 3 tuples"));
  beyond.replace(beyond.find("\"count\": 3"), 10, "\"count\": 99999999");
  EXPECT_THAT(complaint(beyond), HasSubstr("99999999 tuples of zeros"));
}

TEST_F(UnitGltfMore, MorphTargetsCountByTheirWeights) {
  const std::string targets = R"(, "targets": [{"POSITION": 2}, {"POSITION": 0}])";
  const auto with = [&](const std::string& rest) {
    return positions(gltf_of(dense, targets, rest));
  };
  const std::vector<Vec3> plain{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}};
  EXPECT_EQ(with("}]"), plain);
  EXPECT_EQ(with(R"(, "weights": [0, 0]}])"), plain);
  const std::vector<Vec3> moved{{0, 0, 0}, {3.5, 3, 3.5}, {2, 1, 0}, {7, 4.5, 5}};
  EXPECT_EQ(with(R"(, "weights": [0.5, 0]}])"), moved);
  EXPECT_EQ(with(R"(, "weights": [0, 1]}])"),
            (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {4, 2, 0}, {6, 0, 0}}));
  // A node's weights take the place of its mesh's.
  EXPECT_EQ(with(R"(, "weights": [0, 1]}], "scenes": [{"nodes": [0]}],
                    "nodes": [{"mesh": 0, "weights": [0.5, 0]}])"),
            moved);
  EXPECT_THAT(complaint(gltf_of(dense, targets, R"(, "weights": [1]}])")),
              HasSubstr("1 weights of 2 morph targets"));
}

TEST_F(UnitGltfMore, SkinsAreRefused) {
  EXPECT_THAT(complaint(gltf_of(dense, "",
                                R"(}], "scenes": [{"nodes": [0]}], "skins": [{"joints": [0]}],
                                   "nodes": [{"mesh": 0, "skin": 0}])")),
              HasSubstr("nodes[0] has a skin"));
}

TEST_F(UnitGltfMore, MasksAreThereOrNot) {
  const auto alpha = [&](double factor, const std::string& more) {
    return read_mesh(file("m.gltf", gltf_of(dense, ", \"material\": 0",
                                            R"(}], "materials": [{"alphaMode": "MASK")" + more +
                                                R"(, "pbrMetallicRoughness": {"baseColorFactor":
                                                   [1, 0, 0, )" +
                                                std::to_string(factor) + "]}}]")))
        .colors.at(2)
        .a;
  };
  EXPECT_EQ(alpha(0.4, ""), 0);
  EXPECT_EQ(alpha(0.5, ""), 1);
  EXPECT_EQ(alpha(0.4, ", \"alphaCutoff\": 0.3"), 1);
  EXPECT_EQ(alpha(0.7, ", \"alphaCutoff\": 0.7"), 1);  // which no float is
  EXPECT_EQ(alpha(0.7, ", \"alphaCutoff\": 0.8"), 0);
}

TEST_F(UnitGltf, AMaskAcrossTrianglesIsRefused) {
  // Of the alphas 1, 51/255, 0 and 1, times 1/2.
  EXPECT_THAT(refusal([&] { read_mesh(file("a.glb", glb(gltf("", "MASK"), gltf_buffer()))); }),
              HasSubstr("the alpha of 2 of 4 vertices is below the cutoff of 0.5"));
  EXPECT_THAT(refusal([&] { read_mesh(file("a.glb", glb(gltf("", "Blend"), gltf_buffer()))); }),
              HasSubstr("alphaMode \"Blend\"; accepted: OPAQUE, MASK, BLEND"));
}

TEST_F(UnitGltfMore, ALaterVersionThatIsNeededIsRefused) {
  std::string text = gltf_of(dense, "", "}]");
  text.replace(text.find("\"2.0\""), 5, R"("2.1", "minVersion": "2.0")");
  EXPECT_EQ(positions(text).size(), 4u);
  text.replace(text.find("n\": \"2.0\"") + 4, 5, R"("2.1")");
  EXPECT_THAT(complaint(text), HasSubstr("asset.minVersion: \"2.1\"; accepted: 2.0"));
}

}  // namespace
}  // namespace pellucid::geometry
