#pragma once

#include <memory>

#include "strokes/net_edit.hpp"

namespace bodyline::strokes {

/// The paper's patch: the Coons patch of a patch's sides as they are (section 2.2). Side 0 becomes
/// t = 0; of a triangle the corner opposite side 0 becomes the point t = 1.
std::shared_ptr<const PatchShape> coons_shape(const Net& net, const Patch& patch);

/// Turns the sides of a triangle so that its last corner, which becomes the point of its shape, is
/// the one with the smallest angle in the domain.
void turn_to_apex(const Net& net, Patch& patch);

/// The side of a patch (in the order of Patch::sides) on which t = 0, s = 1, t = 1 or s = 0 lies;
/// -1 for the point of a triangle.
int patch_side(const Patch& patch, int shape_side);

/// Patches whose sides changed in an edit.
std::set<int> touched_patches(const NetEdit& edit);

}  // namespace bodyline::strokes
