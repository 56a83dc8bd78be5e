// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/fourier_projection.h"

namespace pellucid::oit {

/// The importance G(d) of every pixel as a Fourier series (Baeza Rojo et al. 2019, Eq. 11), for
/// programs that include importance_series.glsl. It takes the parameters of scene/opacity_energy.h,
/// `importance-bands`, `importance-resolution`, and `at`, `margin`, `precision` and `subset` of
/// oit/methods/fourier/fourier.h. The geometry's importance has to be uploaded.
class ImportanceSeries {
 public:
  ImportanceSeries(Stage& stage, const Parameters& parameters);

  void project() const;
  /// Of programs that include importance_series.glsl, and what these find bound.
  const Defines& defines() const { return defines_; }
  Resources resources() const;
  /// For programs whose fragments have the opacities of least energy, each its own.
  FragmentOpacity fragment_opacity() const;

 private:
  Texture coefficients_;
  FourierProjection projection_;
  Buffer energy_;
  Defines defines_;
};

}  // namespace pellucid::oit
