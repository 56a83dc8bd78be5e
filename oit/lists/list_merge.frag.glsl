// SPDX-License-Identifier: GPL-3.0-or-later
// One level of the merge sort of the lists that are left: sorted runs of `length` nodes become runs
// of twice as many.
#include "oit/lists/list_sort.glsl"

uniform int length_of_runs;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint list = imageLoad(heads, pixel).r;
  if (list != 0u) imageStore(heads, pixel, uvec4(merge_runs(list, length_of_runs)));
}
