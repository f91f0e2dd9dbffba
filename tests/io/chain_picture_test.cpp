#include "io/chain_picture.hpp"

#include <gtest/gtest.h>

#include "io/chain_file.hpp"

namespace bodyline {
namespace {

TEST(ChainPicture, CombsHaveTeethOnEveryCurve) {
  const auto chain = std::get<model::CurveChain>(
      io::read_chain(BODYLINE_SOURCE_DIR "/examples/headlight.toml").chain);
  io::ChainDrawing drawing;
  const std::string plain = io::chain_svg(chain, drawing);
  drawing.comb_mm = 10.0;
  const std::string combed = io::chain_svg(chain, drawing);
  const auto polylines = [](const std::string& svg) {
    int count = 0;
    for (std::size_t at = svg.find("<polyline"); at != svg.npos; at = svg.find("<polyline", at + 1))
      ++count;
    return count;
  };
  constexpr int per_curve = 25 + 1;  // teeth, and the line through their tips
  EXPECT_EQ(polylines(combed) - polylines(plain), 8 * per_curve);
}

}  // namespace
}  // namespace bodyline
