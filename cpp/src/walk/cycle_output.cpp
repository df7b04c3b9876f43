#include "zmpwalk/walk/record.hpp"

namespace zmpwalk {

std::string to_string(Fall fall) {
  switch (fall) {
    case Fall::kNone:
      return "";
    case Fall::kHeight:
      return "the COM came too low over the support foot";
    case Fall::kTilt:
      return "the trunk tilted too far";
    case Fall::kFootTipped:
      return "the support foot tipped over its edge";
    case Fall::kNonFinite:
      return "the simulated state is no longer finite";
    case Fall::kNoContact:
      return "no foot touched the ground any more";
  }
  return "?";
}

}  // namespace zmpwalk
