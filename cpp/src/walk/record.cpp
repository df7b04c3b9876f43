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
    case Fall::kDown:
      return "the robot lay on the ground";
  }
  return "?";
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
