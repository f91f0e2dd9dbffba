#pragma once

#include <vector>

#include "io/mesh.hpp"
#include "model/face_net.hpp"
#include "model/face_pieces.hpp"

/// How finely the mesh of a net is cut.
namespace bodyline::io {

/// Chords of each piece of an edge, and cells of each row of pieces of a face.
struct Fineness {
  std::vector<std::vector<int>> edge;            // by edge and piece
  std::vector<std::vector<int>> face_u, face_v;  // by face and row of pieces
};

/// A first guess from how edges and faces bend and turn.
Fineness first_fineness(const model::FaceNet& net, const std::vector<model::FacePieces>& pieces,
                        const MeshOptions& options);

/// Makes what deviates by more than the tolerance finer, and the edges around it.
void refine(const model::FaceNet& net, const std::vector<double>& deviations, double tolerance,
            Fineness& fineness);

long triangle_count(const Fineness& fineness);

/// The parameters that cut every piece between breaks into its number of equal parts: 0 to 1.
std::vector<double> cut_lines(const std::vector<double>& breaks, const std::vector<int>& counts);

}  // namespace bodyline::io
