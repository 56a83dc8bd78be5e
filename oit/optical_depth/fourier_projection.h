// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "oit/optical_depth/optical_depth_passes.h"

namespace pellucid::oit {

/// A SeriesValue says which value of the series is taken at a fragment.
enum class SeriesValue {
  behind,  // as in Eq. 15
  middle   // of the fragment's step, whither a series converges
};

/// SeriesOptions are those of the Fourier series of a pixel, and of the fragments in it.
struct SeriesOptions {
  double clamp = usual_clamp;  // largest opacity, below 1: Eq. 13 divides by 1 - alpha
  SeriesValue at = SeriesValue::behind;
  double margin = 0;   // depth ranges that the period exceeds the scene's by on either side, ≤ 1
  int precision = 32;  // bits of a coefficient, 32 or 16
  int subset = 1;      // every n-th primitive is projected, n-fold (section 5.5.3)

  bool operator==(const SeriesOptions&) const = default;
};
/// Returns the table of SeriesOptions.
const OptionTable<SeriesOptions>& series_options();

/// A FourierProjection is the pass that projects what fragments carry onto Fourier series (Baeza
/// Rojo et al. 2019, Eqs. 8, 11, 16, 17), a series a pixel, by adding: two bands in a target, up to
/// 15 in one pass.
class FourierProjection {
 public:
  /// Projects the optical depth; the importance where PROJECT_IMPORTANCE is among the defines.
  /// `coefficients` as fourier_target() says; it has to outlive this.
  FourierProjection(const Stage& stage, const Texture& coefficients, int bands,
                    const SeriesOptions& options, const Defines& defines = {},
                    const FragmentOpacity& opacity = {});

  void project() const;

 private:
  struct Pass {
    Framebuffer targets;
    GeometryProgram program;
  };
  Pass pass(int first_target, const SeriesOptions& options, Defines defines,
            const FragmentOpacity& opacity) const;

  const Stage& stage_;
  const Texture& coefficients_;
  int bands_;
  std::optional<Subset> subset_;
  std::vector<Pass> passes_;
};

/// A FourierTarget holds the series' coefficients: an array of so many layers.
struct FourierTarget {
  GLenum format;
  int layers;
};
/// Returns the array that so many bands, and band 0, take.
FourierTarget fourier_target(int bands, const SeriesOptions& options);

/// A program that clamps opacities and samples or makes a series of that margin.
GeometryProgram fourier_program(const Stage& stage, std::string_view fragment, Defines defines,
                                const SeriesOptions& options, const FragmentOpacity& opacity = {});

}  // namespace pellucid::oit
