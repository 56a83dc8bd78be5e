#include "fragment.glsl"
#include "element.glsl"
#include "element_opacity.glsl"
#include "importance_series.glsl"

void main() {
  Fragment f = fragment();
  lower_opacity(element(), opacity_by_series(importance(), f.depth));
}
