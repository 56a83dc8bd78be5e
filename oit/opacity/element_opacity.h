// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "oit/gl/bindings.h"
#include "oit/stage/stage.h"
#include "scene/elements/elements.h"
#include "scene/elements/optimized_opacities.h"

namespace pellucid::oit {

/// An OpacityUnit is what has one opacity.
enum class OpacityUnit {
  element,  // a segment of a line, a patch of a surface, a point
  fragment
};

/// The elements that have one opacity each, and how their opacities are smoothed.
struct ElementOptions {
  int segments = 50000;  // about, of equal length, of all lines
  int patches = 500;     // about, of equal size, of all surfaces
  int smooth = 15;       // iterations of Laplacian smoothing over segments and patches
  scene::SurfaceDistance distances = scene::SurfaceDistance::edges;  // of patches
  double keep = 0;  // share of the last frame's opacities that stays, along a camera path

  bool operator==(const ElementOptions&) const = default;
};
/// Returns the table of ElementOptions.
const OptionTable<ElementOptions>& element_options();

/// Returns the option `per`, of whichever options have one.
template <class Options>
auto opacity_unit_option(OpacityUnit Options::*member) {
  return choice("per", member,
                {{"element", OpacityUnit::element}, {"fragment", OpacityUnit::fragment}},
                "what has one opacity: a segment of a line, a patch of a surface, a point; or each "
                "fragment, as it comes");
}

/// Opacities of the scene's elements, and of its vertices by them: the object-space half of opacity
/// optimization (Baeza Rojo et al. 2019, section 4.2, end of step 2 and step 3). What no
/// fragment of is seen is opaque.
///
/// Where FrameMemory asks for one opacity for all samples, it is the least over all of them, and
/// what has no fragment at any is what is opaque.
///
/// Along a camera path, frames after the first show keep · last + (1 - keep) · found, `last` of the
/// frame before: temporal smoothing, for which the paper has no formula.
///
/// Smoothing runs on the CPU, from and to the driver's buffers: there are few elements to smooth,
/// and points have theirs where they are.
class ElementOpacity {
 public:
  ElementOpacity(Stage& stage, const ElementOptions& options);

  /// Before the pass that calls lower_opacity() of element.glsl for every fragment.
  void begin() const;
  /// After it: for programs whose fragments have these opacities.
  void smooth_and_interpolate();
  /// Returns what that pass finds bound, for element_opacity.glsl.
  Resource image() const { return textures_.opacities.as_image(bindings::element_opacities_image); }
  static FragmentOpacity fragment_opacity() { return {.defines = {{"OPTIMIZED_VERTICES", 1}}}; }
  /// Returns the opacities that were interpolated last.
  scene::OptimizedOpacities found() const;
  std::string describe() const;

 private:
  static constexpr std::uint32_t opaque_bits = 0x3f800000;  // of 1.0f

  void smooth_found(std::vector<float>& opacities) const;
  void blend_with_last(std::vector<float>& opacities);
  void upload_interpolated() const;
  std::vector<float> of_meshes() const;
  std::vector<float> of_lines() const;

  Stage& stage_;
  int iterations_;
  float keep_;
  std::shared_ptr<const scene::Elements> patches_, segments_;
  std::size_t points_;
  ElementTextures textures_;
  std::vector<float> smoothed_;  // of patches, then segments
};

/// `--explain` says this where no opacity is optimized.
inline constexpr const char* nothing_is_important =
    "opacities: the scene's own, nothing in it is important";
/// And this where each fragment has an opacity of its own.
inline constexpr const char* every_fragment_is_optimized =
    "opacities: of least energy, at every fragment";

}  // namespace pellucid::oit
