// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "oit/stage/summing_method.h"

namespace pellucid::oit {

/// OpticalDepthPasses are what the methods share that hold the optical depth tau(d) of a pixel as a
/// few coefficients (bins, bands, moments):
///
///   project     sums every fragment's optical depth into the coefficients; the method's own
///   weight      sums the colours, each weighted by what the coefficients say of tau at its depth
///   composite   lays that sum over the background
///
/// The weight pass has coefficient target i at coefficients_image + i. The composite pass has them
/// there, too, and target 0, which says how opaque the pixel is, as coefficients_texture beside
/// color_sums_texture: it reads what its shader prefers.
class OpticalDepthPasses {
 public:
  /// A Target holds some of a pixel's coefficients: its name in the ledger, its format and layers.
  struct Target {
    std::string_view name;
    GLenum format;
    int layers = 0;
  };

  OpticalDepthPasses(Stage& stage, const std::vector<Target>& coefficients, GeometryProgram weight,
                     Program composite);

  const Texture& coefficients(int target) const { return coefficients_[std::size_t(target)]; }
  /// Returns the targets as images, target i at coefficients_image + i.
  Resources coefficient_images() const;

  /// Returns the targets of a round of SummingMethod: 0 projects, 1 weights. The coefficients'
  /// texels hold `numbers`.
  std::vector<SumTarget> targets(int round,
                                 SumTarget::Numbers numbers = SumTarget::Numbers::floats) const;
  void weight(Frame& frame) const;
  void composite(Frame& frame) const;

 private:
  const Stage& stage_;
  std::vector<std::string_view> names_;
  std::vector<Texture> coefficients_;
  Texture color_sum_;
  Framebuffer color_sum_target_;
  GeometryProgram weight_;
  Program composite_;
};

/// A program of its project or weight pass, where no opacity is above `clamp`.
GeometryProgram clamped_geometry_program(const Stage& stage, std::string_view fragment,
                                         Defines defines, double clamp,
                                         const FragmentOpacity& opacity = {});

/// The largest opacity of such a method unless it is told otherwise: that of 1 has no finite
/// optical depth.
inline constexpr double usual_clamp = 0.9999;

// Options of the methods that weight by Eq. 15 of Baeza Rojo, Gross and Guenther 2019.
/// Makes the row `normalize`.
template <class Options>
Option<Options> normalize_option(bool Options::*member) {
  return flag("normalize", member,
              "on: Eq. 19; off: Eq. 15, whose colours may leave their convex hull");
}
/// Makes the row `clamp`.
template <class Options>
Option<Options> clamp_option(double Options::*member) {
  return number("clamp", member,
                {.min = 0,
                 .max = 0.999999,
                 .unit = "1",
                 .help = "largest opacity; Eq. 13 divides by 1 - alpha"});
}

}  // namespace pellucid::oit
