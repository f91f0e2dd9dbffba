#include "explore/store_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>

#include "explore/hdf5_read.hpp"
#include "explore/little_endian.hpp"
#include "explore/read_study.hpp"
#include "explore/variant_status.hpp"

namespace bodyline::explore {
namespace {

namespace fs = std::filesystem;

constexpr std::array<unsigned char, 8> signature{0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t superblock_bytes = 96, end_place = 40, version_place = 8;

// The tables of which every store has the first five.
constexpr std::array<const char*, 7> table_names{"variables", "metrics", "status",    "cause",
                                                 "seconds",   "nets",    "thumbnails"};
constexpr int most_tries = 1000;  // to open the file between two commits

std::vector<std::byte> read_bytes(const fs::path& path, std::uint64_t address, std::size_t count) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::byte> bytes(count, std::byte(0));
  stream.seekg(std::streamoff(address));
  stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(count));
  if (!stream) throw StoreError(path, "is damaged: it ends too early.");
  return bytes;
}

// What the library would say in a page of its own words, in a sentence.
void check_file(const fs::path& path) {
  std::error_code status;
  if (!fs::exists(path, status)) throw StoreError(path, "does not exist.");
  if (!fs::is_regular_file(path, status)) throw StoreError(path, "is no file.");
  const std::uint64_t size = fs::file_size(path, status);
  if (status) throw StoreError(path, "cannot be read.");
  const auto foreign = [&] { throw StoreError(path, "is no HDF5 file."); };
  if (size < signature.size()) foreign();
  const std::vector<std::byte> first = read_bytes(path, 0, signature.size());
  if (!std::equal(first.begin(), first.end(), signature.begin(),
                  [](std::byte a, unsigned char b) { return a == std::byte(b); }))
    foreign();
  if (size < superblock_bytes) throw StoreError(path, "is cut off after its first bytes.");
  const std::vector<std::byte> block = read_bytes(path, 0, superblock_bytes);
  if (block[version_place] != std::byte(0))
    throw StoreError(path, "is an HDF5 file, but no store of variants.");
  const std::uint64_t end = get_little_endian(block.data() + end_place, 8);
  // It may have grown since, and its end with it.
  if (const std::uint64_t now = fs::file_size(path, status); now < end) {
    throw StoreError(path, "is cut off: " + std::to_string(now) + " of " + std::to_string(end) +
                               " bytes are there.");
  }
}

std::uint64_t published_end(const fs::path& path) {
  return get_little_endian(read_bytes(path, end_place, 8).data(), 8);
}

Hdf5Handle memory_type(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return {H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose};
    case ElementType::float32:
      return {H5Tcopy(H5T_NATIVE_FLOAT), H5Tclose};
    case ElementType::uint16:
      return {H5Tcopy(H5T_NATIVE_UINT16), H5Tclose};
    case ElementType::uint8:
    case ElementType::status:
      break;
  }
  return {H5Tcopy(H5T_NATIVE_UINT8), H5Tclose};
}

// Whether elements have the class and the size of the layout's; read into memory they then fit.
bool has_type(const Hdf5Handle& dataset, ElementType wanted) {
  const Hdf5Handle stored(H5Dget_type(dataset), H5Tclose);
  const bool real = wanted == ElementType::float64 || wanted == ElementType::float32;
  const H5T_class_t kind = wanted == ElementType::status ? H5T_ENUM
                           : real                        ? H5T_FLOAT
                                                         : H5T_INTEGER;
  return H5Tget_class(stored) == kind && H5Tget_size(stored) == element_bytes(wanted);
}

