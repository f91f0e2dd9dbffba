#include "model/check_face_net.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "model/check_edge_jet.hpp"
#include "model/face_pieces.hpp"

namespace bodyline::model {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

struct Use {
  int face = -1;
  Side side = Side::u0;
  NetSidePart part;
};

std::vector<std::vector<Use>> uses_by_edge(const FaceNet& net) {
  std::vector<std::vector<Use>> uses(net.edges.size());
  for (int f = 0; f < static_cast<int>(net.faces.size()); ++f)
    for (const Side side : all_sides)
      for (const NetSidePart& part : net.faces[f].sides[static_cast<int>(side)])
        uses[part.edge].push_back({f, side, part});
  return uses;
}

EdgeJet jet_at(const FacePieces& face, const Use& use, double t) {
  const double along = use.part.reversed ? 1.0 - t : t;
  const double at = use.part.from + along * (use.part.to - use.part.from);
  const bool along_v = use.side == Side::u0 || use.side == Side::u1;
  const PiecePlace place = piece_place(along_v ? face.breaks_v() : face.breaks_u(), at);
  const int last = along_v ? face.pieces_u() - 1 : face.pieces_v() - 1;
  const int row = use.side == Side::u1 || use.side == Side::v1 ? last : 0;
  return edge_jet(along_v ? face.piece(row, place.piece) : face.piece(place.piece, row), use.side,
                  place.at);
}

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return degrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

// The larger of two, and NaN when one is.
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

EdgeDeviation deviation(const FacePieces& a, const Use& use_a, const FacePieces& b,
                        const Use& use_b, int samples) {
  EdgeDeviation worst;
  for (int k = 0; k < samples; ++k) {
    const double t = (k + 0.5) / samples;
    const EdgeJet at_a = jet_at(a, use_a, t), at_b = jet_at(b, use_b, t);
    worst.gap_mm = larger((at_a.point - at_b.point).norm(), worst.gap_mm);
    const double angle = angle_deg(at_a.normal, at_b.normal);
    if (!(angle <= worst.normal_deviation_deg)) worst.worst_point = at_a.point;
    worst.normal_deviation_deg = larger(angle, worst.normal_deviation_deg);
    if (at_a.degenerate || at_b.degenerate) continue;
    worst.curvature_jump_per_mm = larger(std::abs(curvature_across(at_a) - curvature_across(at_b)),
                                         worst.curvature_jump_per_mm);
  }
  return worst;
}

void take_worse(EdgeDeviation& worst, const EdgeDeviation& other) {
  if (!(other.normal_deviation_deg <= worst.normal_deviation_deg))
    worst.worst_point = other.worst_point;
  worst.gap_mm = larger(other.gap_mm, worst.gap_mm);
  worst.normal_deviation_deg = larger(other.normal_deviation_deg, worst.normal_deviation_deg);
  worst.curvature_jump_per_mm = larger(other.curvature_jump_per_mm, worst.curvature_jump_per_mm);
}

/// Normals of a face on a grid within each piece, not of unit length, with their points.
struct Normals {
  std::vector<Eigen::Vector3d> normal, point;
};

Normals normals_of(const FacePieces& face, int cells) {
  Normals normals;
  for (const Surface& piece : face.all()) {
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const auto d = jet(piece, (i + 0.5) / cells, (j + 0.5) / cells, 1).d;
        normals.normal.push_back(d[1].cross(d[2]));
        normals.point.push_back(d[0]);
      }
    }
  }
  return normals;
}

NetFaceCheck check_face(const FacePieces& face, const FaceNetCheckOptions& options) {
  NetFaceCheck check;
  const Normals normals = normals_of(face, options.cells);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& normal : normals.normal) mean += normal;
  for (std::size_t k = 0; k < normals.normal.size(); ++k) {
    const double turn = normals.normal[k].norm() > 0.0 ? angle_deg(normals.normal[k], mean) : 0.0;
    if (turn <= check.max_turn_deg) continue;
    check.max_turn_deg = turn;
    check.point = normals.point[k];
  }
  if (!(mean.norm() > 0.0)) check.max_turn_deg = std::nan("");
  check.folded = !(check.max_turn_deg <= 90.0);
  for (const Surface& piece : face.all()) {
    const FaceIntegrals one = face_integrals(piece, options.nodes);
    check.integrals.area_mm2 += one.area_mm2;
    check.integrals.bending += one.bending;
    check.integrals.variation_per_mm2 += one.variation_per_mm2;
  }
  return check;
}

std::string text(const char* format, double value) {
  char result[64];
  std::snprintf(result, sizeof result, format, value);
  return result;
}

std::string place(const Eigen::Vector3d& p) {
  return "(" + text("%.0f, ", p.x()) + text("%.0f, ", p.y()) + text("%.0f) mm", p.z());
}

}  // namespace

FaceNetCheck check_face_net(const FaceNet& net, const FaceNetCheckOptions& options) {
  FaceNetCheck check;
  std::vector<FacePieces> pieces;
  for (const NetFace& face : net.faces) pieces.emplace_back(face);
  const auto uses = uses_by_edge(net);
  for (int e = 0; e < static_cast<int>(net.edges.size()); ++e) {
    for (const Use& use : uses[e]) {
      for (int k = 0; k < options.edge_samples; ++k) {
        const double t = (k + 0.5) / options.edge_samples;
        const double gap =
            (jet_at(pieces[use.face], use, t).point - curve_point(net.edges[e].curve, t)).norm();
        check.edge_gap_mm = larger(gap, check.edge_gap_mm);
      }
    }
    if (uses[e].size() != 2) continue;
    const Use &a = uses[e][0], &b = uses[e][1];
    check.edges.push_back(
        {e, a.face, b.face, deviation(pieces[a.face], a, pieces[b.face], b, options.edge_samples)});
    take_worse(check.worst, check.edges.back().deviation);
  }
  for (const FacePieces& face : pieces) {
    check.faces.push_back(check_face(face, options));
    const FaceIntegrals& one = check.faces.back().integrals;
    check.totals.area_mm2 += one.area_mm2;
    check.totals.bending += one.bending;
    check.totals.variation_per_mm2 += one.variation_per_mm2;
  }
  return check;
}

std::vector<std::string> face_net_findings(const FaceNet& net, const FaceNetCheck& check,
                                           double gap_mm, double normal_deg) {
  std::vector<std::string> findings;
  if (!(check.worst.gap_mm <= gap_mm))
    findings.push_back("faces are up to " + text("%.3g", check.worst.gap_mm) + " mm apart.");
  int kinks = 0;
  for (const NetEdgeCheck& edge : check.edges)
    if (!(edge.deviation.normal_deviation_deg <= normal_deg)) ++kinks;
  if (kinks > 0)
    findings.push_back("normals differ across " + std::to_string(kinks) + " of " +
                       std::to_string(check.edges.size()) + " edges, by up to " +
                       text("%.3g", check.worst.normal_deviation_deg) + " degrees at " +
                       place(check.worst.worst_point) + ".");
  for (std::size_t f = 0; f < check.faces.size(); ++f) {
    const NetFaceCheck& face = check.faces[f];
    if (!face.folded) continue;
    findings.push_back(net.faces[f].surface.name +
                       " folds over itself: its normals turn by up to " +
                       text("%.0f", face.max_turn_deg) + " degrees from their mean, most at " +
                       place(face.point) + ".");
  }
  return findings;
}

}  // namespace bodyline::model
