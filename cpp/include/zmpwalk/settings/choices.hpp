#pragma once

#include <string>
#include <utility>
#include <vector>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// The values of an enum, each with its word as it stands in Python, in files and in messages.
template <class Enum>
using Choices = std::vector<std::pair<Enum, const char*>>;

/// Where the swing foot is set down.
enum class Footsteps { kTied, kAbsolute, kPaper, kPrinted, kList };
inline const Choices<Footsteps>& choices(Footsteps) {
  static const Choices<Footsteps> all{{Footsteps::kTied, "tied"},
                                      {Footsteps::kAbsolute, "absolute"},
                                      {Footsteps::kPaper, "paper"},
                                      {Footsteps::kPrinted, "printed"},
                                      {Footsteps::kList, "list"}};
  return all;
}

/// Which state of the COM equations (16) and (17) start from.
enum class ComState { kMeasured, kDesired };
inline const Choices<ComState>& choices(ComState) {
  static const Choices<ComState> all{{ComState::kMeasured, "measured"}, {ComState::kDesired, "desired"}};
  return all;
}

/// How the walk follows the planned velocity (III-C).
enum class TrackerLaw { kSmooth, kBangBang };
inline const Choices<TrackerLaw>& choices(TrackerLaw) {
  static const Choices<TrackerLaw> all{{TrackerLaw::kSmooth, "smooth"}, {TrackerLaw::kBangBang, "bang_bang"}};
  return all;
}

/// How the reference ZMP is found (III-B).
enum class Iteration { kClosedForm, kLoop, kNone };
inline const Choices<Iteration>& choices(Iteration) {
  static const Choices<Iteration> all{
      {Iteration::kClosedForm, "closed_form"}, {Iteration::kLoop, "loop"}, {Iteration::kNone, "none"}};
  return all;
}

/// What ends a step.
enum class TouchDown { kTime, kContact };
inline const Choices<TouchDown>& choices(TouchDown) {
  static const Choices<TouchDown> all{{TouchDown::kTime, "time"}, {TouchDown::kContact, "contact"}};
  return all;
}

inline const Choices<Side>& choices(Side) {
  static const Choices<Side> all{{kRight, "right"}, {kLeft, "left"}};
  return all;
}

/// The word for a value.
template <class Enum>
std::string to_string(Enum value) {
  for (const auto& [v, word] : choices(Enum{}))
    if (v == value) return word;
  return "?";
}

/// Sets `out` to the value that `word` stands for; `name` is what the message calls it.
/// @throws InputError  an unknown word; the message names those that exist
template <class Enum>
void from_string(const char* name, const std::string& word, Enum& out) {
  std::string known;
  for (const auto& [v, w] : choices(Enum{})) {
    if (word == w) {
      out = v;
      return;
    }
    known += std::string(known.empty() ? "" : ", ") + w;
  }
  throw InputError(std::string(name) + " = '" + word + "' is unknown; there are: " + known);
}

}  // namespace zmpwalk
