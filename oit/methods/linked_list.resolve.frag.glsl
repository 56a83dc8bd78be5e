#include "composite.glsl"
#include "fragment_list.glsl"

uint next_of(uint node) { return imageLoad(nexts, int(node)).r; }
void set_next(uint node, uint next) { imageStore(nexts, int(node), uvec4(next)); }
uvec2 key_of(uint node) { return imageLoad(keys, int(node)).rg; }

// Nearer first; equal depths in the order of submission. Bits of floats >= 0 compare as they do.
bool before(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

const int RUN = 32;

// Takes up to RUN nodes off `list`, sorts them by insertion and links them. Returns how many.
int sort_run(inout uint list, out uint first, out uint last) {
  uvec2 key[RUN];
  uint node[RUN];
  int n = 0;
  for (; n < RUN && list != 0u; ++n) {
    uvec2 k = key_of(list);
    int i = n;
    for (; i > 0 && before(k, key[i - 1]); --i) {
      key[i] = key[i - 1];
      node[i] = node[i - 1];
    }
    key[i] = k;
    node[i] = list;
    list = next_of(list);
  }
  for (int i = 1; i < n; ++i) set_next(node[i - 1], node[i]);
  first = node[0];
  last = node[n - 1];
  return n;
}

// Sorted runs of RUN nodes, one behind the other.
uint sort_runs(uint list, out int n) {
  uint sorted = 0u, tail = 0u;
  n = 0;
  while (list != 0u) {
    uint first, last;
    n += sort_run(list, first, last);
    if (tail == 0u) sorted = first;
    else set_next(tail, first);
    tail = last;
  }
  if (tail != 0u) set_next(tail, 0u);
  return sorted;
}

// Merges neighbouring runs of `run` nodes throughout the list.
uint merge_runs(uint list, int run) {
  uint sorted = 0u, tail = 0u, p = list;
  while (p != 0u) {
    uint q = p;
    int left = 0;
    for (; left < run && q != 0u; ++left) q = next_of(q);
    int right = run;
    while (left > 0 || (right > 0 && q != 0u)) {
      bool from_right = left == 0 || (right > 0 && q != 0u && before(key_of(q), key_of(p)));
      uint taken = from_right ? q : p;
      if (from_right) { q = next_of(q); --right; }
      else { p = next_of(p); --left; }
      if (tail == 0u) sorted = taken;
      else set_next(tail, taken);
      tail = taken;
    }
    p = q;
  }
  set_next(tail, 0u);
  return sorted;
}

void main() {
  uint list = imageLoad(heads, ivec2(gl_FragCoord.xy)).r;
  int n;
  list = sort_runs(list, n);
  for (int run = RUN; run < n; run *= 2) list = merge_runs(list, run);
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  for (; list != 0u && transmittance > 0.0; list = next_of(list)) {
    vec4 layer = imageLoad(colors, int(list));
    color += transmittance * layer.a * layer.rgb;
    transmittance *= 1.0 - layer.a;
  }
  picture = vec4(color + transmittance * background, 1.0 - transmittance);
}
