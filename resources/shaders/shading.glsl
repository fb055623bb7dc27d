// Light and reflection, for everything that is lit.
uniform vec3 lightDirection;  // unit, towards the key light
uniform mat4 shadowFromWorld;
uniform sampler2DShadow shadowMap;
uniform float shadowRadius;  // of the penumbra, in the map's coordinates
uniform float shadowOffset;  // cm
uniform bool shadows;
uniform sampler2D occlusion;  // share of the sky that is seen, in half as many pixels
uniform bool occludes;
uniform vec3 skyLight;
uniform vec3 groundLight;

const vec2 kDisc[16] = vec2[](
    vec2(-0.942, -0.399), vec2(0.946, -0.769), vec2(-0.094, -0.929), vec2(0.345, 0.294), vec2(-0.916, 0.458),
    vec2(-0.815, -0.879), vec2(-0.383, 0.277), vec2(0.975, 0.756), vec2(0.443, -0.975), vec2(0.537, -0.474),
    vec2(-0.265, -0.418), vec2(0.792, 0.191), vec2(-0.242, 0.997), vec2(-0.814, 0.914), vec2(0.199, 0.786),
    vec2(0.144, -0.141));

// The share of the key light that arrives. Turned from pixel to pixel, sixteen looks at the map make a smooth
// penumbra.
float litShare(vec3 world, vec3 normal) {
  if (!shadows) return 1.0;
  // Looked up a little off the surface, or it would shade itself where it slopes.
  vec3 at = (shadowFromWorld * vec4(world + shadowOffset * normal, 1.0)).xyz;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
  float bias = 0.0012;
  float angle = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  float sum = 0.0;
  for (int i = 0; i < 16; ++i)
    sum += texture(shadowMap, vec3(at.xy + shadowRadius * (turn * kDisc[i]), at.z - bias));
  return sum / 16.0;
}

float openShare() {
  if (!occludes) return 1.0;
  vec2 texel = 1.0 / vec2(textureSize(occlusion, 0));
  vec2 at = 0.5 * gl_FragCoord.xy * texel;
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += texture(occlusion, at + texel * (vec2(i & 1, i >> 1) * 2.0 - 1.0)).r;
  return 0.25 * sum;
}

vec3 linearFromSrgb(vec3 colour) { return pow(colour, vec3(2.2)); }

// Straight up to 0.7, then bent so that bright glaze keeps its shape.
vec3 srgbFromLinear(vec3 light) {
  vec3 bent = mix(light, 0.7 + 0.3 * tanh((light - 0.7) / 0.3), step(0.7, light));
  return pow(bent, vec3(1.0 / 2.2));
}

// What a mirror shows of the studio: a floor, a backdrop brighter above, a long soft box over the key side
// and a narrow one opposite.
vec3 studio(vec3 direction, float blur) {
  vec3 backdrop = mix(groundLight, skyLight, smoothstep(-0.25 - blur, 0.6 + blur, direction.z));
  vec3 side = normalize(cross(lightDirection, vec3(0.0, 0.0, 1.0)));
  vec3 above = cross(side, lightDirection);
  float ahead = dot(direction, lightDirection);
  vec2 box = abs(vec2(dot(direction, side), dot(direction, above)) / max(ahead, 0.05));
  float edge = 0.04 + 0.5 * blur;
  float key = (1.0 - smoothstep(0.42 - edge, 0.42 + edge, box.x)) *
              (1.0 - smoothstep(0.30 - edge, 0.30 + edge, box.y)) * step(0.05, ahead);
  vec2 strip = abs(vec2(dot(direction, side) - 0.1, dot(direction, above) + 0.2) / max(-ahead, 0.05));
  float rim = (1.0 - smoothstep(0.16 - edge, 0.16 + edge, strip.x)) *
              (1.0 - smoothstep(0.9 - edge, 0.9 + edge, strip.y)) * step(0.05, -ahead);
  return backdrop + vec3(9.0, 8.7, 8.2) * key + vec3(2.4, 2.5, 2.8) * rim;
}

vec3 shaded(vec3 world, vec3 normal, vec3 colour, float glaze) {
  vec3 albedo = linearFromSrgb(colour);
  vec3 view = towardsEye(world);
  float facing = clamp(dot(normal, view), 0.0, 1.0);
  float lit = litShare(world, normal);
  float key = max(dot(normal, lightDirection), 0.0) * lit;
  float open = openShare();
  vec3 ambient = open * mix(groundLight, skyLight, 0.5 + 0.5 * normal.z);
  vec3 diffuse = albedo * (0.74 * ambient + vec3(0.80, 0.775, 0.73) * key + 0.12 * facing);
  if (glaze <= 0.0) return diffuse;
  float fresnel = glaze * (0.05 + 0.95 * pow(1.0 - facing, 5.0));
  vec3 mirrored = studio(reflect(-view, normal), 0.35 * (1.0 - glaze));
  // A shadow takes the lamp out of a mirror, not the backdrop: half is near enough.
  return diffuse * (1.0 - fresnel) + fresnel * mirrored * (0.5 + 0.5 * lit) * open;
}
