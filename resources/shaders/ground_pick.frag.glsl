uniform mat4 worldFromModel;
uniform int kind;
uniform int firstIndex;

in vec3 world;
layout(location = 0) out uvec4 identity;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 facing;

void main() {
  identity = uvec4(uint(kind), uint(firstIndex), 0u, 1u);
  place = vec4(world, 1.0);
  facing = vec4(normalize(worldFromModel[2].xyz), 0.0);
}