std::vector<StudyInput> read_inputs(hid_t file) {
  const Hdf5Handle group(H5Gopen2(file, "inputs", H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  hdf5_check(H5Gget_info(group, &info));
  std::vector<StudyInput> inputs;
  for (hsize_t k = 0; k < info.nlinks; ++k) {
    const std::string number = std::to_string(k);
    StudyInput input{read_text_attribute(open_dataset(group, number), "name"),
                     read_text(group, number)};
    // A text may end in zeros, which the padding hides.
    input.text.resize(read_number_attribute(open_dataset(group, number), "bytes"), '\0');
    inputs.push_back(std::move(input));
  }
  return inputs;
}

std::vector<MeasuredFile> read_files(hid_t file) {
  if (H5Lexists(file, "files", H5P_DEFAULT) <= 0) return {};
  const std::vector<std::string> names = read_texts(file, "files/name");
  const std::vector<std::string> sizes = read_texts(file, "files/bytes");
  const std::vector<std::string> digests = read_texts(file, "files/digest");
  if (sizes.size() != names.size() || digests.size() != names.size())
    throw std::runtime_error("its list of files is damaged");
  std::vector<MeasuredFile> files;
  for (std::size_t k = 0; k < names.size(); ++k) {
    MeasuredFile& measured = files.emplace_back();
    measured.name = names[k];
    measured.digest = digests[k];
    std::from_chars(sizes[k].data(), sizes[k].data() + sizes[k].size(), measured.bytes);
  }
  return files;
}

Study study_of(const std::vector<StudyInput>& inputs) {
  if (inputs.empty()) throw std::runtime_error("it holds no study");
  return read_study_text(inputs.front().text, inputs.front().name, [&](const std::string& name) {
    for (const StudyInput& input : inputs) {
      if (input.name == name) return input.text;
    }
    throw std::runtime_error("it does not hold \"" + name + "\"");
  });
}

}  // namespace

struct StoreReader::State {
  explicit State(const fs::path& at);
  void open();
  bool open_between_commits();
  void read_header();
  const Hdf5Handle& table_of(const std::string& name) const;
  void read_table(const TableLayout& table, VariantRows& rows) const;

  fs::path path;
  Hdf5Quiet quiet;
  std::optional<Hdf5Handle> file;
  std::map<std::string, Hdf5Handle> tables;  // kept open, or they would grow behind the end
  StoreHeader header;
  std::optional<Study> study;
  std::optional<DesignSpace> space;
  std::optional<StoreLayout> layout;
};

StoreReader::State::State(const fs::path& at) : path(at) {
  open();
  read_header();
}

// The library learns the end of the file when it opens it, and where a table has its index when it
// opens the table. A commit in between puts the index behind that end.
void StoreReader::State::open() {
  for (int k = 0; k < most_tries; ++k) {
    check_file(path);
    if (open_between_commits()) return;
  }
  throw StoreError(path, "cannot be opened: it is written on all the time.");
}

bool StoreReader::State::open_between_commits() {
  const std::uint64_t end = published_end(path);
  tables.clear();
  file.reset();
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) {
    if (published_end(path) != end) return false;
    throw StoreError(path, "cannot be opened: it is damaged, or locked by others.");
  }
  file.emplace(id, H5Fclose);
  try {
    if (read_text_attribute(*file, "program") != "bodyline") throw std::runtime_error("");
  } catch (const std::runtime_error&) {
    throw StoreError(path, "is an HDF5 file, but no store of variants.");
  }
  try {
    header.rows = read_number(*file, "committed_rows");  // before the tables, which have no fewer
    for (const char* name : table_names) {
      if (H5Lexists(*file, name, H5P_DEFAULT) > 0) tables.emplace(name, open_dataset(*file, name));
    }
  } catch (const std::runtime_error& error) {
    if (published_end(path) != end) return false;
    throw StoreError(path, std::string("cannot be used: ") + error.what() + ".");
  }
  return published_end(path) == end;
}

const Hdf5Handle& StoreReader::State::table_of(const std::string& name) const {
  const auto found = tables.find(name);
  if (found == tables.end()) throw std::runtime_error("it has no dataset " + name);
  return found->second;
}

