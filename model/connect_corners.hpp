#pragma once

#include "model/connect.hpp"

namespace bodyline::model {

/// Part of `connect`: finds the joints that end at each named corner and lays out its corner
/// patch's edges; checks that the ring closes and that every end of a cut joint has a corner or is
/// free.
void connect_corners(const Model& model, Connectivity& links);

/// Last part of `connect`: on which side of each corner patch the outside is.
void orient_corners(const Model& model, Connectivity& links);

/// Whether S_u x S_v of a joint's transition points into the body.
bool transition_inward(const Model& model, const Connectivity& links, int joint);

}  // namespace bodyline::model
