#include <png.h>

#include <cmath>
#include <functional>

#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;

/// Grey and opacity of a pixel.
using Paint = std::function<std::array<png_byte, 2>(int x, int y)>;

class PngDrawing : public testing::DrawingFiles {
 protected:
  std::string png(int width, int height, const Paint& paint) const {
    std::vector<png_byte> pixels;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (const png_byte value : paint(x, y)) pixels.push_back(value);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = PNG_FORMAT_GA;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr);
    std::string bytes(size, '\0');
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
    bytes.resize(size);
    return bytes;
  }
  model::Drawing read_png(int width, int height, const Paint& paint) const {
    return read("a.png", png(width, height, paint));
  }
  std::string refused_png(int width, int height, const Paint& paint) const {
    return refusal("a.png", png(width, height, paint));
  }
};

bool in_disc(int x, int y) { return std::hypot(x + 0.5 - 60.0, y + 0.5 - 40.0) < 25.0; }

void expect_disc(const model::Drawing& drawing) {
  ASSERT_EQ(drawing.paths.size(), 1U);
  EXPECT_TRUE(drawing.paths[0].closed);
  EXPECT_EQ(drawing.paths[0].name, "outline");
  EXPECT_TRUE(drawing.y_down);
  for (const Vector2d& point : model::sample_path(drawing.paths[0], 1.0)) {
    // A traced border lies within the pixels that it parts.
    EXPECT_NEAR((point - Vector2d(60.0, -40.0)).norm(), 25.0, 0.75);
  }
}

TEST_F(PngDrawing, TracesADarkShapeOnLightGround) {
  expect_disc(read_png(120, 80, [](int x, int y) {
    return std::array<png_byte, 2>{png_byte(in_disc(x, y) ? 40 : 240), 255};
  }));
}

TEST_F(PngDrawing, TracesALightShapeOnDarkGround) {
  expect_disc(read_png(120, 80, [](int x, int y) {
    return std::array<png_byte, 2>{png_byte(in_disc(x, y) ? 240 : 40), 255};
  }));
}

TEST_F(PngDrawing, TracesWhatIsOpaqueWhateverItsColour) {
  expect_disc(read_png(120, 80, [](int x, int y) {
    return std::array<png_byte, 2>{png_byte(x), png_byte(in_disc(x, y) ? 255 : 0)};
  }));
}

TEST_F(PngDrawing, NamesHolesAndPutsTheLargestFirst) {
  const auto drawing = read_png(120, 80, [](int x, int y) {
    const bool ring = in_disc(x, y) && std::hypot(x - 60.0, y - 40.0) > 10.0;
    return std::array<png_byte, 2>{png_byte(ring || (x < 10 && y > 60 && y < 70) ? 0 : 255), 255};
  });
  ASSERT_EQ(drawing.paths.size(), 3U);
  EXPECT_EQ(drawing.paths[0].name, "outline");
  EXPECT_EQ(drawing.paths[1].name, "hole");
  EXPECT_EQ(drawing.paths[2].name, "outline");
}

TEST_F(PngDrawing, KeepsStraightEdgesAndCorners) {
  const auto drawing = read_png(100, 60, [](int x, int y) {
    return std::array<png_byte, 2>{png_byte(x >= 20 && x < 70 && y >= 10 && y < 45 ? 0 : 255), 255};
  });
  const Eigen::AlignedBox2d box = model::drawn_box(drawing.paths);
  EXPECT_EQ(box.min(), Vector2d(20, -45));
  EXPECT_EQ(box.max(), Vector2d(70, -10));
}

TEST_F(PngDrawing, RefusesWhatShowsNoShape) {
  const auto plain = [](png_byte grey, png_byte opacity) {
    return [=](int, int) { return std::array<png_byte, 2>{grey, opacity}; };
  };
  EXPECT_EQ(refused_png(50, 40, plain(255, 255)),
            " is of one colour: no shape stands out from its ground.");
  EXPECT_EQ(refused_png(50, 40, plain(0, 0)), " is empty: no shape stands out from its ground.");
  EXPECT_EQ(refused_png(200, 200,
                        [](int x, int y) {
                          return std::array<png_byte, 2>{0, png_byte(x < 2 * (y == 0) ? 255 : 0)};
                        }),
            " is empty: no shape stands out from its ground.");
  EXPECT_EQ(refused_png(1000, 40,
                        [](int x, int y) {
                          return std::array<png_byte, 2>{png_byte((x + y) % 2 == 0 ? 0 : 255), 255};
                        }),
            " is no mask of a shape: a row of it changes between shape and ground over 200 times.");
}

TEST_F(PngDrawing, RefusesDamagedFiles) {
  const std::string whole = png(50, 40, [](int x, int) {
    return std::array<png_byte, 2>{png_byte(x < 20 ? 0 : 255), 255};
  });
  EXPECT_THAT(refusal("a.png", "no picture"), ::testing::StartsWith(" cannot be read as PNG: "));
  // The last chunk of 12 bytes says only that it is the last.
  for (std::size_t length = 1; length < whole.size() - 12; length += 7)
    EXPECT_THAT(refusal("a.png", whole.substr(0, length)),
                ::testing::StartsWith(" cannot be read as PNG: "))
        << length;
  // Whatever byte is changed, it is either read or refused.
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = char(damaged[at] ^ 0x55);
    refusal("a.png", damaged);
  }
}

TEST_F(PngDrawing, RefusesMoreThanItCanHold) {
  std::string huge = png(50, 40, [](int x, int) {
    return std::array<png_byte, 2>{png_byte(x < 20 ? 0 : 255), 255};
  });
  // Width and height of the head, whose checksum libpng looks at first: it stands at byte 29.
  huge.replace(16, 8, std::string("\x00\x0f\x42\x40\x00\x0f\x42\x40", 8));
  EXPECT_FALSE(refusal("a.png", huge).empty());
}

}  // namespace
}  // namespace bodyline