void StoreReader::State::read_header() {
  try {
    if (const auto schema = read_number_attribute(*file, "schema"); schema != store_schema) {
      throw std::runtime_error("it has schema " + std::to_string(schema) +
                               ", and this program knows schema " + std::to_string(store_schema));
    }
    header.version = read_text_attribute(*file, "version");
    header.planned = read_number_attribute(*file, "planned_rows");
    header.merged = H5Aexists(*file, "merged") > 0;
    header.inputs = read_inputs(*file);
    header.files = read_files(*file);
    header.causes = read_texts(*file, "columns/causes");
    study = study_of(header.inputs);
    study->files = header.files;
    space.emplace(*study);
    layout.emplace(*study, *space);
    for (const TableLayout& table : layout->tables) {
      if (!has_type(table_of(table.name), table.type))
        throw std::runtime_error("the dataset " + table.name + " has other numbers");
      std::vector<std::uint64_t> shape = shape_of(table_of(table.name));
      if (shape.empty() || shape.front() < header.rows ||
          !std::equal(shape.begin() + 1, shape.end(), table.row.begin(), table.row.end()))
        throw std::runtime_error("the dataset " + table.name + " has not the shape of its study");
    }
  } catch (const StoreError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw StoreError(path, std::string("cannot be used: ") + error.what() + ".");
  }
}

void StoreReader::State::read_table(const TableLayout& table, VariantRows& rows) const {
  const Hdf5Handle& dataset = table_of(table.name);
  const Hdf5Handle selected(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> start(table.row.size() + 1, 0), count{hsize_t(rows.count)};
  start.front() = rows.first;
  count.insert(count.end(), table.row.begin(), table.row.end());
  hdf5_check(
      H5Sselect_hyperslab(selected, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  const Hdf5Handle memory(H5Screate_simple(int(count.size()), count.data(), nullptr), H5Sclose);
  const Hdf5Handle stored(H5Dget_type(dataset), H5Tclose);
  // The names of a status are of no use in memory.
  const Hdf5Handle type = table.type == ElementType::status ? Hdf5Handle(H5Tcopy(stored), H5Tclose)
                                                            : memory_type(table.type);
  hdf5_check(H5Dread(dataset, type, memory, selected, H5P_DEFAULT, table_data(rows, table.name)));
}

StoreReader::StoreReader(const fs::path& path) : state_(std::make_unique<State>(path)) {}
StoreReader::~StoreReader() = default;
StoreReader::StoreReader(StoreReader&&) noexcept = default;

const fs::path& StoreReader::path() const { return state_->path; }
const StoreHeader& StoreReader::header() const { return state_->header; }
const Study& StoreReader::study() const { return *state_->study; }
const DesignSpace& StoreReader::space() const { return *state_->space; }
const StoreLayout& StoreReader::layout() const { return *state_->layout; }

VariantRows StoreReader::read(std::uint64_t first, int count, bool pictures) const {
  if (count < 0 || first > rows() || std::uint64_t(count) > rows() - first)
    throw StoreError(path(), "has no such rows.");
  VariantRows rows = make_rows(layout(), first, count);
  try {
    for (const TableLayout& table : layout().tables) {
      const bool picture = table.name == "nets" || table.name == "thumbnails";
      if (count > 0 && (pictures || !picture)) state_->read_table(table, rows);
    }
  } catch (const std::runtime_error&) {
    throw StoreError(path(), "is damaged: rows " + std::to_string(first) + " to " +
                                 std::to_string(first + std::uint64_t(count) - 1) +
                                 " cannot be read.");
  }
  const auto unknown = [&](int row) {
    return rows.status[row] >= status_count || rows.cause[row] >= header().causes.size();
  };
  for (int row = 0; row < count; ++row) {
    if (unknown(row)) throw StoreError(path(), "is damaged: a variant has an unknown status.");
  }
  if (pictures) return rows;
  rows.nets.clear();
  rows.thumbnails.clear();
  return rows;
}

StoreReader::Places StoreReader::places() const {
  try {
    const Hdf5Handle counter = open_dataset(*state_->file, "committed_rows");
    Places places;
    places.counter = H5Dget_offset(counter);
    if (places.counter == HADDR_UNDEF) throw std::runtime_error("its counter has no place");
    for (const TableLayout& table : layout().tables) {
      H5O_info_t info;
      hdf5_check(H5Oget_info(state_->table_of(table.name), &info));
      places.tables.push_back(
          dataset_places(info.addr, [&](std::uint64_t address, std::size_t bytes) {
            return read_bytes(path(), address, bytes);
          }));
    }
    return places;
  } catch (const StoreError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw StoreError(path(), std::string("cannot be written on: ") + error.what() + ".");
  }
}

}  // namespace bodyline::explore
