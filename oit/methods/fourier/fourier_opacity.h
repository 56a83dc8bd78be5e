// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/methods/fourier/fourier.h"
#include "oit/opacity/element_opacity.h"
#include "oit/opacity/importance_series.h"

namespace pellucid::oit {

/// An OpacityCompositing says what the colours are composited by.
enum class OpacityCompositing { fourier, lists };

/// FourierOpacityOptions are those of the method `fourier-opacity`.
struct FourierOpacityOptions {
  scene::EnergyOptions energy;
  FourierOptions fourier;  // its series options are those of the importance, too
  ImportanceOptions importance;
  OpacityUnit per = OpacityUnit::element;
  OpacityCompositing transmittance = OpacityCompositing::fourier;
  ElementOptions elements;

  bool operator==(const FourierOpacityOptions&) const = default;
};
/// Returns the table of FourierOpacityOptions.
const OptionTable<FourierOpacityOptions>& fourier_opacity_options();

/// Fourier opacity optimization (Baeza Rojo, Gross and Guenther 2019, "Fourier opacity optimization
/// for scalable exploration", TVCG): each fragment's opacity is the one of least energy (Eqs. 1, 2,
/// 10), so that nothing hides what is important, from a Fourier series of the importance G(d) of
/// its pixel (Eq. 11); then all are composited by a Fourier series of the optical depth, as the
/// method `fourier` does (Eqs. 14 to 19).
///
/// A segment of a line, a patch of a surface and a point have the least opacity of their fragments,
/// smoothed in object space (sections 2.2.4, 4.1 and 4.2, see scene/elements/elements.h);
/// `per=fragment` leaves that out.
///
/// The optimal opacity is multiplied by the scene's own, as in `decoupled`. Without importance in
/// the scene nothing of the first series is made. Opaque objects are context: they hide what lies
/// behind them, and their own importance does not count.
///
/// Accuracy: no bound; per fragment, `decoupled:bands` has the same opacities up to float rounding.
const scene::MethodRow& fourier_opacity_method();

}  // namespace pellucid::oit
