// What every method's geometry pass is given of a fragment.
layout(location = 0) in vec4 vertex_color;
layout(location = 1) in float vertex_depth;
#ifdef LIT
layout(location = 2) in vec3 vertex_normal;
layout(location = 3) in vec3 vertex_position;
#endif

struct Fragment {
  vec3 color;   // straight
  float alpha;  // opacity in [0, 1]
  float depth;  // d in [0, 1]: 0 the nearest, 1 the farthest depth of the scene
};

// Two-sided diffuse light from the eye: |n . v|.
float headlight() {
#ifdef LIT
#ifdef ORTHOGRAPHIC
  return abs(normalize(vertex_normal).z);
#else
  return abs(dot(normalize(vertex_normal), normalize(vertex_position)));
#endif
#else
  return 1.0;
#endif
}

Fragment fragment() {
  // Interpolation may round an opacity or a depth of 1 to just above it.
  return Fragment(vertex_color.rgb * headlight(), clamp(vertex_color.a, 0.0, 1.0),
                  clamp(vertex_depth, 0.0, 1.0));
}
