#include "model/face_net.hpp"

#include "model/face_pieces.hpp"

namespace bodyline::model {

std::vector<Surface> bezier_faces(const FaceNet& net) {
  std::vector<Surface> surfaces;
  for (const NetFace& face : net.faces) {
    const FacePieces pieces(face);
    surfaces.insert(surfaces.end(), pieces.all().begin(), pieces.all().end());
  }
  return surfaces;
}

}  // namespace bodyline::model
