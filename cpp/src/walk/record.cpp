#include "zmpwalk/walk/record.hpp"

#include <iomanip>
#include <sstream>

namespace zmpwalk {
namespace {

constexpr double kWorthSaying = 0.2;  // turn or tilt of a foot that had its part in a fall [rad]

}  // namespace

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
    case Fall::kDown:
      return "the robot lay on the ground";
    case Fall::kLost:
      return "the DCM is beyond what any foothold within reach can catch";
    case Fall::kFootSpun:
      return "the support foot spun on the ground";
  }
  return "?";
}

std::string to_string(SpeedLimit limit) {
  switch (limit) {
    case SpeedLimit::kNone:
      return "";
    case SpeedLimit::kReach:
      return "reach of the legs";
    case SpeedLimit::kHip:
      return "torque of a hip";
    case SpeedLimit::kKnee:
      return "torque of a knee";
    case SpeedLimit::kYawFriction:
      return "friction against turning on the sole";
    case SpeedLimit::kFriction:
      return "friction against sliding";
  }
  return "?";
}

std::string to_string(const ForeseenFall& fall) {
  if (!fall) return "";
  if (fall.cause != Fall::kLost) return to_string(fall.cause);
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "the DCM is " << fall.gap
       << " m beyond what any foothold within reach can catch";
  if (fall.tip > kWorthSaying) text << ", and the foot that stands has tipped by " << fall.tip << " rad";
  if (fall.turn > kWorthSaying)
    text << ", and the foot that stands has turned by " << fall.turn << " rad on the ground";
  return text.str();
}

std::string RecordedColumn::text() const {
  std::string size = parts.and_nv ? std::string("(") + parts.names + ",)" : "";
  if (!parts.and_nv && parts.count > 1) size = "(" + std::to_string(parts.count) + ",): " + parts.names;
  if (!unit.empty()) size += (size.empty() ? "[" : " [") + unit + "]";
  if (!frame.empty()) size += (size.empty() ? "frame " : ", frame ") + frame;
  return size.empty() ? meaning : meaning + "\n\n" + size + ".";
}

std::vector<RecordedColumn> recorded_columns() {
  std::vector<RecordedColumn> out;
  visit_columns([&](const char* name, const auto& get, const Parts& parts, const char* unit, const char* frame,
                    const char* meaning) {
    out.push_back({name, parts, unit, frame, meaning, is_decided<std::decay_t<decltype(get)>>});
  });
  return out;
}

}  // namespace zmpwalk
