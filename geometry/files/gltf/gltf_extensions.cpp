// SPDX-License-Identifier: GPL-3.0-or-later
// The extensions of glTF (github.com/KhronosGroup/glTF, extensions/2.0) by what they do to a
// picture. "All extensions used in a model must be listed in extensionsUsed; all that are required
// to load or render it correctly in extensionsRequired": who does not know one of these may not
// draw it.

#include "geometry/files/gltf/gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace pellucid::geometry {
namespace {

enum class Effect {
  none,         // read, or nothing that is drawn hangs on it
  passage,      // of light through a material, in the place of alpha
  compression,  // a document that does not require it has the numbers in the plain, too
  other         // not known
};

struct Extension {
  std::string_view name;
  Effect effect = Effect::none;
};

// Lights and what of a material answers to them are the scene's; textures are not read at all.
constexpr Extension extensions[] = {
    {"EXT_mesh_gpu_instancing"},
    {"KHR_mesh_quantization"},
    {"KHR_materials_pbrSpecularGlossiness"},
    {"EXT_lights_ies"},
    {"EXT_lights_image_based"},
    {"EXT_texture_avif"},
    {"EXT_texture_webp"},
    {"KHR_animation_pointer"},
    {"KHR_lights_punctual"},
    {"KHR_materials_anisotropy"},
    {"KHR_materials_clearcoat"},
    {"KHR_materials_dispersion"},
    {"KHR_materials_emissive_strength"},
    {"KHR_materials_ior"},
    {"KHR_materials_iridescence"},
    {"KHR_materials_sheen"},
    {"KHR_materials_specular"},
    {"KHR_materials_unlit"},
    {"KHR_materials_variants"},
    {"KHR_texture_basisu"},
    {"KHR_texture_transform"},
    {"KHR_xmp_json_ld"},
    {"MSFT_texture_dds"},
    {"KHR_materials_diffuse_transmission", Effect::passage},
    {"KHR_materials_transmission", Effect::passage},
    {"KHR_materials_volume", Effect::passage},
    {"EXT_meshopt_compression", Effect::compression},
    {"KHR_draco_mesh_compression", Effect::compression},
    {"KHR_meshopt_compression", Effect::compression},
};

Effect effect_of(std::string_view name) {
  const auto found = std::ranges::find(extensions, name, &Extension::name);
  return found == std::end(extensions) ? Effect::other : found->effect;
}

}  // namespace

std::string gltf_extension_refusal(std::string_view name) {
  const Effect effect = effect_of(name);
  if (effect == Effect::compression)
    return fmt::format("it needs the extension {}, which is not read; write it without compression",
                       name);
  if (effect == Effect::other)
    return fmt::format(
        "it needs the extension {}, which is not read; accepted: EXT_mesh_gpu_instancing, "
        "KHR_mesh_quantization, and those of PBR materials, textures and lights",
        name);
  return {};
}

std::string gltf_extension_remark(std::string_view name) {
  const Effect effect = effect_of(name);
  if (effect == Effect::passage)
    return fmt::format("the extension {} is not read: opacity is alpha alone", name);
  if (effect == Effect::other) return fmt::format("the extension {} is not read", name);
  return {};
}

}  // namespace pellucid::geometry
