// The last pass of every method: one layer of `color` and `opacity` over the background.
uniform vec3 background;

layout(location = 0) out vec4 picture;

void composite(vec3 color, float alpha) {
  picture = vec4(mix(background, color, alpha), alpha);
}

// A weighted mean: the sum of w C and of w. A pixel whose fragments weigh nothing has no colour.
void composite_mean(vec4 sum, float alpha) {
  if (sum.a > 0.0) composite(sum.rgb / sum.a, alpha);
  else composite(vec3(0.0), 0.0);
}
