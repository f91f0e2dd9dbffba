#include "cli/set_variables.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bodyline {
namespace {

using cli::AssignmentKind;

void expect_assignment(const std::string& text, const std::string& pattern, AssignmentKind kind,
                       double number) {
  const cli::Assignment assignment = cli::assignment_from_text(text);
  EXPECT_EQ(assignment.pattern, pattern) << text;
  EXPECT_EQ(assignment.kind, kind) << text;
  EXPECT_EQ(assignment.number, number) << text;
}

TEST(AssignmentText, KnowsFourForms) {
  expect_assignment("shape.hood.u[0]=-3", "shape.hood.u[0]", AssignmentKind::replace, -3.0);
  expect_assignment("cut.*=0.1", "cut.*", AssignmentKind::replace, 0.1);
  expect_assignment("a+=1e-3", "a", AssignmentKind::add, 1e-3);
  expect_assignment("a-=2", "a", AssignmentKind::add, -2.0);
  expect_assignment("a=*0.5", "a", AssignmentKind::multiply, 0.5);
  expect_assignment("a=+2", "a", AssignmentKind::replace, 2.0);
}

TEST(AssignmentText, RefusesWhatIsNoAssignmentOfAFiniteNumber) {
  for (const std::string text :
       {"", "a", "=", "=1", "a=", "a=1,5", "a=inf", "a=nan", "a=1 ", "a=**2", "a==1", "a=1e999"}) {
    EXPECT_THROW(cli::assignment_from_text(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace bodyline
