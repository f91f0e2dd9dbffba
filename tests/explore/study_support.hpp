#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "explore/read_study.hpp"
#include "explore/variant_evaluator.hpp"
#include "explore/variant_source.hpp"

/// Studies of the cars of the repository that the tests of this folder make.
namespace bodyline::testing {

/// The text of a study: the base line ("model = ..." with names of cars), the lines of [variables],
/// [metrics] and [sampler], and further tables.
std::string study_text(const std::string& base, const std::string& variables,
                       const std::string& metrics, const std::string& sampler,
                       const std::string& rest = "");

/// A study from such a text; the names of models are those of files in `cars`.
explore::Study study_of(const std::string& text);

/// A small study of model 1 with `count` random variants and few variables.
explore::Study small_study(int count, const std::string& rest = "");

/// The values of variants first to first + count - 1, one vector each.
std::vector<std::vector<double>> variants(const explore::Study& study,
                                          const explore::DesignSpace& space, int count);

/// The sentence with which a study is refused; "" when it is not.
std::string refusal(const std::string& text);

/// An empty folder for the life of the object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bodyline::testing
