// SPDX-License-Identifier: GPL-3.0-or-later
// What is done with the sorted fragments of a pixel, front to back: they are composited; with the
// define OPTIMIZE_FRAGMENTS with the opacities of least energy, each its own; with OPTIMIZE_OPACITY
// these lower the opacities of the fragments' elements instead.
#include "oit/lists/list_sort.glsl"
#if defined(OPTIMIZE_OPACITY) || defined(OPTIMIZE_FRAGMENTS)
#include "oit/opacity/energy.glsl"
#include "oit/opacity/importance_bits.glsl"

// Sums of g^2: of the pixel, and of what was passed.
struct Importance {
  float total, front;
};

// g and 1 - g.
vec2 importance_of(uint node) { return unpack_importance(imageLoad(nodes, int(node)).w); }

Importance sum_importance(uint list) {
  Importance sums = Importance(0.0, 0.0);
  while (list != 0u) {
    REPEAT8(if (list != 0u) {
      float g = importance_of(list).x;
      sums.total += g * g;
      list = load_node(list).next;
    })
  }
  return sums;
}

// Eq. 2 of Baeza Rojo et al. 2019 for the next fragment.
float optimal_opacity_of(inout Importance sums, uint node) {
  vec2 g = importance_of(node);
  float own = g.x * g.x, behind = sums.total - sums.front - own;
  float opacity = optimal_opacity(energy_weights, g.y, sums.front, behind);
  sums.front += own;
  return opacity;
}
#endif

#ifdef OPTIMIZE_OPACITY
#include "oit/opacity/element_opacity.glsl"
#define Consumer Importance

Consumer start(uint list) { return sum_importance(list); }

// In place of a colour a node has its element.
void consume(inout Consumer c, uint node) {
  vec4 fragment = imageLoad(colors, int(node));
  lower_opacity(int(fragment.x) * 65536 + int(fragment.y), optimal_opacity_of(c, node));
}

void finish(Consumer c) {}
#else
#include "oit/stage/composite.glsl"

struct Consumer {
  Composite composite;
#ifdef OPTIMIZE_FRAGMENTS
  Importance importance;
#endif
};

Consumer start(uint list) {
#ifdef OPTIMIZE_FRAGMENTS
  return Consumer(nothing, sum_importance(list));
#else
  return Consumer(nothing);
#endif
}

void consume(inout Consumer c, uint node) {
  vec4 layer = imageLoad(colors, int(node));
#ifdef OPTIMIZE_FRAGMENTS
  layer.a *= optimal_opacity_of(c.importance, node);
#endif
  add_layer(c.composite, layer);
}

void finish(Consumer c) { picture = over(c.composite, behind()); }
#endif
