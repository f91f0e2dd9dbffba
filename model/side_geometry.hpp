#pragma once

#include "model/model.hpp"

/// Where a side's rows lie in a net of (m+1) x (n+1) points, v fastest.
namespace bodyline::model {

/// A walk along a side: point k of the row `depth` behind the side is at start + k * step + depth *
/// inward.
struct SideWalk {
  int start = 0, step = 0, inward = 0;
  int count = 0;   ///< points along the side
  int across = 0;  ///< degree across the side
};

inline SideWalk side_walk(Side side, int m, int n) {
  const int stride = n + 1;
  switch (side) {
    case Side::u0:
      return {0, 1, stride, n + 1, m};
    case Side::u1:
      return {m * stride, 1, -stride, n + 1, m};
    case Side::v0:
      return {0, stride, 1, m + 1, n};
    case Side::v1:
      return {n, stride, -1, m + 1, n};
  }
  return {};
}

/// The same walk from the side's other end.
inline SideWalk reversed(SideWalk walk) {
  walk.start += (walk.count - 1) * walk.step;
  walk.step = -walk.step;
  return walk;
}

/// Whether a side is an isoline of u (runs along v).
inline bool along_v(Side side) { return side == Side::u0 || side == Side::u1; }

/// Position of the patch corner in PatchLinks::vertices at which a side starts (end 0) or ends (end
/// 1).
inline int side_vertex(Side side, int end) {
  switch (side) {
    case Side::u0:
      return end;
    case Side::u1:
      return 2 + end;
    case Side::v0:
      return 2 * end;
    case Side::v1:
      return 1 + 2 * end;
  }
  return 0;
}

}  // namespace bodyline::model
