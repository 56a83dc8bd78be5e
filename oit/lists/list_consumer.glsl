// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with the sorted fragments of a pixel, front to back: they are composited, or, with the
// define OPTIMIZE_OPACITY, lower the opacities of their elements.
#include "oit/lists/list_sort.glsl"
#ifdef OPTIMIZE_OPACITY
#include "oit/opacity/element_opacity.glsl"
#include "oit/opacity/energy.glsl"

struct Consumer {
  float total, front;  // sums of g^2: of the pixel, and of what was passed
};

float squared_importance(uint node) {
  float g = imageLoad(colors, int(node)).x;
  return g * g;
}

Consumer start(uint list) {
  Consumer c = Consumer(0.0, 0.0);
  while (list != 0u) {
    REPEAT8(if (list != 0u) {
      c.total += squared_importance(list);
      list = load_node(list).next;
    })
  }
  return c;
}

// Eq. 2 of Baeza Rojo et al. 2019. In place of a colour a node has its importance and element.
void consume(inout Consumer c, uint node) {
  vec4 fragment = imageLoad(colors, int(node));
  float g = fragment.x, behind = c.total - c.front - g * g;
  int element = int(fragment.y) * 65536 + int(fragment.z);
  lower_opacity(element, optimal_opacity(energy_weights, g, c.front, behind));
  c.front += g * g;
}

void finish(Consumer c) {}
#else
#include "oit/stage/composite.glsl"
#define Consumer Composite

Consumer start(uint list) { return nothing; }
void consume(inout Consumer c, uint node) { add_layer(c, imageLoad(colors, int(node))); }
void finish(Consumer c) { picture = over(c, behind()); }
#endif
