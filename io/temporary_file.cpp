#include "io/temporary_file.hpp"

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

namespace fs = std::filesystem;

constexpr int attempts = 100;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw InputError(path.string(), 0, "",
                   "cannot be written: " + std::generic_category().message(error) + ".");
}

[[noreturn]] void fail_existing(const fs::path& path) {
  throw InputError(path.string(), 0, "", "exists already and is not overwritten unless asked.");
}

// What a path leads to, whatever links it goes through.
fs::path target_of(const fs::path& path) {
  std::error_code status;
  const fs::path target = fs::weakly_canonical(path, status);
  return status ? path : target;
}

void take_permissions(int descriptor, const fs::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) != 0) return;
  // Failing leaves the permissions of a new file, which is what the user's mask asks for.
  [[maybe_unused]] const int ignored = ::fchmod(descriptor, status.st_mode & 07777);
}

// The error number, 0 when the file has its new name.
int rename_file(const fs::path& from, const fs::path& to, Overwrite overwrite) {
  const unsigned flags = overwrite == Overwrite::never ? RENAME_NOREPLACE : 0;
  int result = ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags);
  // Some file systems know no flags; there the earlier look at the target has to do.
  if (result != 0 && errno == EINVAL && flags != 0) result = ::rename(from.c_str(), to.c_str());
  return result == 0 ? 0 : errno;
}

}  // namespace

TemporaryFile::TemporaryFile(fs::path path, Overwrite overwrite)
    : path_(std::move(path)), target_(target_of(path_)), overwrite_(overwrite) {
  std::error_code status;
  if (fs::is_directory(target_, status)) fail(path_, EISDIR);
  if (overwrite == Overwrite::never && fs::exists(target_, status)) fail_existing(path_);
  for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
    temporary_ = target_;
    temporary_ += std::string(".")
                      .append(std::to_string(::getpid()))
                      .append("-")
                      .append(std::to_string(attempt))
                      .append(".tmp");
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail(path_, errno);
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void TemporaryFile::write(std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void TemporaryFile::finish() {
  if (::fsync(descriptor_) != 0) fail(path_, errno);
  take_permissions(descriptor_, target_);
  const int error = rename_file(temporary_, target_, overwrite_);
  if (error == EEXIST) fail_existing(path_);
  if (error != 0) fail(path_, error);
  temporary_.clear();
}

}  // namespace bodyline::io
