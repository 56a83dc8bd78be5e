// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"
#include "geometry/files/gltf/gltf_document.h"

namespace pellucid::geometry {

/// A GltfMaterial is what is drawn of a material. As the format says, alpha counts at BLEND, is 0
/// or 1 at MASK, and 1 at OPAQUE, which is the default.
struct GltfMaterial {
  enum class Alpha { opaque, mask, blend };

  glm::dvec4 factor{1};  // of the vertices' colours: the base colour, straight, with alpha
  Alpha alpha = Alpha::opaque;
  double cutoff = 0.5;       // of a mask: the least alpha that is there
  bool is_given = false;     // else the primitive has none
  bool is_textured = false;  // a texture of its colour, which is not read, counts as white
};

/// Returns a primitive's material: the factor of pbrMetallicRoughness, or the diffuse one of
/// KHR_materials_pbrSpecularGlossiness, which comes first as that extension says. Throws InputError
/// for a material that is not as the format has it.
GltfMaterial gltf_material(const GltfDocument& document, const nlohmann::json& primitive);

}  // namespace pellucid::geometry
