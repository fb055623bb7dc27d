uniform int kind;
uniform int firstIndex;
uniform int primitivesEach;  // triangles that belong to one index; 0: all of them

in vec3 world;
in vec3 normal;
layout(location = 0) out uvec4 identity;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 facing;

void main() {
  int index = primitivesEach == 0 ? firstIndex : firstIndex + gl_PrimitiveID / primitivesEach;
  identity = uvec4(uint(kind), uint(index), 0u, 1u);
  place = vec4(world, 1.0);
  facing = vec4(gl_FrontFacing ? normal : -normal, 0.0);
}
