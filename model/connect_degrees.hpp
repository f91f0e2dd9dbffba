#pragma once

#include "model/connect.hpp"

namespace bodyline::model {

/// Part of `connect`: the degrees of the patches' nets. Each family needs its own; along a seam the
/// lower one of two patches is raised to the other's, since its second row is corrected there.
void set_net_degrees(const Model& model, Connectivity& links);

}  // namespace bodyline::model
