// A bond as a strip as wide as so many pixels.
layout(location = 0) in uvec2 ends;
layout(location = 1) in vec2 restLengthAndThreshold;
layout(location = 2) in uint flags;

uniform vec2 pixels;  // of the picture
uniform float width;
uniform bool brokenToo;
uniform bool glueOnly;
uniform vec3 brokenColour;
uniform vec3 slackColour;  // of bonds that are not stretched, and of those that never break
uniform vec3 glueColour;
uniform vec3 viridis[7];

flat out uint bond;
flat out vec4 colour;
out vec3 world;

vec4 strainColour(float length_) {
  float strain = length_ / restLengthAndThreshold.x - 1.0;
  float share = isinf(restLengthAndThreshold.y) ? 0.0 : strain / restLengthAndThreshold.y;
  if (share <= 0.0) return vec4(slackColour, 1.0);
  float x = min(share, 1.0);
  vec3 sum = vec3(0.0);
  for (int power = 6; power >= 0; --power) sum = sum * x + viridis[power];
  return vec4(mix(slackColour, clamp(sum, 0.0, 1.0), smoothstep(0.0, 0.02, share)), 1.0);
}

void main() {
  bond = uint(gl_InstanceID);
  vec3 a = positionOf(ends.x);
  vec3 b = positionOf(ends.y);
  bool broken = (flags & 1u) != 0u;
  bool glue = (flags & 4u) != 0u;
  world = (gl_VertexID & 1) == 0 ? a : b;
  colour = broken ? vec4(brokenColour, 0.5) : glueOnly ? vec4(glueColour, 1.0) : strainColour(distance(a, b));
  vec4 clipA = clipFromWorld * vec4(a, 1.0);
  vec4 clipB = clipFromWorld * vec4(b, 1.0);
  bool drawn = (flags & 2u) == 0u && (!broken || brokenToo) && (!glueOnly || glue) && clipA.w > 0.0 && clipB.w > 0.0;
  if (!drawn) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 along = (clipB.xy / clipB.w - clipA.xy / clipA.w) * pixels;
  float reach = length(along);
  vec2 across = reach > 1e-6 ? vec2(-along.y, along.x) / reach : vec2(0.0, 1.0);
  vec4 clip = (gl_VertexID & 1) == 0 ? clipA : clipB;
  float side = float(gl_VertexID >> 1) * 2.0 - 1.0;
  clip.xy += side * width * across / pixels * clip.w;
  gl_Position = clip;
}
