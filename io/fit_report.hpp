#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/body_section.hpp"
#include "io/render.hpp"
#include "io/surface_field.hpp"
#include "io/svg_section.hpp"
#include "io/write_file.hpp"
#include "model/model.hpp"
#include "model/scan.hpp"

namespace bodyline::io {

/// Distances of points from a body, mm, without sign.
struct ReportDistances {
  double median = 0.0, p90 = 0.0, p99 = 0.0, trimmed_rms = 0.0;
};

/// One line of the table of faces.
struct ReportFace {
  std::string name;
  std::size_t points = 0;
  double seen = 0.0;  ///< share of the face
  ReportDistances distances;
};

/// One round of a fit.
struct ReportRound {
  std::string phase;
  double distance = 0.0, seconds = 0.0;  ///< median, mm; since the start
};

/// An outline drawn in a view, beside the body's.
struct ReportOutline {
  std::string view;
  double median = 0.0, p90 = 0.0;       ///< mm, of the drawn points from the silhouette
  std::vector<Eigen::Vector2d> points;  ///< of the drawn outline in the view's picture, mm
  std::vector<double> distances;        ///< of each, positive outside of the body
  std::vector<std::vector<Eigen::Vector2d>> silhouette;  ///< of the body
};

/// A line that a curve of the body follows.
struct ReportLine {
  std::string curve;
  double median = 0.0, p90 = 0.0;  ///< mm
};

/// How well a body fits a scan or drawings, and how it came to. Plain data: the fit itself is known
/// to no one here.
struct FitReport {
  std::string title;
  std::string words;                  ///< what was read and found, sentences
  std::vector<std::string> warnings;  ///< what to look at first, sentences
  std::string status;                 ///< how the fit ended; empty without a fit
  std::string command;
  std::optional<model::Model> before;  ///< what the fit started from
  model::Model body;
  model::Stage stage = model::Stage::body;
  bool scan = true;    ///< without one there are no pose, field, distances, faces and points
  model::Pose pose;    ///< of the scan
  SurfaceField field;  ///< signed distances
  ReportDistances distances;
  std::vector<ReportFace> faces;
  std::vector<std::string> unseen_patches, folded_faces;
  std::vector<ReportRound> history;
  std::vector<MeasuredPoint> points;   ///< of the scan, mirrored to the left half
  std::vector<SectionPlane> sections;  ///< empty: the usual ones
  std::vector<ReportOutline> outlines;
  std::vector<ReportLine> lines;
  double seconds = 0.0;
};

/// Writes one self-contained HTML page: verdict, body to turn in the colours of its distances,
/// pictures of it, histogram, table of faces, sections with the scan, outlines beside those drawn,
/// pose, and with a fit the bodies before and after and how it converged. Throws as write_file and
/// render do.
void write_fit_report(const FitReport& report, const std::filesystem::path& path,
                      Overwrite overwrite = Overwrite::never);

/// Of the page that is written: eleven pictures, 4 MB.
inline constexpr PictureSize fit_report_pictures{960, 540};

/// The page, with pictures of a given size. The same report gives the same text.
std::string fit_report_page(const FitReport& report, const PictureSize& pictures);

}  // namespace bodyline::io
