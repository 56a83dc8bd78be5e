// The vertex shader of every geometry pass.
layout(location = 0) in vec3 position;  // view frame: x right and y up in view units; depth d
layout(location = 1) in vec4 color;     // straight colour, opacity

uniform vec2 clip_scale;  // from view units to clip space; y points down: row 0 is the top
uniform vec2 clip_w;      // w = clip_w.x + clip_w.y d
uniform vec2 clip_z;      // likewise z, chosen so that only what lies behind the eye is clipped

layout(location = 0) out vec4 vertex_color;
layout(location = 1) out float vertex_depth;
#ifdef LIT
layout(location = 2) in vec3 normal;  // view frame
layout(location = 2) out vec3 vertex_normal;
layout(location = 3) out vec3 vertex_position;  // view frame, the eye at 0
#endif

void main() {
  vec2 wz = vec2(clip_w.x + clip_w.y * position.z, clip_z.x + clip_z.y * position.z);
  gl_Position = vec4(position.xy * clip_scale, wz.y, wz.x);
  vertex_color = color;
  vertex_depth = position.z;
#ifdef LIT
  vertex_normal = normal;
  vertex_position = vec3(position.xy, wz.x);
#endif
}
