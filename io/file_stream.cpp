#include "io/file_stream.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t buffer_bytes = std::size_t(1) << 16;

}  // namespace

FileStream::Buffer::Buffer(std::filesystem::path path, Overwrite overwrite)
    : file_(std::move(path), overwrite), bytes_(buffer_bytes) {
  setp(bytes_.data(), bytes_.data() + bytes_.size());
}

void FileStream::Buffer::write_out() {
  file_.write({pbase(), std::size_t(pptr() - pbase())});
  setp(bytes_.data(), bytes_.data() + bytes_.size());
}

FileStream::Buffer::int_type FileStream::Buffer::overflow(int_type character) {
  write_out();
  if (!traits_type::eq_int_type(character, traits_type::eof()))
    sputc(traits_type::to_char_type(character));
  return traits_type::not_eof(character);
}

void FileStream::Buffer::finish() {
  write_out();
  file_.finish();
}

FileStream::FileStream(std::filesystem::path path, Overwrite overwrite)
    : buffer_(std::move(path), overwrite), stream_(&buffer_) {
  stream_.exceptions(std::ios::badbit);  // lets what the buffer throws through
}

void FileStream::finish() { buffer_.finish(); }

}  // namespace bodyline::io
