// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FRONT_TO_BACK
#define FRONT_TO_BACK
// Compositing from front to back (Eq. 12 of Baeza Rojo et al. 2019).
struct Composite {
  vec3 color;  // premultiplied
  float transmittance;
};

const Composite nothing = Composite(vec3(0.0), 1.0);

// `layer`: straight colour, opacity.
void add_layer(inout Composite c, vec4 layer) {
  c.color += c.transmittance * layer.a * layer.rgb;
  c.transmittance *= 1.0 - layer.a;
}

// Two as one.
Composite over(Composite front, Composite back) {
  return Composite(front.color + front.transmittance * back.color,
                   front.transmittance * back.transmittance);
}

// `behind`: colour and opacity, premultiplied; and the sum, too.
vec4 over(Composite c, vec4 behind) {
  return vec4(c.color, 1.0 - c.transmittance) + c.transmittance * behind;
}

// All three: colour and opacity, premultiplied.
vec4 over(vec4 front, vec4 behind) { return front + (1.0 - front.a) * behind; }
#endif
