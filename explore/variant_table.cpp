#include "explore/variant_table.hpp"

#include <cmath>
#include <span>

#include "io/picture.hpp"
#include "model/number_text.hpp"

namespace bodyline::explore {
namespace {

void put_numbers(std::ostream& out, std::span<const double> numbers) {
  for (const double number : numbers) {
    out << ',';
    if (std::isfinite(number)) out << model::number_text(number);
  }
}

template <class Value>
std::span<const Value> row_of(const std::vector<Value>& table, const VariantRows& rows, int row) {
  const std::size_t width = table.size() / std::size_t(rows.count);
  return {table.data() + std::size_t(row) * width, width};
}

void write_image(const StoreReader& store, std::uint64_t id, const std::filesystem::path& path) {
  const VariantRows one = store.read(id, 1, true);
  const std::vector<std::uint64_t> shape = thumbnail_shape(store.study().keep.thumbnail_width);
  io::write_png({int(shape[1]), int(shape[0]), one.thumbnails}, path, io::Overwrite::allowed);
}

}  // namespace

std::uint64_t write_variant_table(const StoreReader& store, const VariantFilter& filter,
                                  std::ostream& out, const std::filesystem::path& images) {
  const bool with_images = !images.empty() && store.study().keep.thumbnail_width > 0;
  out << "id";
  for (const std::string& name : variable_names(store)) out << ",in:" << name;
  for (const std::string& name : metric_names(store)) out << ",out:" << name;
  out << ",status,cause" << (with_images ? ",img" : "") << '\n';
  if (with_images) std::filesystem::create_directories(images);
  std::uint64_t count = 0;
  for_each_variant(store, filter, [&](const VariantRows& rows, int row) {
    const std::uint64_t id = rows.first + std::uint64_t(row);
    out << id;
    put_numbers(out, row_of(rows.values, rows, row));
    put_numbers(out, row_of(rows.metrics, rows, row));
    out << ',' << status_name(VariantStatus(rows.status[row])) << ','
        << store.header().causes[rows.cause[row]];
    if (with_images) {
      const std::string name = std::to_string(id) + ".png";
      write_image(store, id, images / name);
      out << ',' << (images.filename() / name).generic_string();
    }
    out << '\n';
    ++count;
  });
  return count;
}

}  // namespace bodyline::explore
