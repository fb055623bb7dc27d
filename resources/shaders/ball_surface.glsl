in vec3 world;
flat in vec3 middle;
flat in float size;
flat in vec4 colour;
flat in uint ball;

// Where the line of sight meets the ball; the depth is set to it.
vec3 meetBall() {
  vec3 along = -towardsEye(world);
  vec3 from = world - middle;
  float half_ = dot(from, along);
  float inside = half_ * half_ - dot(from, from) + size * size;
  if (inside < 0.0) discard;
  vec3 at = world + (-half_ - sqrt(inside)) * along;
  vec4 clip = clipFromWorld * vec4(at, 1.0);
  gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
  return at;
}
