// A line around what the mask shows.
uniform sampler2D mask;
uniform vec3 colour;
uniform float width;  // pixels

in vec2 at;
out vec4 result;

void main() {
  vec2 pixel = 1.0 / vec2(textureSize(mask, 0));
  float inside = texture(mask, at).r;
  float sum = 0.0;
  for (int i = 0; i < 16; ++i) {
    float angle = 0.3927 * float(i);
    sum += texture(mask, at + width * pixel * vec2(cos(angle), sin(angle))).r;
  }
  result = vec4(colour, (1.0 - inside) * min(1.0, sum / 4.0));
}
