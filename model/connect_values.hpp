#pragma once

#include "model/connect.hpp"

namespace bodyline::model {

/// First part of `connect`: names, counts and finiteness of every number, before anything is
/// joined.
void check_numbers(const Model& model);

/// Part of `connect`: cuts in order, only where a joint is, equal along seams; fullness and lean in
/// range.
void check_values(const Model& model, const Connectivity& links);

/// Part of `connect`: twice-counted volume integral of z n_z over the boundary nets, whose sign
/// tells inside from outside.
double signed_volume(const Model& model, const Connectivity& links);

}  // namespace bodyline::model
