// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "oit/stage/stage.h"

namespace pellucid::oit {

/// The pass that projects what fragments carry onto Fourier series (Baeza Rojo et al. 2019, Eqs. 8,
/// 11, 16, 17), a series a pixel, by adding: two bands in a target, up to 15 in one pass. It takes
/// the parameters `at`, `margin`, `precision` and `subset` of oit/methods/fourier/fourier.h, and
/// `clamp`.
class FourierProjection {
 public:
  /// Of the optical depth; of the importance where PROJECT_IMPORTANCE is among the defines.
  /// `coefficients` as fourier_target() says; it has to outlive this.
  FourierProjection(const Stage& stage, const Texture& coefficients, int bands,
                    const Parameters& parameters, const Defines& defines = {},
                    const FragmentOpacity& opacity = {});

  void project() const;

 private:
  struct Pass {
    Framebuffer targets;
    GeometryProgram program;
  };
  Pass pass(int first_target, const Parameters& parameters, Defines defines,
            const FragmentOpacity& opacity) const;

  const Stage& stage_;
  const Texture& coefficients_;
  int bands_;
  std::optional<Subset> subset_;
  std::vector<Pass> passes_;
};

/// What holds the series' coefficients: an array of so many layers.
struct FourierTarget {
  GLenum format;
  int layers;
};
FourierTarget fourier_target(int bands, const Parameters& parameters);

/// A program that clamps opacities at `clamp` and samples or makes a series of that `margin`.
GeometryProgram fourier_program(const Stage& stage, std::string_view fragment, Defines defines,
                                const Parameters& parameters, const FragmentOpacity& opacity = {});

}  // namespace pellucid::oit
