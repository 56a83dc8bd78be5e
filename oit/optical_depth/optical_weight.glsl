// SPDX-License-Identifier: GPL-3.0-or-later
// The weight of a fragment's colour where its optical depth is known, for GLSL and, through GLM,
// for C++. alpha < 1.
//
// tau is held in [-60, 60]: an approximation that rings over hundreds of nearly opaque layers would
// leave the range of float otherwise.
const float largest_tau = 60.0f;
float transmittance_at(float tau) { return exp(clamp(-tau, -largest_tau, largest_tau)); }

// Eq. 15 of Baeza Rojo et al. 2019: tau is the optical depth just behind the fragment.
float optical_weight(float alpha, float tau) {
  return alpha / (1.0f - alpha) * transmittance_at(tau);
}

// The same where tau is the mean of the optical depths in front of the fragment and behind it,
// which differ by -ln(1 - alpha).
float optical_weight_middle(float alpha, float tau) {
  return alpha / sqrt(1.0f - alpha) * transmittance_at(tau);
}
