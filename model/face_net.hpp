#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/spline_curve.hpp"
#include "model/surface.hpp"

/// Faces that meet edge to edge, also where a side of one is several edges of others.
namespace bodyline::model {

/// A face over [0,1]^2 of Bezier pieces on a grid.
struct SplineFace {
  std::string name;
  int degree_u = 0, degree_v = 0;
  std::vector<double> breaks_u, breaks_v;  ///< 0 to 1, increasing
  /// (pieces in u x degree_u + 1) x (pieces in v x degree_v + 1) points, v fastest; mm
  std::vector<Eigen::Vector3d> net;
  std::optional<Eigen::Vector3d> blend = {};  ///< of a Gregory face of one piece (Surface::blend)

  int count_u() const { return (static_cast<int>(breaks_u.size()) - 1) * degree_u + 1; }
  int count_v() const { return (static_cast<int>(breaks_v.size()) - 1) * degree_v + 1; }
  const Eigen::Vector3d& point(int i, int j) const { return net[i * count_v() + j]; }
};

/// Positions of the two ends of a side among the corners of a face (u, v) = (0,0), (1,0), (1,1),
/// (0,1), in the direction of its running parameter.
std::array<int, 2> side_corners(Side side);

/// A curve that one face has as (part of) a side, or two share.
struct NetEdge {
  SplineCurve curve;
  int start = -1, end = -1;  ///< vertices
};

/// An edge as a part of a side, seen in the direction of the side's running parameter.
struct NetSidePart {
  int edge = -1;
  bool reversed = false;
  double from = 0.0, to = 1.0;  ///< of the side's running parameter
};

struct NetFace {
  SplineFace surface;
  std::array<std::vector<NetSidePart>, 4> sides;  ///< by Side; empty where a side is one point
  std::array<int, 4> corners{-1, -1, -1, -1};     ///< vertices at (0,0), (1,0), (1,1), (0,1)
  bool inward = false;                            ///< S_u x S_v points into the body
};

struct FaceNet {
  std::string name;
  std::vector<Eigen::Vector3d> vertices;  ///< mm
  std::vector<NetEdge> edges;
  std::vector<NetFace> faces;
};

/// The Bezier pieces of all faces, each with the name of its face.
std::vector<Surface> bezier_faces(const FaceNet& net);

}  // namespace bodyline::model
