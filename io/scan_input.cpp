#include "io/scan_input.hpp"

#include <algorithm>
#include <cstring>
#include <system_error>

#include "io/input_error.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t block = 1 << 20;

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\f\v") == std::string_view::npos;
}

}  // namespace

ScanInput::ScanInput(const std::filesystem::path& path) : path_(path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status)) fail("does not exist.");
  if (std::filesystem::is_directory(path, status)) fail("is a folder, not a scan.");
  size_ = std::filesystem::file_size(path, status);
  if (status) fail("is not a regular file.");
  if (size_ == 0) fail("is empty.");
  stream_.open(path, std::ios::binary);
  if (!stream_) fail("cannot be read.");
  buffer_.resize(block);
}

// Has at least `count` bytes waiting in the buffer, unless the file ends before.
bool ScanInput::fill(std::size_t count) {
  if (end_ - begin_ >= count) return true;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < count) buffer_.resize(count);
  while (end_ < count && stream_) {
    stream_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(stream_.gcount());
  }
  if (stream_.bad()) fail("cannot be read.");
  return end_ >= count;
}

std::string_view ScanInput::take(std::size_t count) {
  const std::string_view taken(buffer_.data() + begin_, count);
  begin_ += count;
  offset_ += count;
  return taken;
}

bool ScanInput::line(std::string_view& text) {
  std::size_t searched = 0;
  while (true) {
    const void* const found =
        std::memchr(buffer_.data() + begin_ + searched, '\n', end_ - begin_ - searched);
    if (found != nullptr) {
      text = take(static_cast<const char*>(found) - (buffer_.data() + begin_) + 1);
      text.remove_suffix(1);
      break;
    }
    searched = end_ - begin_;
    if (searched >= block) fail("holds a line of over 1 MiB, so it is not text.");
    if (fill(searched + 1)) continue;
    if (searched == 0) return false;
    text = take(searched);
    break;
  }
  if (text.ends_with('\r')) text.remove_suffix(1);
  ++line_;
  return true;
}

bool ScanInput::filled_line(std::string_view& text) {
  while (line(text)) {
    if (!is_blank(text)) return true;
  }
  return false;
}

const char* ScanInput::bytes(std::size_t count) {
  return fill(count) ? take(count).data() : nullptr;
}

void ScanInput::fail_line(const std::string& sentence) const {
  throw InputError(path_.string(), line_, "", sentence);
}

void ScanInput::fail(const std::string& sentence) const {
  throw InputError(path_.string(), 0, "", sentence);
}

}  // namespace bodyline::io
