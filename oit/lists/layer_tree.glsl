// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of one pixel as a search tree over depth, for GLSL and, through GLM, for C++.
// Whoever includes this defines load_…() and store_…().
//
// Algorithm 1 of Tian and Guenther hangs a new node below the last one of its search path: input
// that is sorted makes a list of the tree. Here nodes have random priorities and none is above one
// of a higher priority (a treap: Seidel and Aragon 1996, "Randomized search trees", Algorithmica
// 16), so that a path has about 2 ln n nodes, whatever the order of the input. What a search meets
// first depends on the tree's shape: first_met keeps that of Algorithm 1, and a path may then be as
// long as the pixel has layers, up to `longest_path`.
//
// Layers are also linked from front to back: a traversal needs neither recursion nor a stack.
#include "oit/stage/random.glsl"

struct Layer {
  uint left;  // in front; 0: nothing
  uint right;
  float depth;
  uint priority;  // its lowest bit marks a crossing
};

struct Tree {
  uint root;  // 0: the pixel has no layer yet
  uint first;
};

// A fragment to be inserted.
struct Entry {
  float depth;
  bool crossing;  // all of a layer by itself, merged with nothing: a mesh's triangle
  uint order;     // among crossings of equal depth
};

// Where an entry belongs in a tree.
struct Place {
  uint nearest;  // layer that it is merged with; 0: none is near enough
  uint before;   // layer in front of it; 0: it is the first
  uint parent;   // what a new layer would hang below; 0: it would be the root
  bool left;     // … on which side
  uint subtree;  // … and whose place it would take
  uint priority;
  int steps;      // length of the search path
  bool too_deep;  // the path is longer than longest_path: nothing else is known
};

// Steps of a search path at most. llvmpipe ends a shader's loops after 65535 iterations, counted
// over the 8 pixels that it runs at once, without an error. Only first_met comes near.
const int longest_path = 4000;

Layer load_layer(uint id);
void store_layer(uint id, Layer layer);
uint load_next(uint id);  // the layer behind; 0: none
void store_next(uint id, uint next);
uint load_order(uint id);  // of a crossing

bool is_crossing(Layer layer) { return (layer.priority & 1u) == 1u; }

// A function of the entry alone: the tree of a pixel is the same whatever other pixels hold.
//
// Of equal priorities, which those have that first_met may merge, the later one hangs below: their
// tree is that of Algorithm 1. Crossings, of which the algorithm knows nothing, are balanced below.
uint priority_of(Entry entry, bool first_met) {
  const uint highest = 0xfffffffeu;
  uint bits = hash(floatBitsToUint(entry.depth) ^ hash(entry.order));
  if (!entry.crossing) return first_met ? highest : bits & ~1u;
  return first_met ? min(bits | 1u, highest - 1u) : bits | 1u;
}

// Diff of Algorithm 1: the squared difference of depths.
float depth_difference(float a, float b) { return (a - b) * (a - b); }

// Fragments of equal depth that are not merged stay in the order in which they came, crossings in
// that of their primitives.
bool is_in_front(Entry entry, uint id, Layer layer) {
  if (entry.depth != layer.depth) return entry.depth < layer.depth;
  return entry.crossing && is_crossing(layer) && entry.order < load_order(id);
}

// Algorithm 1 merges a fragment into the first layer within epsilon that it meets on its way
// (first_met). A layer's depth, the mean of its fragments, may so be drawn past a neighbour's, and
// the search tree is none any more. The nearest of the layers within epsilon, looked for on the
// whole path, cannot be passed: the fragment lies on its side of the middle between the two, and so
// does the new mean.
Place find_place(Tree tree, Entry entry, float epsilon2, bool first_met) {
  Place place;
  place.nearest = place.before = place.parent = place.subtree = 0u;
  place.left = false;
  place.priority = priority_of(entry, first_met);
  place.steps = 0;
  float nearest = epsilon2;
  bool descending = true;
  uint id = tree.root;
  for (; id != 0u && place.steps < longest_path; ++place.steps) {
    Layer layer = load_layer(id);
    float difference = depth_difference(entry.depth, layer.depth);
    if (difference < nearest && !entry.crossing && !is_crossing(layer)) {
      nearest = difference;
      place.nearest = id;
      if (first_met) break;
    }
    bool left = is_in_front(entry, id, layer);
    if (descending && place.priority > layer.priority) {
      descending = false;
      place.subtree = id;
    }
    if (descending) {
      place.parent = id;
      place.left = left;
    }
    if (!left) place.before = id;
    id = left ? layer.left : layer.right;
  }
  place.too_deep = id != 0u && place.nearest == 0u;
  return place;
}

void hang(uint parent, bool left, uint child) {
  Layer layer = load_layer(parent);
  if (left) layer.left = child;
  else layer.right = child;
  store_layer(parent, layer);
}

// Hangs what a subtree has in front of the entry to the left of layer `id`, the rest to its right.
void split(Entry entry, uint subtree, uint id) {
  uint front = id, back = id;  // what the next piece of either side hangs below
  while (subtree != 0u) {
    Layer layer = load_layer(subtree);
    if (is_in_front(entry, subtree, layer)) {
      hang(back, back != id, subtree);
      back = subtree;
      subtree = layer.left;
    } else {
      hang(front, front == id, subtree);
      front = subtree;
      subtree = layer.right;
    }
  }
  hang(back, back != id, 0u);
  hang(front, front == id, 0u);
}

// The entry becomes layer `id`.
Tree insert_layer(Tree tree, Entry entry, Place place, uint id) {
  Layer layer;
  layer.left = layer.right = 0u;
  layer.depth = entry.depth;
  layer.priority = place.priority;
  store_layer(id, layer);
  split(entry, place.subtree, id);
  if (place.parent == 0u) tree.root = id;
  else hang(place.parent, place.left, id);
  if (place.before == 0u) {
    store_next(id, tree.first);
    tree.first = id;
  } else {
    store_next(id, load_next(place.before));
    store_next(place.before, id);
  }
  return tree;
}

// Average of Algorithm 1: the mean of n values from that of n - 1 and the last one.
float running_mean(float mean, float value, float n) { return mean + (value - mean) / n; }
vec4 running_mean(vec4 mean, vec4 value, float n) { return mean + (value - mean) / n; }
