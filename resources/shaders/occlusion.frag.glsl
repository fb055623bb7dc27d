// How much of the sky each visible point sees past what is near it (after M. McGuire, B. Osman, M. Bukowski,
// P. Hennessy, "The alchemy screen-space ambient obscurance algorithm", 2011).
uniform sampler2D places;   // world; w = 0: nothing there
uniform sampler2D normals;  // world
uniform float radius;       // cm
uniform float pixelsAtOne;  // pixels of a centimetre at a centimetre's distance, or anywhere if orthographic

in vec2 at;
out vec4 result;

const int kLooks = 12;

void main() {
  ivec2 size = textureSize(places, 0);
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(places, here, 0);
  result = vec4(1.0);
  if (place.w == 0.0) return;
  vec3 normal = texelFetch(normals, here, 0).xyz;
  float depth = orthographic ? 1.0 : max(dot(place.xyz - eye, forward), 1e-3);
  float reach = min(radius * pixelsAtOne / depth, 0.25 * float(size.y));
  // Sixteen turns in blocks of four by four pixels, which the blur averages out.
  float turn = 6.2832 * float((here.x & 3) + 4 * (here.y & 3)) / 16.0;
  float sum = 0.0;
  for (int i = 0; i < kLooks; ++i) {
    float share = (float(i) + 0.5) / float(kLooks);
    float angle = turn + 6.2832 * 5.0 * share;
    ivec2 there = here + ivec2(reach * share * vec2(cos(angle), sin(angle)));
    vec4 other = texelFetch(places, clamp(there, ivec2(0), size - 1), 0);
    if (other.w == 0.0) continue;
    vec3 between = other.xyz - place.xyz;
    float squared = dot(between, between);
    float fall = max(radius * radius - squared, 0.0) / (radius * radius);
    sum += fall * max(dot(between, normal) * inversesqrt(squared + 1e-8) - 0.12, 0.0);
  }
  result = vec4(max(0.0, 1.0 - 2.1 * sum / float(kLooks)));
}
