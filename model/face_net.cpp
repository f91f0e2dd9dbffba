#include "model/face_net.hpp"

#include "model/face_pieces.hpp"

namespace bodyline::model {

std::array<int, 2> side_corners(Side side) {
  switch (side) {
    case Side::u0:
      return {0, 3};
    case Side::u1:
      return {1, 2};
    case Side::v0:
      return {0, 1};
    default:
      return {3, 2};
  }
}
std::vector<Surface> bezier_faces(const FaceNet& net) {
  std::vector<Surface> surfaces;
  for (const NetFace& face : net.faces) {
    const FacePieces pieces(face);
    surfaces.insert(surfaces.end(), pieces.all().begin(), pieces.all().end());
  }
  return surfaces;
}

}  // namespace bodyline::model
