// Layers per pixel.
layout(location = 0) out float count;

void main() { count = 1.0; }
