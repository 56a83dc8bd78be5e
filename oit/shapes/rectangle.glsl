// SPDX-License-Identifier: GPL-3.0-or-later
// Rectangles of the picture around what is cast, of two triangles each. After view.glsl.
uniform uint first_record, stride_of_records;

// Of a record that has so many rectangles.
int record_of_vertex(int rectangles) {
  return int(first_record) + gl_VertexID / (6 * rectangles) * int(stride_of_records);
}

// Bounds: from and to along a first axis, then along a second one.
vec2 corner_of_vertex(vec4 bounds) {
  const int corners[6] = int[](0, 1, 2, 2, 1, 3);
  int corner = corners[gl_VertexID % 6];
  return vec2(corner % 2 == 0 ? bounds.x : bounds.y, corner < 2 ? bounds.z : bounds.w);
}

vec4 clip_position_of(vec2 position) {
  return vec4(position * clip_scale + clip_shift, 0.0, 1.0);
}
