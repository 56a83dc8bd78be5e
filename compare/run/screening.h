// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compare/methods/method_call.h"
#include "compare/study/screen_rule.h"
#include "core/progress.h"
#include "scene/renderer.h"
#include "scene/scene.h"

namespace pellucid::compare {

/// A SmallPicture is what one picture of a part of the size told of a call.
struct SmallPicture {
  std::string call;
  double seconds = 0;  // of one picture
  double rmse = 0;     // against the reference's picture of the same size
  std::uint64_t bytes = 0;
};

/// A ScreenedCall is a call that another one beat in a small picture.
struct ScreenedCall {
  double size = 1;  // of the picture's sides to the scene's
  SmallPicture own, by;
};

/// Returns which of the pictures are beaten, and by whom: by one that is not beaten itself, of
/// these the one of least error. `own` is beaten by `by` when the other took less than 1 / margin
/// of its time and errs at most 1 / margin of its error, or not at all as it does, with no more
/// bytes.
std::vector<ScreenedCall> beaten(std::span<const SmallPicture> pictures, double size,
                                 double margin);

/// Draws the scene in each of the rule's sizes, by all calls that are still in, and returns those
/// that fell out. A call that fails stays in: what is wrong with it shows in full; and so does one
/// that integrates surfaces, or chooses opacities where the reference does not. Throws what the
/// reference throws.
std::vector<ScreenedCall> screen_calls(std::span<const MethodCall> calls,
                                       const MethodCall& reference, const scene::Scene& scene,
                                       const ScreenRule& rule, const scene::RenderContext& context,
                                       const std::function<void(const std::string&)>& tell);

}  // namespace pellucid::compare
