// Surface and shards, whose corners are at nodes, and everything that has corners of its own.
layout(location = 0) in uint node;
layout(location = 1) in vec4 packedNormal;
layout(location = 2) in vec4 colourAndGlaze;
layout(location = 3) in vec3 offset;

uniform bool atNodes;
uniform mat4 worldFromModel;

out vec3 world;
out vec3 normal;
out vec4 colour;

void main() {
  world = atNodes ? positionOf(node) + offset : (worldFromModel * vec4(offset, 1.0)).xyz;
  normal = atNodes ? packedNormal.xyz : mat3(worldFromModel) * packedNormal.xyz;
  colour = colourAndGlaze;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
