// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/optical_depth/fourier_projection.h"
#include "scene/opacity_energy.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// An ImportanceResolution says how many pixels share a series.
enum class ImportanceResolution {
  full,  // a series a pixel
  half   // a series for 2 x 2 pixels
};

/// ImportanceOptions are those of the importance's series, beside SeriesOptions.
struct ImportanceOptions {
  int bands = 0;  // of the series; 0: as many as the optical depth's
  ImportanceResolution resolution = ImportanceResolution::full;

  bool operator==(const ImportanceOptions&) const = default;
};
/// Returns the table of ImportanceOptions.
const OptionTable<ImportanceOptions>& importance_options();

/// The importance G(d) of every pixel as a Fourier series (Baeza Rojo et al. 2019, Eq. 11), for
/// programs that include importance_series.glsl. The geometry's importance has to be uploaded.
class ImportanceSeries {
 public:
  /// `options.bands` is at least 1 here; opacities have the energy of `weights`.
  ImportanceSeries(Stage& stage, const ImportanceOptions& options, const SeriesOptions& series,
                   const scene::EnergyWeights& weights);

  void project() const;
  /// Programs that include importance_series.glsl have these defines, and find these bound.
  const Defines& defines() const { return defines_; }
  Resources resources() const;
  /// Returns what Renderer::ray_series() does of the importance.
  scene::RaySeries at(int x, int y, std::span<const double> d) const;
  /// For programs whose fragments have the opacities of least energy, each its own.
  FragmentOpacity fragment_opacity() const;

 private:
  int bands_;
  float margin_;
  int pixels_per_series_;  // in either direction
  Texture coefficients_;
  FourierProjection projection_;
  Buffer energy_;
  Defines defines_;
};

}  // namespace pellucid::oit
