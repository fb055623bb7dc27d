// Stands before every shader.
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform vec3 forward;
uniform bool orthographic;
uniform sampler2D nodePositions;

vec3 positionOf(uint node) {
  return texelFetch(nodePositions, ivec2(int(node & 2047u), int(node >> 11u)), 0).xyz;
}

vec3 towardsEye(vec3 world) { return orthographic ? -forward : normalize(eye - world); }
