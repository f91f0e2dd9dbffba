#pragma once

#include <stdexcept>
#include <string>

namespace bodyline::explore {

/// A study that cannot be carried out. `key` is the dotted path of the entry at fault, as in the
/// study's file ("variables.nose.vary"); what() is one sentence.
class StudyError : public std::runtime_error {
 public:
  StudyError(std::string key, const std::string& sentence)
      : std::runtime_error(sentence), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

}  // namespace bodyline::explore
