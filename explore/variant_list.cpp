#include "explore/variant_list.hpp"

#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include "io/input_error.hpp"
#include "io/model_file_names.hpp"
#include "model/number_text.hpp"

namespace bodyline::explore {
namespace {

constexpr double weight_rounding = 1e-9;
constexpr int ignored = -1;
const std::set<std::string> other_columns{"id", "status", "cause",
                                          "img"};  // of a table of variants

std::vector<std::string> cells_of(std::string line) {
  if (line.ends_with('\r')) line.pop_back();
  std::vector<std::string> cells;
  std::string cell;
  for (std::istringstream stream(line); std::getline(stream, cell, ',');) {
    const std::size_t begin = cell.find_first_not_of(" \t\""), end = cell.find_last_not_of(" \t\"");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  if (line.ends_with(',')) cells.emplace_back();
  return cells;
}

// Reads the lines of one file; the members are what its messages need.
class ListReader {
 public:
  ListReader(const std::string& name, const DesignSpace& space)
      : name_(name), columns_(space.columns()), start_(space.start_values()) {}

  void read_header(const std::string& line) {
    std::vector<std::string> known;
    for (const Column& column : columns_) known.push_back(column.name);
    for (std::string cell : cells_of(line)) {
      if (cell.starts_with("out:") || other_columns.count(cell) > 0) {
        places_.push_back(ignored);
        continue;
      }
      if (cell.starts_with("in:")) cell = cell.substr(3);
      const auto found = std::find(known.begin(), known.end(), cell);
      if (found == known.end()) {
        fail(1, "has a column " + io::in_quotes(cell) + ", which is no variable of the study" +
                    io::suggestion(cell, known) + ".");
      }
      places_.push_back(int(found - known.begin()));
    }
  }

  void read_row(const std::string& line, int number, std::vector<double>& rows) const {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != places_.size()) {
      fail(number, "has " + std::to_string(cells.size()) + " values, but the first line names " +
                       std::to_string(places_.size()) + " columns.");
    }
    std::vector<double> row = start_;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (places_[k] != ignored)
        row[places_[k]] = read_value(cells[k], columns_[places_[k]], number);
    }
    check_weights(row, number);
    rows.insert(rows.end(), row.begin(), row.end());
  }

  [[noreturn]] void fail(int line, const std::string& sentence) const {
    throw io::InputError(name_, line, "", sentence);
  }

 private:
  double read_value(const std::string& cell, const Column& column, int line) const {
    double value = 0.0;
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) {
      fail(line,
           "the value " + io::in_quotes(cell) + " of " + column.name + " is not a finite number.");
    }
    if (value < column.lower || value > column.upper) {
      fail(line, column.name + " is " + cell + "; the study lets it be from " +
                     model::number_text(column.lower) + " to " + model::number_text(column.upper) +
                     ".");
    }
    if (column.kind == ColumnKind::choice && value != std::floor(value))
      fail(line, column.name + " is " + cell + "; it must be a whole number.");
    return value;
  }

  void check_weights(const std::vector<double>& row, int line) const {
    double sum = 0.0;
    bool any = false;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (columns_[k].kind != ColumnKind::weight) continue;
      any = true;
      sum += row[k];
    }
    if (any && std::abs(sum - 1.0) > weight_rounding)
      fail(line, "the weights add up to " + model::number_text(sum) + " instead of 1.");
  }

  std::string name_;
  const std::vector<Column>& columns_;
  std::vector<double> start_;
  std::vector<int> places_;  // column of each cell, or `ignored`
};

}  // namespace

std::vector<double> read_variant_list(const std::string& text, const std::string& name,
                                      const DesignSpace& space) {
  ListReader reader(name, space);
  std::istringstream stream(text);
  std::string line;
  if (!std::getline(stream, line)) reader.fail(0, "is empty; its first line names columns.");
  reader.read_header(line);
  std::vector<double> rows;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) reader.read_row(line, number, rows);
  }
  if (rows.empty()) reader.fail(0, "holds no variant.");
  return rows;
}

}  // namespace bodyline::explore
