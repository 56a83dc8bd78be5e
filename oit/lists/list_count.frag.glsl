// Counted by the query around this pass.
#include "oit/shapes/fragment.glsl"

void main() { fragment(); }
