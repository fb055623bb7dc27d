uniform float opacity;  // seen straight on; grazing surfaces are denser

in vec3 world;
in vec3 normal;
in vec4 colour;
out vec4 result;

void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 light = shaded(world, n, colour.rgb, colour.a);
  float grazing = 1.0 - abs(dot(n, towardsEye(world)));
  result = vec4(srgbFromLinear(light), mix(opacity, 1.0, opacity < 1.0 ? 0.6 * pow(grazing, 3.0) : 0.0));
}
