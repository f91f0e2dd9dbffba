#pragma once

#include <string>
#include <vector>

#include "model/family_curve.hpp"
#include "model/join_measure.hpp"

namespace bodyline::model {

/// Curves of any families, each joined to the one before it; a closed chain also the first to the
/// last.
struct CurveChain {
  std::string name;
  std::vector<FamilyCurve> curves;
  std::vector<CurveJoin> joins;  ///< joins[k] between curves k and k + 1; one fewer than curves, as
                                 ///< many when closed
  bool closed() const { return !curves.empty() && joins.size() == curves.size(); }
};

/// Writes the points that the joins determine, curve after curve, so that every join holds exactly;
/// the last join of a closed chain writes the last two points of the last curve. Throws
/// std::invalid_argument when the counts do not fit, when a closing join asks for more than G1 or
/// leaves its curve too few points, and as join_curve.
void propagate(CurveChain& chain);

/// How well curve k + 1 goes on from curve k, the first from the last in a closed chain.
JoinMeasure measure_join(const CurveChain& chain, int join);

}  // namespace bodyline::model
