#include "io/write_file.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "io/input_error.hpp"

namespace bodyline::io {
namespace {

constexpr int attempts = 100;

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw InputError(path.string(), 0, "",
                   "cannot be written: " + std::generic_category().message(error) + ".");
}

[[noreturn]] void fail_existing(const std::filesystem::path& path) {
  throw InputError(path.string(), 0, "", "exists already and is not overwritten unless asked.");
}

/// A new file next to its target, removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) {
    for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
      path_ = target;
      path_ += std::string(".")
                   .append(std::to_string(::getpid()))
                   .append("-")
                   .append(std::to_string(attempt))
                   .append(".tmp");
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail(target, errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  /// The error number, 0 when all is on the disk.
  int write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0 ? 0 : errno;
  }

  void take_permissions(const std::filesystem::path& target) {
    struct stat status {};
    if (::stat(target.c_str(), &status) != 0) return;
    // Failing leaves the permissions of a new file, which is what the user's mask asks for.
    [[maybe_unused]] const int ignored = ::fchmod(descriptor_, status.st_mode & 07777);
  }

  /// The error number, 0 when the file now has its target's name.
  int rename(const std::filesystem::path& target, Overwrite overwrite) {
    const unsigned flags = overwrite == Overwrite::never ? RENAME_NOREPLACE : 0;
    int result = ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), flags);
    // Some file systems know no flags; there the earlier look at the target has to do.
    if (result != 0 && errno == EINVAL && flags != 0) {
      result = ::rename(path_.c_str(), target.c_str());
    }
    if (result != 0) return errno;
    path_.clear();
    return 0;
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view content, Overwrite overwrite) {
  std::error_code status;
  std::filesystem::path target = std::filesystem::weakly_canonical(path, status);
  if (status) target = path;
  if (std::filesystem::is_directory(target, status)) fail(path, EISDIR);
  if (overwrite == Overwrite::never && std::filesystem::exists(target, status)) fail_existing(path);
  TemporaryFile file(target);
  if (const int error = file.write(content)) fail(path, error);
  file.take_permissions(target);
  const int error = file.rename(target, overwrite);
  if (error == EEXIST) fail_existing(path);
  if (error != 0) fail(path, error);
}

}  // namespace bodyline::io
