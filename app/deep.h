// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/commands.h"
#include "compare/deep/deep_info.h"
#include "groundtruth/traversal/scene_part.h"

namespace pellucid::app {

/// A DeepRequest says which files are to be made of a scene's crossings.
struct DeepRequest {
  std::string deep;     // the deep picture, .exr or .npz
  std::string picture;  // the composite of its crossings, .exr or .png; empty: none
  compare::DeepSource source;
};

/// Throws InputError for a scene of several samples per pixel: a deep picture has one.
void check_deep(const scene::Scene& scene);

/// Writes every crossing of the scene, and prints how many they are when asked to. Throws as
/// check_deep() and DeepOutputs do.
void write_deep(const DeepRequest& request, const scene::Scene& scene, const Progress& progress,
                const GlobalOptions& globals, bool print);

/// Does so with a part of a scene's primitives; its numbers are those of the whole.
void write_part(const DeepRequest& request, const groundtruth::ScenePart& part,
                const Progress& progress, const GlobalOptions& globals);

}  // namespace pellucid::app
