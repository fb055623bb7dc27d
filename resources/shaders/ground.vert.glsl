uniform mat4 worldFromModel;
uniform float reach;  // cm
uniform vec2 about;   // its middle in the plane's own coordinates, cm

out vec2 plane;
out vec3 world;

void main() {
  plane = about + reach * (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0);
  world = (worldFromModel * vec4(plane, 0.0, 1.0)).xyz;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
