// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/gltf/gltf_materials.h"

#include <fmt/format.h>

namespace pellucid::geometry {
namespace {

using Json = nlohmann::json;

GltfMaterial::Alpha alpha_of(const GltfDocument& document, const Json& material) {
  const Json mode = material.value("alphaMode", Json("OPAQUE"));
  if (mode == "OPAQUE") return GltfMaterial::Alpha::opaque;
  if (mode == "MASK") return GltfMaterial::Alpha::mask;
  if (mode != "BLEND")
    document.fail(fmt::format("alphaMode {}; accepted: OPAQUE, MASK, BLEND", mode.dump()));
  return GltfMaterial::Alpha::blend;
}

/// Of one model of reflection, if the material has it.
bool take_color(const GltfDocument& document, const Json& holder, const char* model,
                const char* factor, const char* texture, GltfMaterial& material) {
  const auto found = holder.find(model);
  if (found == holder.end() || !found->is_object()) return false;
  if (const auto numbers = document.numbers<4>(*found, factor))
    material.factor = {(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
  material.is_textured = found->contains(texture);
  return true;
}

}  // namespace

GltfMaterial gltf_material(const GltfDocument& document, const Json& primitive) {
  GltfMaterial material;
  if (!primitive.contains("material")) return material;
  material.is_given = true;
  const Json& given = document.element("materials", primitive["material"]);
  material.alpha = alpha_of(document, given);
  material.cutoff = given.value("alphaCutoff", 0.5);
  const auto extensions = given.find("extensions");
  const bool has_specular = extensions != given.end() && extensions->is_object() &&
                            take_color(document, *extensions, "KHR_materials_pbrSpecularGlossiness",
                                       "diffuseFactor", "diffuseTexture", material);
  if (!has_specular)
    take_color(document, given, "pbrMetallicRoughness", "baseColorFactor", "baseColorTexture",
               material);
  return material;
}

}  // namespace pellucid::geometry
