// Counted by the query around this pass.
#include "fragment.glsl"

void main() { fragment(); }
