#include "explore/store_file.hpp"

namespace bodyline::explore {
namespace {

ChunkTree tree_of(const TableLayout& table) {
  std::vector<std::uint64_t> chunk{std::uint64_t(table.chunk_rows)};
  chunk.insert(chunk.end(), table.row.begin(), table.row.end());
  return {chunk, element_bytes(table.type)};
}

}  // namespace

StoreFile::StoreFile(std::unique_ptr<AppendFile> file, const StoreReader& reader)
    : file_(std::move(file)) {
  file_->drop_unfinished();
  written_ = reader.rows();
  const StoreReader::Places places = reader.places();
  counter_ = places.counter;
  const std::vector<TableLayout>& layouts = reader.layout().tables;
  for (std::size_t t = 0; t < layouts.size(); ++t) {
    Table table{tree_of(layouts[t]), places.tables[t], layouts[t].chunk_rows};
    try {
      table.tree.load(
          file_->read_number(table.places.root), reader.rows(),
          [&](std::uint64_t address, std::size_t count) { return file_->read(address, count); });
    } catch (const StoreError&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw StoreError(file_->path(), std::string("is damaged: ") + error.what() + ".");
    }
    tables_.push_back(std::move(table));
  }
}

void StoreFile::write(const EncodedBlock& block) {
  const std::uint64_t end = block.first + std::uint64_t(block.rows);
  if (end <= written_) return;
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    std::uint64_t row = block.first;
    for (const std::vector<std::byte>& chunk : block.chunks[t]) {
      const std::uint64_t next = row + std::uint64_t(tables_[t].chunk_rows);
      if (next > written_)
        tables_[t].tree.append(row, std::uint32_t(chunk.size()), file_->append(chunk));
      row = next;
    }
  }
  written_ = end;
}

void StoreFile::commit(std::uint64_t rows) {
  std::vector<ChunkTree::Image> images;
  for (Table& table : tables_) {
    images.push_back(table.tree.write(file_->end()));
    file_->append(images.back().bytes);
  }
  // Everything new is on the disk before the superblock knows of it, and the superblock before
  // anything points behind the old end.
  file_->publish_end();
  file_->sync();
  for (std::size_t t = 0; t < tables_.size(); ++t) {
    file_->replace_number(tables_[t].places.root, images[t].root);
    for (const auto& [place, address] : images[t].patches) file_->replace_number(place, address);
    file_->replace_number(tables_[t].places.rows, rows);
  }
  file_->sync();
  file_->replace_number(counter_, rows);
}

}  // namespace bodyline::explore
