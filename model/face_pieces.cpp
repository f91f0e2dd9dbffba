#include "model/face_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::model {
namespace {

Surface bezier_piece(const NetFace& face, int piece_u, int piece_v) {
  const SplineFace& spline = face.surface;
  Surface surface;
  surface.name = spline.name;
  surface.degree_u = spline.degree_u;
  surface.degree_v = spline.degree_v;
  surface.inward = face.inward;
  surface.blend = spline.blend;
  surface.net.reserve((spline.degree_u + 1) * (spline.degree_v + 1));
  for (int i = 0; i <= spline.degree_u; ++i)
    for (int j = 0; j <= spline.degree_v; ++j)
      surface.net.push_back(
          spline.point(piece_u * spline.degree_u + i, piece_v * spline.degree_v + j));
  return surface;
}

}  // namespace

PiecePlace piece_place(const std::vector<double>& breaks, double t) {
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
  const int piece = static_cast<int>(after - breaks.begin()) - 1;
  const double length = breaks[piece + 1] - breaks[piece];
  return {piece, std::clamp((t - breaks[piece]) / length, 0.0, 1.0), length};
}

FacePieces::FacePieces(const NetFace& face)
    : breaks_u_(face.surface.breaks_u), breaks_v_(face.surface.breaks_v) {
  for (int i = 0; i < pieces_u(); ++i)
    for (int j = 0; j < pieces_v(); ++j) pieces_.push_back(bezier_piece(face, i, j));
}

SurfaceJet FacePieces::jet(double u, double v, int order) const {
  const PiecePlace in_u = piece_place(breaks_u_, u), in_v = piece_place(breaks_v_, v);
  SurfaceJet result = model::jet(piece(in_u.piece, in_v.piece), in_u.at, in_v.at, order);
  for (int a = 0; a <= order; ++a)
    for (int b = 0; a + b <= order; ++b)
      result.d[jet_index(a, b)] /= std::pow(in_u.length, a) * std::pow(in_v.length, b);
  return result;
}

Eigen::Vector3d FacePieces::outward_normal(double u, double v) const {
  const PiecePlace in_u = piece_place(breaks_u_, u), in_v = piece_place(breaks_v_, v);
  return model::outward_normal(piece(in_u.piece, in_v.piece), in_u.at, in_v.at);
}

}  // namespace bodyline::model
