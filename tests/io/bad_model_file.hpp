#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

/// Files of models with one mistake each; model_file_errors.cpp says what each must give.
namespace bodyline {

/// One mistake in the file of model 1: the text `right`, which the file holds after `after`,
/// becomes `wrong`.
struct Mistake {
  std::string name;
  std::string after;
  std::string right;
  std::string wrong;
  std::string key;                 ///< of the error
  std::vector<std::string> words;  ///< in the sentence: the value and what is allowed
  int lines_down = 0;              ///< from the start of `wrong` to the line of the error
  std::string at = "";             ///< or: the text on the line of the error
};

inline void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

inline const std::string hood = "[patches.hood]\n";
inline const std::string hood_joint = "[joints.hood__windshield]\n";

class BadModelFile : public ::testing::TestWithParam<Mistake> {};

/// The name of a mistake, as INSTANTIATE_TEST_SUITE_P wants it.
inline std::string name_of(const ::testing::TestParamInfo<Mistake>& info) {
  return info.param.name;
}

}  // namespace bodyline
