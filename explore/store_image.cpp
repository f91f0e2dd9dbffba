#include "explore/store_image.hpp"

#include <hdf5_hl.h>

#include "explore/hdf5_write.hpp"
#include "explore/optimizer_kind.hpp"
#include "explore/sampler_kind.hpp"
#include "explore/variant_plan.hpp"
#include "explore/variant_status.hpp"

namespace bodyline::explore {
namespace {

constexpr unsigned compression_level = 1;

Hdf5Handle stored_type(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return {H5Tcopy(H5T_IEEE_F64LE), H5Tclose};
    case ElementType::float32:
      return {H5Tcopy(H5T_IEEE_F32LE), H5Tclose};
    case ElementType::uint16:
      return {H5Tcopy(H5T_STD_U16LE), H5Tclose};
    case ElementType::uint8:
      return {H5Tcopy(H5T_STD_U8LE), H5Tclose};
    case ElementType::status:
      break;
  }
  Hdf5Handle names(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
  for (std::uint8_t k = 0; k < status_count; ++k)
    hdf5_check(H5Tenum_insert(names, status_name(VariantStatus(k)), &k));
  return names;
}

Hdf5Handle make_table(hid_t file, const TableLayout& table, bool compressed) {
  std::vector<hsize_t> now{0}, most{H5S_UNLIMITED}, chunk{hsize_t(table.chunk_rows)};
  for (const std::uint64_t extent : table.row) {
    now.push_back(extent);
    most.push_back(extent);
    chunk.push_back(extent);
  }
  const Hdf5Handle space(H5Screate_simple(int(now.size()), now.data(), most.data()), H5Sclose);
  const Hdf5Handle properties = timeless_dataset();
  hdf5_check(H5Pset_chunk(properties, int(chunk.size()), chunk.data()));
  if (compressed) {
    hdf5_check(H5Pset_shuffle(properties));
    hdf5_check(H5Pset_deflate(properties, compression_level));
  }
  return {H5Dcreate2(file, table.name.c_str(), stored_type(table.type), space, H5P_DEFAULT,
                     properties, H5P_DEFAULT),
          H5Dclose};
}

// Makes an array the scale of a table's columns.
void attach(const Hdf5Handle& table, const Hdf5Handle& scale, const char* name) {
  hdf5_check(H5DSset_scale(scale, name));
  hdf5_check(H5DSattach_scale(table, scale, 1));
}

void describe_variables(hid_t columns, const DesignSpace& space, const Hdf5Handle& table) {
  std::vector<std::string> names, units, kinds;
  std::vector<double> lower, upper, start;
  for (const Column& column : space.columns()) {
    names.push_back(column.name);
    units.push_back(column.unit);
    kinds.emplace_back(column_kind_name(column.kind));
    lower.push_back(column.lower);
    upper.push_back(column.upper);
    start.push_back(column.start);
  }
  const Hdf5Handle group = make_group(columns, "variables");
  attach(table, write_texts(group, "name", names), "name");
  attach(table, write_texts(group, "unit", units), "unit");
  attach(table, write_texts(group, "kind", kinds), "kind");
  attach(table, write_numbers(group, "lower", lower), "lower");
  attach(table, write_numbers(group, "upper", upper), "upper");
  attach(table, write_numbers(group, "start", start), "start");
}

void describe_metrics(hid_t columns, const Study& study, const Hdf5Handle& table) {
  std::vector<std::string> names, units, kinds;
  std::vector<double> least, most;
  for (const MetricSpec& metric : study.metrics) {
    names.push_back(metric.name);
    units.push_back(metric_unit(metric.kind));
    kinds.push_back(metric_name(metric.kind));
    least.push_back(Constraint{}.least);
    most.push_back(Constraint{}.most);
    for (const Constraint& constraint : study.constraints) {
      if (constraint.metric != metric.name) continue;
      least.back() = constraint.least;
      most.back() = constraint.most;
    }
  }
  const Hdf5Handle group = make_group(columns, "metrics");
  attach(table, write_texts(group, "name", names), "name");
  attach(table, write_texts(group, "unit", units), "unit");
  attach(table, write_texts(group, "kind", kinds), "kind");
  attach(table, write_numbers(group, "least", least), "least");
  attach(table, write_numbers(group, "most", most), "most");
}

// Where each face of the closed body has its net in a row of /nets.
void describe_faces(hid_t file, const DesignSpace& space) {
  std::vector<std::string> names;
  std::vector<int> net, degree_u, degree_v, blend, central, inward;
  for (const model::Face& face : space.context()->plan.body_faces) {
    names.push_back(face.name);
    net.push_back(face.net);
    degree_u.push_back(face.degree_u);
    degree_v.push_back(face.degree_v);
    blend.push_back(face.blend);
    central.push_back(face.central ? 1 : 0);
    inward.push_back(face.inward ? 1 : 0);
  }
  const Hdf5Handle group = make_group(file, "faces");
  write_texts(group, "name", names);
  write_numbers(group, "net", net);
  write_numbers(group, "degree_u", degree_u);
  write_numbers(group, "degree_v", degree_v);
  write_numbers(group, "blend", blend);
  write_numbers(group, "central", central);
  write_numbers(group, "inward", inward);
}

void write_inputs(hid_t file, const Study& study) {
  const Hdf5Handle group = make_group(file, "inputs");
  for (std::size_t k = 0; k < study.inputs.size(); ++k) {
    const Hdf5Handle text = write_text(group, std::to_string(k), study.inputs[k].text);
    write_attribute(text, "name", study.inputs[k].name);
    write_attribute(text, "bytes", study.inputs[k].text.size());
  }
}

// What the metrics measure against, which is too large to be kept.
void write_files(hid_t file, const Study& study) {
  std::vector<std::string> names, sizes, digests;
  for (const MeasuredFile& measured : study.files) {
    names.push_back(measured.name);
    sizes.push_back(std::to_string(measured.bytes));
    digests.push_back(measured.digest);
  }
  const Hdf5Handle group = make_group(file, "files");
  write_texts(group, "name", names);
  write_texts(group, "bytes", sizes);
  write_texts(group, "digest", digests);
}

// The number of committed rows: one number at a fixed place, from the beginning.
void make_counter(hid_t file) {
  const Hdf5Handle properties = timeless_dataset();
  hdf5_check(H5Pset_layout(properties, H5D_CONTIGUOUS));
  hdf5_check(H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY));
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle counter(H5Dcreate2(file, "committed_rows", H5T_STD_U64LE, space, H5P_DEFAULT,
                                      properties, H5P_DEFAULT),
                           H5Dclose);
  const std::uint64_t none = 0;
  hdf5_check(H5Dwrite(counter, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &none));
}

void fill(hid_t file, const Study& study, const DesignSpace& space, std::uint64_t planned,
          bool merged) {
  write_attribute(file, "program", "bodyline");
  write_attribute(file, "version", BODYLINE_VERSION);
  write_attribute(file, "schema", store_schema);
  write_attribute(file, "study", study.name);
  if (study.optimizer)
    write_attribute(file, "optimizer", optimizer_name(study.optimizer->kind));
  else
    write_attribute(file, "sampler", sampler_name(study.sampler.kind));
  write_attribute(file, "seed", study.sampler.seed);
  write_attribute(file, "planned_rows", planned);
  if (merged) write_attribute(file, "merged", 1);
  make_counter(file);
  const StoreLayout layout(study, space);
  const Hdf5Handle columns = make_group(file, "columns");
  for (const TableLayout& layout_of : layout.tables) {
    const Hdf5Handle table = make_table(file, layout_of, layout.compressed);
    if (layout_of.name == "variables") describe_variables(columns, space, table);
    if (layout_of.name == "metrics") describe_metrics(columns, study, table);
    if (layout_of.name == "nets") describe_faces(file, space);
  }
  write_texts(columns, "causes", cause_names(study, space));
  write_inputs(file, study);
  if (!study.files.empty()) write_files(file, study);
}

}  // namespace

std::vector<std::byte> empty_store(const Study& study, const DesignSpace& space,
                                   std::uint64_t planned, bool merged) {
  const Hdf5Quiet quiet;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t increment = 1 << 16;
  hdf5_check(H5Pset_fapl_core(access, increment, false));
  // Oldest formats: no checksums, so that single numbers can be replaced.
  hdf5_check(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
  // No number that is replaced may lie in two sectors of a disk.
  constexpr hsize_t sector = 512;
  hdf5_check(H5Pset_alignment(access, 1, sector));
  const Hdf5Handle file(H5Fcreate("empty store", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  fill(file, study, space, planned, merged);
  hdf5_check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size <= 0) throw std::runtime_error("the HDF5 library makes no image of a file");
  std::vector<std::byte> image(std::size_t(size), std::byte(0));
  if (H5Fget_file_image(file, image.data(), image.size()) != size)
    throw std::runtime_error("the HDF5 library makes no image of a file");
  return image;
}

}  // namespace bodyline::explore
