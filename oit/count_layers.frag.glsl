// Layers per pixel.
#include "fragment.glsl"

layout(location = 0) out float count;

void main() {
  fragment();
  count = 1.0;
}
