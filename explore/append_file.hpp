#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace bodyline::explore {

/// A file with a superblock of version 0, written behind its end and in single numbers; locked
/// against other writers as long as this object lives. All functions throw StoreError.
class AppendFile {
 public:
  /// Refuses a file that another writer has.
  explicit AppendFile(const std::filesystem::path& path);
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  ~AppendFile();

  const std::filesystem::path& path() const { return path_; }

  /// Drops what lies behind the end that the superblock knows, and goes on there.
  void drop_unfinished();

  /// Where the next bytes go, a multiple of 8.
  std::uint64_t end() const { return end_; }
  /// Writes behind the end; returns where.
  std::uint64_t append(std::span<const std::byte> bytes);
  /// Lets the superblock know the end.
  void publish_end();

  std::vector<std::byte> read(std::uint64_t address, std::size_t count) const;
  std::uint64_t read_number(std::uint64_t address) const;
  /// One write of 8 bytes.
  void replace_number(std::uint64_t address, std::uint64_t value);
  /// Returns when everything written is on the disk.
  void sync();

 private:
  void write(std::uint64_t address, std::span<const std::byte> bytes);
  [[noreturn]] void fail(const char* what, int error) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;
};

/// Keeps other writers away from the file at a path, and from replacing it, as long as this lives.
class ReplaceLock {
 public:
  /// Throws StoreError when a writer has the file at `path`, or another one is replacing it.
  explicit ReplaceLock(const std::filesystem::path& path);
  ReplaceLock(const ReplaceLock&) = delete;
  ReplaceLock& operator=(const ReplaceLock&) = delete;
  ~ReplaceLock();

  /// Whether there is a file at the path.
  bool exists() const { return exists_; }

 private:
  int descriptor_ = -1;
  bool exists_ = false;
};

}  // namespace bodyline::explore
