#include "io/read_drawing_png.hpp"

#include <png.h>

#include <stdexcept>
#include <vector>

#include "io/drawing_text.hpp"
#include "io/input_error.hpp"
#include "io/mask.hpp"
#include "io/trace_mask.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t most_pixels = std::size_t{1} << 26;

/// libpng's picture, freed whatever happens.
struct PngPicture {
  png_image image{};
  PngPicture() { image.version = PNG_IMAGE_VERSION; }
  PngPicture(const PngPicture&) = delete;
  PngPicture& operator=(const PngPicture&) = delete;
  ~PngPicture() { png_image_free(&image); }
};

Mask read_mask(const std::string& content) {
  PngPicture picture;
  png_image& image = picture.image;
  const auto refuse = [&image] {
    throw std::invalid_argument(std::string("cannot be read as PNG: ") + image.message);
  };
  if (!png_image_begin_read_from_memory(&image, content.data(), content.size())) refuse();
  const std::size_t count = std::size_t(image.width) * image.height;
  if (count > most_pixels) throw std::invalid_argument("has over 67 million pixels");
  image.format = PNG_FORMAT_GA;
  std::vector<png_byte> pairs(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, pairs.data(), 0, nullptr)) refuse();
  std::vector<std::uint8_t> grey(count), opacity(count);
  for (std::size_t k = 0; k < count; ++k) {
    grey[k] = pairs[2 * k];
    opacity[k] = pairs[2 * k + 1];
  }
  return mask_of(int(image.width), int(image.height), grey, opacity);
}

}  // namespace

model::Drawing read_drawing_png(const std::filesystem::path& path) {
  const std::string content = drawing_text(path);
  try {
    model::Drawing drawing;
    drawing.paths = trace_mask(read_mask(content));
    drawing.y_down = true;
    return drawing;
  } catch (const std::invalid_argument& error) {
    throw InputError(path.string(), 0, "", std::string(error.what()) + ".");
  }
}

}  // namespace bodyline::io
