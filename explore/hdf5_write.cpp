#include "explore/hdf5_write.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

Hdf5Handle text_type(std::size_t length) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  hdf5_check(H5Tset_size(type, std::max<std::size_t>(1, length)));
  hdf5_check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  hdf5_check(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

Hdf5Handle scalar() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

Hdf5Handle line(hsize_t count) { return {H5Screate_simple(1, &count, nullptr), H5Sclose}; }

void write_attribute(hid_t at, const std::string& name, hid_t stored, hid_t type,
                     const void* data) {
  const Hdf5Handle attribute(
      H5Acreate2(at, name.c_str(), stored, scalar(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  hdf5_check(H5Awrite(attribute, type, data));
}

Hdf5Handle write_dataset(hid_t at, const std::string& name, hid_t space, hid_t stored, hid_t type,
                         const void* data) {
  Hdf5Handle dataset(
      H5Dcreate2(at, name.c_str(), stored, space, H5P_DEFAULT, timeless_dataset(), H5P_DEFAULT),
      H5Dclose);
  hdf5_check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  return dataset;
}

}  // namespace

Hdf5Handle timeless_dataset() {
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  hdf5_check(H5Pset_obj_track_times(properties, false));
  return properties;
}

void write_attribute(hid_t at, const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  write_attribute(at, name, type, type, text.c_str());
}

void write_attribute(hid_t at, const std::string& name, std::uint64_t number) {
  write_attribute(at, name, H5T_STD_U64LE, H5T_NATIVE_UINT64, &number);
}

Hdf5Handle write_text(hid_t at, const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  return write_dataset(at, name, scalar(), type, type, text.c_str());
}

Hdf5Handle write_texts(hid_t at, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string all(longest * texts.size(), '\0');
  for (std::size_t k = 0; k < texts.size(); ++k)
    all.replace(k * longest, texts[k].size(), texts[k]);
  const Hdf5Handle type = text_type(longest);
  return write_dataset(at, name, line(texts.size()), type, type, all.data());
}

Hdf5Handle write_numbers(hid_t at, const std::string& name, const std::vector<double>& numbers) {
  return write_dataset(at, name, line(numbers.size()), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                       numbers.data());
}

Hdf5Handle write_numbers(hid_t at, const std::string& name, const std::vector<int>& numbers) {
  return write_dataset(at, name, line(numbers.size()), H5T_STD_I32LE, H5T_NATIVE_INT,
                       numbers.data());
}

Hdf5Handle make_group(hid_t at, const std::string& name) {
  return {H5Gcreate2(at, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

}  // namespace bodyline::explore
