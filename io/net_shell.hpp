#pragma once

#include "io/export_shell.hpp"
#include "model/face_net.hpp"

/// For the STEP and IGES writers only: this header needs OpenCASCADE.
namespace bodyline::io {

/// The faces of a net as OpenCASCADE topology: every face one B-spline surface over [0,1]^2,
/// exactly (a Gregory face as make_shell for surfaces has it), its knots inside of one multiplicity
/// less where it is smooth; every edge of the net one edge, so that a side along which several
/// faces end has several. Throws std::runtime_error when OpenCASCADE finds the result invalid.
CadShell make_shell(const model::FaceNet& net);

}  // namespace bodyline::io
