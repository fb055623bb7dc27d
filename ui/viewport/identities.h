#pragma once

#include "ui/viewport/render_context.h"

/// Draws numbers that say what is seen, where it is and how it is turned, instead of colours: into the target
/// that is bound, whose first three textures take identities, places and normals.
namespace ui {

/// What stands in the first number of an identity; the second is the index of the thing. Uniforms are signed,
/// since Qt sets no others.
enum class Identity : GLuint { nothing, face, shard, node, bond, collider, level };

/// Colliders and the level surface.
void identifySolids(RenderContext& context, const PictureFrame& frame);
/// Faces of cells, and loose nodes' bodies.
void identifySurface(RenderContext& context, const PictureFrame& frame);
/// All that is drawn of bodies: the surface, bonds and nodes. Bonds are wider than they are drawn, so that a
/// hand can hit them, but no wider than `reach` logical pixels.
void identifyBodies(RenderContext& context, const PictureFrame& frame, double reach);

}  // namespace ui
