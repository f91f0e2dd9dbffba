#include "explore/browse_page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "explore/browse_bodies.hpp"
#include "explore/browse_description.hpp"
#include "explore/store_layout.hpp"
#include "io/palette.hpp"
#include "io/picture.hpp"
#include "io/report_html.hpp"
#include "web/assets.hpp"

namespace bodyline::explore {
namespace {

// A page may load nothing; the browser sees to it.
constexpr const char* head_begin =
    "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
    "script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\"/>\n"
    "<link rel=\"icon\" href=\"data:,\"/>\n";

template <class Value>
std::string block(const std::string& name, const std::vector<Value>& values) {
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(values.data()),
                                            values.size() * sizeof(Value));
  return "<script type=\"application/octet-stream\" id=\"" + name + "\">" + io::base64(bytes) +
         "</script>\n";
}

std::string numbers(const BrowseRows& rows) {
  const std::vector<double> ids(rows.ids.begin(), rows.ids.end());
  std::string html = block("ids", ids) + block("status", rows.status) + block("cause", rows.cause);
  for (std::size_t k = 0; k < rows.columns.size(); ++k)
    html += block("column-" + std::to_string(k), rows.columns[k]);
  return html + block("pareto", rows.pareto);
}

// Colours as RGB bytes, from the least value to the largest.
std::vector<std::uint8_t> color_steps(double least, io::Color (*color_of)(double)) {
  constexpr int steps = 64;
  std::vector<std::uint8_t> bytes;
  for (int k = 0; k < steps; ++k) {
    const io::Color color = color_of(least + (1.0 - least) * k / (steps - 1));
    for (int c = 0; c < 3; ++c)
      bytes.push_back(std::uint8_t(std::lround(255.0f * io::srgb_from_linear(color[c]))));
  }
  return bytes;
}

// PNG files of the store's thumbnails.
std::string pictures(const StoreReader& store, const BrowseRows& shown,
                     const std::vector<int>& rows) {
  nlohmann::ordered_json images = nlohmann::ordered_json::object();
  const std::vector<std::uint64_t> shape = thumbnail_shape(store.study().keep.thumbnail_width);
  for (const int row : rows) {
    const VariantRows one = store.read(shown.ids[row], 1, true);
    images[std::to_string(row)] =
        io::base64(io::png_bytes({int(shape[1]), int(shape[0]), one.thumbnails}));
  }
  return "<script type=\"application/json\" id=\"pictures\">" + images.dump() + "</script>\n";
}

}  // namespace

std::string browse_page(const StoreReader& store, const BrowseOptions& options,
                        BrowseSummary& summary) {
  if (store.rows() == 0) throw StoreError(store.path(), "holds no variants yet.");
  const std::vector<StoreObjective> objectives =
      browse_objectives(store, options.minimize, options.maximize);
  const BrowseRows rows = browse_rows(store, objectives, options.limit);
  const bool has_pictures = store.study().keep.thumbnail_width > 0;
  std::vector<int> spread =
      spread_rows(rows, store.space().column_count(),
                  std::max(options.bodies, has_pictures ? options.pictures : 0));
  std::vector<int> pictured = spread;
  pictured.resize(has_pictures ? std::min(spread.size(), std::size_t(options.pictures)) : 0);
  spread.resize(std::min(spread.size(), std::size_t(options.bodies)));
  const BrowseBodies bodies = browse_bodies(store, rows, std::move(spread));
  summary = {store.rows(), rows.count(), int(rows.pareto.size()), int(bodies.rows.size()),
             int(pictured.size())};

  std::string html = head_begin;
  html += "<title>" + io::html_escaped(store.study().name) + " – Bodyline</title>\n<style>\n";
  html += web::browse_style_sheet();
  html +=
      "</style>\n</head>\n<body>\n<div id=\"page\"><noscript>This page needs JavaScript to show "
      "the variants.</noscript></div>\n";
  html += "<script type=\"application/json\" id=\"description\">" +
          browse_description(store, objectives, rows, bodies) + "</script>\n";
  html += numbers(rows);
  html += block("body-rows", bodies.rows) + block("body-points", bodies.points_mm);
  html += block("map-colours", color_steps(-1.0, io::diverging_color));
  html += block("scale-colours", color_steps(0.0, io::sequential_color));
  if (has_pictures) html += pictures(store, rows, pictured);
  html += "<script>\n";
  html += web::browse_script();
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace bodyline::explore
