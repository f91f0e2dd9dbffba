#include "explore/append_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "explore/little_endian.hpp"
#include "explore/store_error.hpp"

namespace bodyline::explore {
namespace {

constexpr std::uint64_t end_place = 40;  // of the end of file in a superblock of version 0
// The byte that writers lock: beyond every file, so that locks of readers do not meet it.
constexpr off_t locked_byte = off_t(1) << 62;

std::uint64_t rounded_up(std::uint64_t value) { return (value + 7) / 8 * 8; }

// Two locks: one that keeps other stores' writers away, and the shared one of HDF5, which lets
// readers in and keeps away those who would write with the library.
void lock(int descriptor, const std::filesystem::path& path) {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = locked_byte;
  range.l_len = 1;
  const bool ours = ::fcntl(descriptor, F_OFD_SETLK, &range) == 0;
  if (ours && ::flock(descriptor, LOCK_SH | LOCK_NB) == 0) return;
  // File systems without locks have one user.
  if (errno == ENOLCK || errno == EOPNOTSUPP || errno == EINVAL) return;
  throw StoreError(path, "is being written by another program; two at once are not possible.");
}

// Whether a path still leads to an open file, not to one that has taken its name since.
bool is_at(int descriptor, const std::filesystem::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

}  // namespace

ReplaceLock::ReplaceLock(const std::filesystem::path& path) {
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    exists_ = descriptor_ >= 0 || errno != ENOENT;
    if (descriptor_ < 0) return;  // nobody can write what nobody can open
    try {
      lock(descriptor_, path);
    } catch (...) {
      ::close(descriptor_);
      throw;
    }
    // The writer that had it until now may just have replaced it.
  } while (!is_at(descriptor_, path));
}

ReplaceLock::~ReplaceLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

AppendFile::AppendFile(const std::filesystem::path& path) : path_(path) {
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot be opened for writing", errno);
  try {
    lock(descriptor_, path_);
    if (!is_at(descriptor_, path_))
      throw StoreError(path_,
                       "has just been replaced by another program; two at once are not possible.");
    end_ = rounded_up(read_number(end_place));
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

AppendFile::~AppendFile() { ::close(descriptor_); }

void AppendFile::fail(const char* what, int error) const {
  throw StoreError(path_, std::string(what) + ": " + std::generic_category().message(error) + ".");
}

void AppendFile::drop_unfinished() {
  end_ = rounded_up(read_number(end_place));
  if (::ftruncate(descriptor_, off_t(end_)) != 0) fail("cannot be cut to its end", errno);
}

void AppendFile::write(std::uint64_t address, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), off_t(address));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("cannot be written", written < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(std::size_t(written));
    address += std::uint64_t(written);
  }
}

std::uint64_t AppendFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t address = end_;
  write(address, bytes);
  end_ = rounded_up(address + bytes.size());
  return address;
}

void AppendFile::publish_end() {
  // The file must reach as far as its superblock says.
  if (::ftruncate(descriptor_, off_t(end_)) != 0) fail("cannot be made longer", errno);
  sync();
  replace_number(end_place, end_);
}

std::vector<std::byte> AppendFile::read(std::uint64_t address, std::size_t count) const {
  std::vector<std::byte> bytes(count);
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + done, count - done, off_t(address + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read", errno);
    if (got == 0) throw StoreError(path_, "is damaged: it ends too early.");
    done += std::size_t(got);
  }
  return bytes;
}

std::uint64_t AppendFile::read_number(std::uint64_t address) const {
  return get_little_endian(read(address, 8).data(), 8);
}

void AppendFile::replace_number(std::uint64_t address, std::uint64_t value) {
  std::array<std::byte, 8> bytes;
  put_little_endian(bytes.data(), value, 8);
  write(address, bytes);
}

void AppendFile::sync() {
  if (::fdatasync(descriptor_) != 0) fail("cannot be written", errno);
}

}  // namespace bodyline::explore
