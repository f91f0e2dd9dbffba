#include "explore/rank_messages.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "explore/little_endian.hpp"
#include "explore/measured_files.hpp"
#include "explore/read_study.hpp"
#include "model/kernels.hpp"

namespace bodyline::explore {
namespace {

void put_number(Bytes& bytes, std::uint64_t number) {
  const std::size_t at = bytes.size();
  bytes.resize(at + 8);
  put_little_endian(bytes.data() + at, number, 8);
}

void put_text(Bytes& bytes, const std::string& text) {
  put_number(bytes, text.size());
  const auto* const first = reinterpret_cast<const std::byte*>(text.data());
  bytes.insert(bytes.end(), first, first + text.size());
}

// Takes apart what the functions above put together.
class Taker {
 public:
  explicit Taker(const Bytes& bytes) : bytes_(bytes) {}

  const std::byte* take(std::size_t count) {
    if (count > bytes_.size() - at_) throw std::runtime_error("another rank sent half a message");
    at_ += count;
    return bytes_.data() + at_ - count;
  }
  std::uint64_t number() { return get_little_endian(take(8), 8); }
  std::string text() {
    const std::size_t size = number();
    return {reinterpret_cast<const char*>(take(size)), size};
  }
  RankWord word() { return RankWord(*take(1)); }

 private:
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

const char* isa_name() {
  switch (model::best_isa()) {
    case model::Isa::baseline:
      return "baseline";
    case model::Isa::avx2:
      return "avx2";
    case model::Isa::avx512:
      return "avx512";
  }
  return "";
}

void check_alike(const char* what, const std::string& theirs, const std::string& ours,
                 const std::string& remedy) {
  if (theirs == ours) return;
  throw std::runtime_error(std::string("rank 0 has ") + what + " " + theirs +
                           ", another rank has " + ours + ", and their rows would differ; " +
                           remedy);
}

void check_same_files(const std::vector<MeasuredFile>& theirs,
                      const std::vector<MeasuredFile>& ours) {
  for (const MeasuredFile& file : theirs) {
    if (std::find(ours.begin(), ours.end(), file) != ours.end()) continue;
    throw std::runtime_error("the file \"" + file.name +
                             "\" is not the same on another rank as on rank 0; all need it at the "
                             "same path");
  }
}

}  // namespace

RankWord word_of(const Bytes& message) { return Taker(message).word(); }

Bytes note_message(const RankNote& note) {
  Bytes bytes{std::byte(note.word)};
  put_number(bytes, note.first);
  put_number(bytes, std::uint64_t(note.number));
  put_text(bytes, note.sentence);
  return bytes;
}

RankNote read_note(const Bytes& message) {
  Taker taker(message);
  RankNote note;
  note.word = taker.word();
  note.first = taker.number();
  note.number = int(taker.number());
  note.sentence = taker.text();
  return note;
}

Bytes rows_message(const StoreLayout& layout, const VariantRows& rows) {
  Bytes bytes{std::byte(RankWord::rows)};
  put_number(bytes, rows.first);
  put_number(bytes, std::uint64_t(rows.count));
  for (const TableLayout& table : layout.tables) {
    const std::byte* const data = table_data(rows, table.name);
    bytes.insert(bytes.end(), data, data + std::size_t(rows.count) * table.row_bytes());
  }
  return bytes;
}

std::shared_ptr<VariantRows> read_rows(const StoreLayout& layout, const Bytes& message) {
  Taker taker(message);
  taker.word();
  const std::uint64_t first = taker.number();
  const auto rows = std::make_shared<VariantRows>(make_rows(layout, first, int(taker.number())));
  for (const TableLayout& table : layout.tables) {
    const std::size_t size = std::size_t(rows->count) * table.row_bytes();
    std::memcpy(table_data(*rows, table.name), taker.take(size), size);
  }
  return rows;
}

Bytes study_message(const Study& study) {
  Bytes bytes;
  put_text(bytes, BODYLINE_VERSION);
  put_text(bytes, isa_name());
  put_text(bytes, std::filesystem::absolute(study.folder / study.inputs.front().name).string());
  put_number(bytes, study.inputs.size());
  for (const StudyInput& input : study.inputs) {
    put_text(bytes, input.name);
    put_text(bytes, input.text);
  }
  put_number(bytes, study.files.size());
  for (const MeasuredFile& file : study.files) {
    put_text(bytes, file.name);
    put_number(bytes, file.bytes);
    put_text(bytes, file.digest);
  }
  return bytes;
}

Study read_study_message(const Bytes& message) {
  Taker taker(message);
  check_alike("version", taker.text(), BODYLINE_VERSION, "install the same program on all nodes");
  const std::string isa = taker.text();
  check_alike("the instruction set", isa, isa_name(),
              "set BODYLINE_ISA to the smaller one for all ranks");
  const std::filesystem::path path = taker.text();
  std::vector<StudyInput> inputs(taker.number());
  for (StudyInput& input : inputs) {
    input.name = taker.text();
    input.text = taker.text();
  }
  std::vector<MeasuredFile> files(taker.number());
  for (MeasuredFile& file : files) {
    file.name = taker.text();
    file.bytes = taker.number();
    file.digest = taker.text();
  }
  Study study = read_study_text(inputs.front().text, path, [&](const std::string& name) {
    const auto found = std::find_if(inputs.begin() + 1, inputs.end(),
                                    [&](const StudyInput& input) { return input.name == name; });
    if (found == inputs.end()) throw std::runtime_error("rank 0 did not send " + name);
    return found->text;
  });
  study.files = measured_files(study);
  check_same_files(files, study.files);
  return study;
}

}  // namespace bodyline::explore
