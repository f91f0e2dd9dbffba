#include "strokes/carrier_edge.hpp"

#include <functional>

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::CurveJet;
using model::SplineCurve;

constexpr int most_halvings = 6;
// A field across counts for its patches with the blending functions of derivatives: 4/27 at most.
constexpr double field_share = 4.0 / 27.0;
constexpr double inner[] = {0.25, 0.5, 0.75};  // of a piece, where it is tested

/// What a carrier has along a line.
struct LineOnCarrier {
  const Carrier& carrier;
  Vector2d from, along;

  Vector2d aside() const { return {-along.y(), along.x()}; }
  static Vector3d second(const PatchJet& jet, const Vector2d& a, const Vector2d& b) {
    return a.x() * b.x() * jet.ss + (a.x() * b.y() + a.y() * b.x()) * jet.st +
           a.y() * b.y() * jet.tt;
  }
  CurveJet curve(double t) const {
    const PatchJet jet = carrier.jet(from + t * along);
    return {jet.point, along.x() * jet.s + along.y() * jet.t, second(jet, along, along)};
  }
  CurveJet across(double t) const {
    const PatchJet jet = carrier.jet(from + t * along);
    const Vector2d turned = aside();
    return {turned.x() * jet.s + turned.y() * jet.t, second(jet, along, turned), Vector3d::Zero()};
  }
};

CurveJet scaled(CurveJet jet, double length) {
  jet.first *= length;
  jet.second *= length * length;
  return jet;
}

using JetOnLine = std::function<CurveJet(double)>;
using Piece = SplineCurve (*)(const CurveJet&, const CurveJet&);

bool follows(const SplineCurve& piece, const JetOnLine& jet, double from, double length,
             double tolerance_mm) {
  for (const double part : inner)
    if ((model::curve_point(piece, part) - jet(from + part * length).point).norm() > tolerance_mm)
      return false;
  return true;
}

// Halves pieces until they follow; the breaks that it begins with stay.
std::vector<double> refined_breaks(std::vector<double> breaks, const JetOnLine& jet,
                                   Piece make_piece, double tolerance_mm) {
  for (int halving = 0; halving < most_halvings; ++halving) {
    std::vector<double> finer{breaks.front()};
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double from = breaks[k], length = breaks[k + 1] - from;
      const SplineCurve piece =
          make_piece(scaled(jet(from), length), scaled(jet(breaks[k + 1]), length));
      if (!follows(piece, jet, from, length, tolerance_mm)) finer.push_back(from + 0.5 * length);
      finer.push_back(breaks[k + 1]);
    }
    if (finer.size() == breaks.size()) break;
    breaks = std::move(finer);
  }
  return breaks;
}

SplineCurve interpolant(const std::vector<double>& breaks, const JetOnLine& jet, Piece make_piece) {
  SplineCurve curve;
  curve.breaks = breaks;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double length = breaks[k + 1] - breaks[k];
    const SplineCurve piece =
        make_piece(scaled(jet(breaks[k]), length), scaled(jet(breaks[k + 1]), length));
    curve.degree = piece.degree;
    curve.points.insert(curve.points.end(), piece.points.begin() + (k == 0 ? 0 : 1),
                        piece.points.end());
  }
  return curve;
}

}  // namespace

CarrierEdge carrier_edge(const Carrier& carrier, const Vector2d& a, const Vector2d& b,
                         double tolerance_mm) {
  const LineOnCarrier line{carrier, a, b - a};
  const JetOnLine curve = [&line](double t) { return line.curve(t); };
  const JetOnLine across = [&line](double t) { return line.across(t); };
  std::vector<double> breaks = refined_breaks({0.0, 1.0}, curve, model::quintic, tolerance_mm);
  breaks = refined_breaks(std::move(breaks), across, model::cubic, tolerance_mm / field_share);
  return {interpolant(breaks, curve, model::quintic), interpolant(breaks, across, model::cubic)};
}

CarrierEdge carrier_edge(const Carrier& carrier, const Vector2d& a, const Vector2d& b,
                         const SplineCurve& curve, double tolerance_mm) {
  const LineOnCarrier line{carrier, a, b - a};
  const JetOnLine across = [&line](double t) { return line.across(t); };
  const auto breaks =
      refined_breaks(curve.breaks, across, model::cubic, tolerance_mm / field_share);
  return {curve, interpolant(breaks, across, model::cubic)};
}

}  // namespace bodyline::strokes
