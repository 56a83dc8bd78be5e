// SPDX-License-Identifier: GPL-3.0-or-later
// Compositing from front to back (Eq. 12 of Baeza Rojo et al. 2019).
struct Composite {
  vec3 color;
  float transmittance;
};

const Composite nothing = Composite(vec3(0.0), 1.0);

void add_layer(inout Composite c, vec4 layer) {
  c.color += c.transmittance * layer.a * layer.rgb;
  c.transmittance *= 1.0 - layer.a;
}

// `behind`: colour and opacity, premultiplied.
vec4 over(Composite c, vec4 behind) {
  return vec4(c.color, 1.0 - c.transmittance) + c.transmittance * behind;
}
