// A floor with a grid in centimetres, both fading out.
uniform mat4 worldFromModel;
uniform float reach;
uniform vec2 about;
uniform vec4 floorColour;  // sRGB; alpha 0: no floor, the grid alone
uniform vec3 gridColour;
uniform vec3 gridStrongColour;
uniform vec3 axisXColour;
uniform vec3 axisYColour;
uniform float gridOpacity;
uniform float shadowStrength;
uniform bool axes;

in vec2 plane;
in vec3 world;
out vec4 result;

// Coverage of lines a step apart, a pixel wide, gone where they would run together.
float lines(vec2 at, vec2 footprint, float step_) {
  vec2 distance_ = abs(fract(at / step_ - 0.5) - 0.5) * step_;
  vec2 cover = 1.0 - smoothstep(vec2(0.3), vec2(1.1), distance_ / footprint);
  vec2 sparse = 1.0 - smoothstep(vec2(0.08), vec2(0.3), footprint / step_);
  return max(cover.x * sparse.x, cover.y * sparse.y);
}

vec4 over(vec4 above, vec4 below) {
  float alpha = above.a + below.a * (1.0 - above.a);
  vec3 colour = above.rgb * above.a + below.rgb * below.a * (1.0 - above.a);
  return vec4(alpha > 0.0 ? colour / alpha : vec3(0.0), alpha);
}

void main() {
  vec2 footprint = max(fwidth(plane), vec2(1e-6));
  float away = length(plane - about) / reach;
  float fade = 1.0 - smoothstep(0.15, 1.0, away);
  vec4 colour = vec4(floorColour.rgb, floorColour.a * fade);
  vec3 up = normalize(worldFromModel[2].xyz);
  float dark = shadowStrength * (1.0 - litShare(world, up) * openShare()) * fade;
  colour = over(vec4(0.0, 0.0, 0.0, dark), colour);
  colour = over(vec4(gridColour, gridOpacity * 0.35 * fade * lines(plane, footprint, 1.0)), colour);
  colour = over(vec4(gridStrongColour, gridOpacity * 0.55 * fade * lines(plane, footprint, 10.0)), colour);
  colour = over(vec4(gridStrongColour, gridOpacity * 0.8 * fade * lines(plane, footprint, 100.0)), colour);
  if (axes) {
    vec2 cover = 1.0 - smoothstep(vec2(0.5), vec2(1.4), abs(plane) / footprint);
    colour = over(vec4(axisYColour, 0.65 * fade * gridOpacity * cover.x), colour);
    colour = over(vec4(axisXColour, 0.65 * fade * gridOpacity * cover.y), colour);
  }
  result = colour;
}
