// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/optical_depth/series_readback.h"

#include <glm/vec2.hpp>
#include <vector>

namespace pellucid::oit::fourier_glsl {

using namespace glm;
#include "oit/optical_depth/fourier_series.glsl"

}  // namespace pellucid::oit::fourier_glsl

namespace pellucid::oit {
namespace {

float integral(std::span<const glm::vec2> coefficients, float d) {
  const glm::vec2 one_band = fourier_glsl::first_wave(d);
  glm::vec2 wave(1, 0);
  float sum = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    sum += fourier_glsl::fourier_integral(int(k), coefficients[k], d, wave);
    wave = fourier_glsl::add_angles(wave, one_band);
  }
  return sum;
}

}  // namespace

scene::RaySeries read_series(const Texture& coefficients, int bands, float margin, int x, int y,
                             std::span<const double> d) {
  const int layers = (bands + 2) / 2;  // band 0 included
  std::vector<glm::vec2> bands_of_pixel(std::size_t(2 * layers));
  coefficients.read_pixel(x, y, layers, GL_RGBA, GL_FLOAT,
                          bands_of_pixel.size() * sizeof bands_of_pixel[0], bands_of_pixel.data());
  bands_of_pixel.resize(std::size_t(bands) + 1);
  scene::RaySeries result;
  for (const glm::vec2& band : bands_of_pixel) result.harmonics.emplace_back(band.x, band.y);
  for (const double depth : d)
    result.values.push_back(integral(bands_of_pixel, (float(depth) + margin) / (1 + 2 * margin)));
  return result;
}

}  // namespace pellucid::oit
