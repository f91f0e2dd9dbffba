#include "model/face_net.hpp"

namespace bodyline::model {
namespace {

Surface bezier_piece(const NetFace& face, int piece_u, int piece_v) {
  const SplineFace& spline = face.surface;
  Surface surface;
  surface.name = spline.name;
  surface.degree_u = spline.degree_u;
  surface.degree_v = spline.degree_v;
  surface.inward = face.inward;
  surface.net.reserve((spline.degree_u + 1) * (spline.degree_v + 1));
  for (int i = 0; i <= spline.degree_u; ++i)
    for (int j = 0; j <= spline.degree_v; ++j)
      surface.net.push_back(
          spline.point(piece_u * spline.degree_u + i, piece_v * spline.degree_v + j));
  return surface;
}

}  // namespace

std::vector<Surface> bezier_faces(const FaceNet& net) {
  std::vector<Surface> surfaces;
  for (const NetFace& face : net.faces) {
    const int pieces_u = static_cast<int>(face.surface.breaks_u.size()) - 1;
    const int pieces_v = static_cast<int>(face.surface.breaks_v.size()) - 1;
    for (int i = 0; i < pieces_u; ++i)
      for (int j = 0; j < pieces_v; ++j) surfaces.push_back(bezier_piece(face, i, j));
  }
  return surfaces;
}

}  // namespace bodyline::model
