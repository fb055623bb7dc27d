uniform int kind;

flat in uint bond;
in vec3 world;
layout(location = 0) out uvec4 identity;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 facing;

void main() {
  identity = uvec4(uint(kind), bond, 0u, 1u);
  place = vec4(world, 1.0);
  facing = vec4(-forward, 0.0);
}
