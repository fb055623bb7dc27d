out vec4 result;

void main() {
  vec3 at = meetBall();
  vec3 n = (at - middle) / size;
  result = vec4(srgbFromLinear(shaded(at, n, colour.rgb, min(colour.a, 0.5))), 1.0);
}
