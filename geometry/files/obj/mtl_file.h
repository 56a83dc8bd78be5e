// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/vec.h"
#include "geometry/default_color.h"

namespace pellucid::geometry {

/// A MtlMaterial is what is drawn of a material: its diffuse colour and its opacity, each in
/// [0, 1].
struct MtlMaterial {
  Vec3 color = default_color;  // Kd
  double opacity = 1;          // d; else 1 - Tr
  std::string passed_over;     // a statement that says its colour otherwise, such as map_Kd
};
/// MtlMaterials are materials by their name.
using MtlMaterials = std::map<std::string, MtlMaterial>;

/// Reads the materials of an .mtl file into `materials`; of several of one name the last counts.
/// Throws InputError "FILE:LINE: …" for a number that is none or not in [0, 1].
void read_mtl(const std::filesystem::path& path, MtlMaterials& materials);

}  // namespace pellucid::geometry
