#pragma once

#include "model/isa_namespace.hpp"

/// Branches that depend on a number.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// The number whose sign decides a branch: the value itself, whatever derivatives it carries.
inline double branch_value(double value) { return value; }
template <class Real>
double branch_value(const Real& value) {
  if constexpr (requires { value.real(); }) {
    return value.real();
  } else {
    return value.a;
  }
}

/// `yes` where x >= floor, else `no`. A type of several lanes brings its own.
template <class Real>
Real where_at_least(const Real& x, const Real& floor, const Real& yes, const Real& no) {
  return branch_value(x) >= branch_value(floor) ? yes : no;
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
