uniform int kind;

layout(location = 0) out uvec4 identity;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 facing;

void main() {
  vec3 at = meetBall();
  identity = uvec4(uint(kind), ball, 0u, 1u);
  place = vec4(at, 1.0);
  facing = vec4((at - middle) / size, 0.0);
}
