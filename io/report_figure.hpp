#pragma once

#include <string>
#include <vector>

#include "io/render.hpp"
#include "model/surface.hpp"

/// Figures with pictures of a body; those of a section of class "gallery" are shown one at a time.
namespace bodyline::io {

/// What a figure shows. Plain text, used as markup.
struct ReportFigure {
  std::string label, caption;
};

/// One body.
std::string report_figure(const ReportFigure& figure, const std::vector<model::Surface>& faces,
                          const RenderOptions& options);

/// Two bodies under a slider.
std::string report_comparison(const ReportFigure& figure, const std::vector<model::Surface>& before,
                              const std::vector<model::Surface>& after,
                              const RenderOptions& options);

/// Options of a picture in a report.
RenderOptions report_picture_options(const char* view, Map map, const PictureSize& size);

}  // namespace bodyline::io
