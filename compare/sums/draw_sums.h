// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "compare/methods/method_call.h"
#include "compare/parts/scene_bounds.h"
#include "compare/sums/sums_file.h"
#include "core/progress.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// A SumsRequest says which sums are wanted.
struct SumsRequest {
  std::filesystem::path scene;
  scene::ViewRequest view;
  MethodCall call;
  scene::PartNumber part;
  std::string gl = "osmesa";
  const SceneBounds* bounds = nullptr;  // of the scene, if they are known; has to outlive it
};

/// Draws a part of the scene, whose opaque objects stay whole, and returns what the method sums up
/// in its first phase, or, given the totals of that, in its second. Throws InputError for a method
/// whose pictures are no sums, for totals of another picture, and as load_part() does.
SumsFile draw_sums(const SumsRequest& request, const SumsFile* totals, const Progress& progress);

/// Draws what is missing to `totals`, of a method's first phase, by drawing the scene anew in
/// `parts` parts, one after the other: returns the totals of the second. Throws InputError when the
/// scene's file is not there or has changed, and as draw_sums() does.
SumsFile draw_second_phase(const SumsFile& totals, int parts, const std::string& gl,
                           const Progress& progress);

/// Makes the picture of the totals of all phases of a method, the first one first. Throws
/// InputError for planes that are not the method's.
Image composite_sums(std::span<const SumsFile> totals, const std::string& gl);

}  // namespace pellucid::compare
