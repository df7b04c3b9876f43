#pragma once

#include <string>
#include <utility>
#include <vector>

#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// A value of an enum, the word for it as it stands in Python, in files and in messages, and what the word says where that is not plain.
template <class Enum>
struct Choice {
  Enum value;
  const char* word;
  const char* meaning = "";  ///< goes on after the word: "accelerates in proportion to the error"
};
template <class Enum>
using Choices = std::vector<Choice<Enum>>;

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

// Laws that are rows of a table. A value is the row's number, and the first row is the default.

/// A lateral law (III-D): a row of `LateralLaw::all()`.
enum class LateralLawName : int {};
const Choices<LateralLawName>& choices(LateralLawName);

/// A law by which the walk follows the planned velocity (III-C): a row of `TrackerLaw::all()`.
enum class TrackerLawName : int {};
const Choices<TrackerLawName>& choices(TrackerLawName);

/// How the reference ZMP is found (III-B).
enum class Iteration { kClosedForm, kLoop, kNone };
inline const Choices<Iteration>& choices(Iteration) {
  static const Choices<Iteration> all{
      {Iteration::kClosedForm, "closed_form"}, {Iteration::kLoop, "loop"}, {Iteration::kNone, "none"}};
  return all;
}

/// What ends a step.
enum class TouchDown { kFelt, kTime, kContact };
inline const Choices<TouchDown>& choices(TouchDown) {
  static const Choices<TouchDown> all{
      {TouchDown::kFelt, "felt"}, {TouchDown::kTime, "time"}, {TouchDown::kContact, "contact"}};
  return all;
}

inline const Choices<Side>& choices(Side) {
  static const Choices<Side> all{{kRight, "right"}, {kLeft, "left"}};
  return all;
}

/// The choices that the rows of a table of laws give.
template <class Name, class Law>
Choices<Name> choices_of(const std::vector<Law>& laws) {
  Choices<Name> out;
  for (const Law& law : laws) out.push_back({static_cast<Name>(out.size()), law.name, law.meaning});
  return out;
}

/// The word for a value.
template <class Enum>
std::string to_string(Enum value) {
  for (const auto& choice : choices(Enum{}))
    if (choice.value == value) return choice.word;
  return "?";
}

/// What to tell someone whose word for `name` is none of `known`: those that there are, and the nearest of them if one is near.
std::string no_such_word(const std::string& name, const std::string& word, const std::vector<std::string>& known);

/// The value that `word` stands for; `name` is what the message calls it.
/// @throws InputError  an unknown word; the message names those that exist, and the nearest
template <class Enum>
Enum chosen(const char* name, const std::string& word) {
  std::vector<std::string> known;
  for (const auto& choice : choices(Enum{})) {
    if (word == choice.word) return choice.value;
    known.emplace_back(choice.word);
  }
  throw InputError(no_such_word(name, word, known));
}

}  // namespace zmpwalk
