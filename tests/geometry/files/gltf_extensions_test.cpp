// SPDX-License-Identifier: GPL-3.0-or-later
// Extensions of glTF: drawn, said, or refused where the document requires one that is not known.

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A triangle by accessor 0; accessors 1 to 3 are two shifts, turns and scales.
class UnitGltfExtensions : public FormatFiles {
 protected:
  UnitGltfExtensions() {
    const float half = std::sqrt(0.5f);
    write_text(folder_ / "a.bin", bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                                      bytes_of<float>({0, 0, 5, 1, 2, 3}) +
                                      bytes_of<float>({0, 0, 0, 1, 0, 0, half, half}) +
                                      bytes_of<float>({1, 1, 1, 2, 3, 1}));
  }

  std::string document(const std::string& node, const std::string& material,
                       const std::string& more) const {
    return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0)" +
           node +
           R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
 "materials": [{"alphaMode": "BLEND")" +
           material + R"(}], "buffers": [{"uri": "a.bin", "byteLength": 116}],
 "bufferViews": [{"buffer": 0, "byteLength": 116}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
   {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 2, "type": "VEC3"},
   {"bufferView": 0, "byteOffset": 60, "componentType": 5126, "count": 2, "type": "VEC4"},
   {"bufferView": 0, "byteOffset": 92, "componentType": 5126, "count": 2, "type": "VEC3"},
   {"componentType": 5126, "count": 4000000, "type": "VEC3"}])" +
           more + "}";
  }
  TriangleMesh mesh(const std::string& node, const std::string& material = "",
                    const std::string& more = "") const {
    return read_mesh(file("a.gltf", document(node, material, more)));
  }
  std::string refusal_of(const std::string& node, const std::string& more = "") const {
    return refusal([&] { mesh(node, "", more); });
  }
  static std::string instances(const std::string& attributes) {
    return R"(, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {)" + attributes + "}}}";
  }
};

TEST_F(UnitGltfExtensions, InstancesAreDrawnEach) {
  const TriangleMesh shifted = mesh(instances(R"("TRANSLATION": 1)"));
  EXPECT_EQ(shifted.positions, (std::vector<Vec3>{{0, 0, 5},
                                                  {1, 0, 5},
                                                  {0, 1, 5},  //
                                                  {1, 2, 3},
                                                  {2, 2, 3},
                                                  {1, 3, 3}}));
  EXPECT_EQ(shifted.triangles.size(), 2u);
  EXPECT_THAT(shifted.remarks, IsEmpty());
  // Scaled by (2, 3, 1), a quarter turn around z, shifted; then what the node does, × 10.
  const TriangleMesh placed = mesh(R"(, "scale": [10, 10, 10])" +
                                   instances(R"("SCALE": 3, "ROTATION": 2, "TRANSLATION": 1)"));
  EXPECT_NEAR(glm::distance(placed.positions[4], Vec3(10, 40, 30)), 0, 1e-13);
  EXPECT_NEAR(glm::distance(placed.positions[5], Vec3(-20, 20, 30)), 0, 1e-13);
}

TEST_F(UnitGltfExtensions, InstancesThatDoNotFitAreRefused) {
  EXPECT_THAT(refusal_of(instances(R"("TRANSLATION": 1, "SCALE": 0)")),
              HasSubstr("attributes of 2 and of 3 instances"));
  EXPECT_THAT(refusal_of(instances(R"("ROTATION": 1)")),
              HasSubstr("ROTATION: accepted: 4 numbers of a buffer each"));
  // Copies that no byte answers for.
  EXPECT_THAT(refusal_of(instances(R"("TRANSLATION": 4)")),
              HasSubstr("TRANSLATION: accepted: 3 numbers of a buffer each"));
  EXPECT_THAT(refusal_of(instances("")), HasSubstr("one of TRANSLATION, ROTATION, SCALE"));
  EXPECT_THAT(mesh(instances(R"("TRANSLATION": 1, "_ID": 0)")).remarks,
              ElementsAre("attributes of instances are not read: _ID"));
}

TEST_F(UnitGltfExtensions, SpecularGlossinessHasTheDiffuseFactor) {
  const std::string metallic = R"(, "pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1]})";
  const auto colors = [&](const std::string& extension) {
    return mesh("", metallic + R"(, "extensions": {)" + extension + "}",
                R"(, "extensionsRequired": ["KHR_materials_pbrSpecularGlossiness"])")
        .colors;
  };
  EXPECT_THAT(
      colors(R"("KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [1, 0, 0, 0.25]})"),
      Each(Rgba(1, 0, 0, 0.25f)));
  EXPECT_THAT(colors(R"("KHR_materials_pbrSpecularGlossiness": {})"), Each(Rgba(1)));
  EXPECT_THAT(colors(R"("KHR_materials_ior": {})"), Each(Rgba(0, 1, 0, 1)));
}

TEST_F(UnitGltfExtensions, WhatIsRequiredAndNotKnownIsRefused) {
  const auto required = [&](const std::string& name) {
    return refusal_of("", R"(, "extensionsRequired": [")" + name + "\"]");
  };
  EXPECT_THAT(required("KHR_draco_mesh_compression"), HasSubstr("write it without compression"));
  for (const char* name : {"KHR_technique_webgl", "KHR_materials_of_tomorrow", "KHR_texture_other"})
    EXPECT_THAT(required(name), AllOf(HasSubstr(std::string("needs the extension ") + name),
                                      HasSubstr("accepted: EXT_mesh_gpu_instancing")));
  for (const char* name :
       {"EXT_mesh_gpu_instancing", "KHR_texture_transform", "KHR_materials_unlit"})
    EXPECT_EQ(
        mesh("", "", R"(, "extensionsRequired": [")" + std::string(name) + "\"]").triangles.size(),
        1u);
}

TEST_F(UnitGltfExtensions, WhatIsUsedAndNotDrawnIsSaid) {
  const auto used = [&](const std::string& name) {
    return mesh("", "", R"(, "extensionsUsed": [")" + name + "\"]").remarks;
  };
  EXPECT_THAT(used("KHR_lights_punctual"), IsEmpty());
  EXPECT_THAT(used("KHR_draco_mesh_compression"), IsEmpty());  // the plain numbers are there, too
  EXPECT_THAT(used("KHR_node_visibility"),
              ElementsAre("the extension KHR_node_visibility is not read"));
  EXPECT_THAT(used("KHR_materials_transmission"), ElementsAre(HasSubstr("opacity is alpha alone")));
  EXPECT_THAT(mesh("", R"(, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})").remarks,
              ElementsAre("textures are not read: materials[0]"));
}

}  // namespace
}  // namespace pellucid::geometry
