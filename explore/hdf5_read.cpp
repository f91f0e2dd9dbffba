#include "explore/hdf5_read.hpp"

namespace bodyline::explore {
namespace {

constexpr std::size_t largest_text = std::size_t(1) << 30;

// Texts of a fixed length, without the padding.
std::vector<std::string> split(const std::string& all, std::size_t length) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < all.size(); at += length) {
    std::string text = all.substr(at, length);
    text.resize(text.find_last_not_of('\0') + 1);
    texts.push_back(std::move(text));
  }
  return texts;
}

std::size_t text_length(hid_t type) {
  const std::size_t length = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || length == 0 ||
      length > largest_text)
    throw std::runtime_error("a text of a fixed length is missing");
  return length;
}

std::string trimmed(std::string text) {
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

}  // namespace

std::string read_text_attribute(hid_t at, const std::string& name) {
  const Hdf5Handle attribute(H5Aopen(at, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  std::string text(text_length(type), '\0');
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw std::runtime_error("an attribute is no single text");
  hdf5_check(H5Aread(attribute, type, text.data()));
  return trimmed(text);
}

std::uint64_t read_number_attribute(hid_t at, const std::string& name) {
  const Hdf5Handle attribute(H5Aopen(at, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw std::runtime_error("an attribute is no single number");
  std::uint64_t number = 0;
  hdf5_check(H5Aread(attribute, H5T_NATIVE_UINT64, &number));
  return number;
}

Hdf5Handle open_dataset(hid_t at, const std::string& name) {
  return {H5Dopen2(at, name.c_str(), H5P_DEFAULT), H5Dclose};
}

std::vector<std::uint64_t> shape_of(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0) throw std::runtime_error("a dataset has no shape");
  std::vector<hsize_t> shape(std::size_t(rank), 0);
  hdf5_check(H5Sget_simple_extent_dims(space, shape.data(), nullptr));
  return {shape.begin(), shape.end()};
}

std::vector<std::string> read_texts(hid_t at, const std::string& name) {
  const Hdf5Handle dataset = open_dataset(at, name);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const std::size_t length = text_length(type);
  std::size_t count = 1;
  for (const std::uint64_t extent : shape_of(dataset)) count *= extent;
  if (count > largest_text / length) throw std::runtime_error("a list of texts is too long");
  std::string all(length * count, '\0');
  hdf5_check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()));
  return split(all, length);
}

std::string read_text(hid_t at, const std::string& name) {
  std::vector<std::string> texts = read_texts(at, name);
  if (texts.size() != 1) throw std::runtime_error("a dataset is no single text");
  return texts.front();
}

std::uint64_t read_number(hid_t at, const std::string& name) {
  const Hdf5Handle dataset = open_dataset(at, name);
  if (!shape_of(dataset).empty()) throw std::runtime_error("a dataset is no single number");
  std::uint64_t number = 0;
  hdf5_check(H5Dread(dataset, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &number));
  return number;
}

}  // namespace bodyline::explore
