// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/files/files_read.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// A GivenRenderer shows one picture whenever it is asked.
class GivenRenderer : public scene::Renderer {
 public:
  scene::Rendering render(const scene::RenderRequest&) final {
    if (!rendering_.image.pixels.empty()) return rendering_;
    const UnnotedReads accounted_for_by_the_fingerprint;
    return rendering_ = make_once();
  }

 private:
  virtual scene::Rendering make_once() = 0;

  scene::Rendering rendering_;
};

/// Reads the picture. Throws WorkError when it is missing or damaged, or has not the scene's size.
Image read_given_picture(const std::string& path, const scene::Scene& scene);

/// Returns the text with each key, in braces, replaced by its value.
std::string with_values(std::string text, const std::map<std::string, std::string>& values);

}  // namespace pellucid::compare
