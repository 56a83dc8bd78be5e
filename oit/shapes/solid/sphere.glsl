// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere as the ray of a pixel meets it. After solid.glsl.
#ifdef OPTIMIZED_VERTICES
uniform uint first_point_element, others;  // see element.glsl
layout(binding = element_opacities_texture) uniform usamplerBuffer element_opacities;
#endif

void set_vertex(int point, SolidPoint from) {
  vertex_color = load_color(point);
  vertex_importance = interpolated_importance(from.importance);
#ifdef OPTIMIZED_VERTICES
  uint element = first_point_element + others + uint(point);
  vertex_opacity = uintBitsToFloat(texelFetch(element_opacities, int(element)).r);
#endif
}

// Returns whether there is a fragment.
bool meet() {
  int point = int(links_of(vertex_record).x);
  SolidPoint center = load_point(point);
  double radius = radius_of(vertex_record);
  LocalRay ray = local_ray(pixel_ray_of_target(), center.position);
  dvec2 chord = ball_chord(ray, radius);
  if (!has_chord(chord)) return false;
  set_vertex(point, center);
  precise double t = leaves() ? chord.y : chord.x;
  vertex_direction = vec3((ray.offset + t * ray.direction) / radius);
  // At the ends of the chord n . v is half its length over the radius.
  cast_facing = float(0.5lf * (chord.y - chord.x) / radius);
  return set_depth(ray.nearest_depth + t * ray.direction.z);
}
