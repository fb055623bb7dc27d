uniform vec3 top;
uniform vec3 bottom;

in vec2 at;
out vec4 result;

void main() {
  // Noise of one step of a byte: no bands.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  result = vec4(mix(bottom, top, smoothstep(0.0, 1.0, at.y)) + noise / 255.0, 1.0);
}
