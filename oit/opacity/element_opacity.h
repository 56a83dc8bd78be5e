// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/bindings.h"
#include "oit/stage/stage.h"
#include "scene/elements/elements.h"

namespace pellucid::oit {

/// Opacities of the scene's elements, and of its vertices by them: the object-space half of opacity
/// optimization (Baeza Rojo et al. 2019, section 4.2, end of step 2 and step 3). It takes the
/// parameters `segments`, `patches`, `smooth` and `keep`. What no fragment of is seen is opaque.
///
/// Along a camera path, frames after the first show keep · last + (1 - keep) · found, `last` of the
/// frame before: temporal smoothing, for which the paper has no formula.
///
/// Smoothing runs on the CPU, from and to the driver's buffers: there are few elements to smooth,
/// and points have theirs where they are.
class ElementOpacity {
 public:
  ElementOpacity(Stage& stage, const Parameters& parameters);

  /// Before the pass that calls lower_opacity() of element.glsl for every fragment.
  void begin() const { textures_.opacities.buffer().clear(opaque_bits); }
  /// After it: for programs whose fragments have these opacities.
  void smooth_and_interpolate();
  /// What that pass finds bound, for element_opacity.glsl.
  Resource image() const { return textures_.opacities.as_image(bindings::element_opacities_image); }
  static FragmentOpacity fragment_opacity() { return {.defines = {{"OPTIMIZED_VERTICES", 1}}}; }
  std::string describe() const;

 private:
  static constexpr std::uint32_t opaque_bits = 0x3f800000;  // of 1.0f

  void smooth_found(std::vector<float>& opacities) const;
  void blend_with_last(std::vector<float>& opacities);
  void interpolate(const std::vector<float>& opacities) const;

  Stage& stage_;
  int iterations_;
  float keep_;
  std::shared_ptr<const scene::Elements> patches_, segments_;
  std::size_t points_;
  ElementTextures textures_;
};

/// Whether any transparent object of the scene has some: otherwise no opacity changes.
bool has_importance(const scene::Scene& scene);
inline constexpr const char* nothing_is_important =
    "opacities: the scene's own, nothing in it is important";

inline constexpr auto element_parameters = std::to_array<ParameterSpec>(
    {{.name = "segments",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "50000",
      .min = 1,
      .max = 1e7,
      .unit = "segments",
      .help = "of equal length that all lines are cut into, about; each has one opacity"},
     {.name = "patches",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "500",
      .min = 1,
      .max = 1e6,
      .unit = "patches",
      .help = "of equal size that all surfaces are cut into, about; each has one opacity"},
     {.name = "smooth",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "15",
      .min = 0,
      .max = 1000,
      .unit = "iterations",
      .help = "of Laplacian smoothing of the opacities of segments and patches"},
     {.name = "keep",
      .kind = ParameterSpec::Kind::real,
      .default_value = "0",
      .min = 0,
      .max = 1,
      .help = "along a camera path, the share of the last frame's opacities that stays"}});

}  // namespace pellucid::oit
