// A square that covers the ball, turned towards the eye.
layout(location = 0) in uint node;
layout(location = 1) in float radius;
layout(location = 2) in vec4 colourAndGlaze;

out vec3 world;
flat out vec3 middle;
flat out float size;
flat out vec4 colour;
flat out uint ball;

void main() {
  middle = positionOf(node);
  size = radius;
  colour = colourAndGlaze;
  ball = node;
  vec3 away = towardsEye(middle);
  vec3 across = normalize(cross(abs(away.z) < 0.99 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), away));
  vec3 upwards = cross(away, across);
  float distance = length(eye - middle);
  // Near the eye the outline of a ball is wider than the ball.
  float wider = orthographic ? 1.0 : distance / sqrt(max(distance * distance - radius * radius, 1e-6));
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  world = middle + wider * radius * (corner.x * across + corner.y * upwards);
  gl_Position = radius > 0.0 ? clipFromWorld * vec4(world, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
