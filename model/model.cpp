#include "model/model.hpp"

namespace bodyline::model {

const char* side_name(Side side) {
  switch (side) {
    case Side::u0:
      return "u0";
    case Side::u1:
      return "u1";
    case Side::v0:
      return "v0";
    case Side::v1:
      return "v1";
  }
  return "";
}

}  // namespace bodyline::model
