#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/picture.hpp"
#include "io/render.hpp"
#include "model/surface.hpp"

/// Bodies to draw, and comparison of pictures.
namespace bodyline::test {

/// Expects a picture to look like the golden one. The picture is scaled down by four first; golden
/// pictures are kept at that size. `tolerance` bounds the root mean square difference (0 to 255) in
/// the worst square of 8 x 8 small pixels, so that a local change is not lost in a large picture.
/// On failure the picture is kept in the temporary folder and named. With
/// BODYLINE_UPDATE_PICTURES=1 in the environment the golden picture is written instead.
void expect_picture_matches(const io::Picture& picture, const std::filesystem::path& golden_path,
                            double tolerance);

/// The folder of the golden pictures.
std::filesystem::path golden_folder();

/// The root mean square difference in the worst square of `square` x `square` pixels of two
/// pictures of one size.
double worst_square_difference(const io::Picture& a, const io::Picture& b, int square);

/// A picture mirrored left to right.
io::Picture mirrored(const io::Picture& picture);

/// Six polynomial faces through a sphere that rests on z = 0, centred at x = y = 0; mm.
std::vector<model::Surface> sphere(double radius);

/// A flat square face on x = 0, edges of the given length in mm; its outside looks to the front.
model::Surface square(double length);

/// Both halves of a car of the repository at stage body.
std::vector<model::Surface> car(const std::string& name);

}  // namespace bodyline::test
