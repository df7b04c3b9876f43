#include <algorithm>
#include <numeric>

#include "zmpwalk/settings/settings.hpp"

namespace zmpwalk {
namespace {

/// Least number of letters inserted, left out, replaced or swapped with their neighbour that makes `a` of `b`.
int edits(const std::string& a, const std::string& b) {
  std::vector<int> two_before(b.size() + 1), before(b.size() + 1), now(b.size() + 1);
  std::iota(now.begin(), now.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_before.swap(before);
    before.swap(now);
    now[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], two_before[j - 2] + 1);
    }
  }
  return now.back();
}

/// At most so many edits make a wrong word a near one.
int enough_for(const std::string& word) { return std::max(1, static_cast<int>(word.size()) / 3); }

std::string joined(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  return text;
}

}  // namespace

std::string Setting::both_names() const { return std::string(name) == flat ? path() : path() + " (" + flat + ")"; }

std::string no_such_word(const std::string& name, const std::string& word, const std::vector<std::string>& known) {
  const std::string text = name + " = '" + word + "' is unknown; there are: " + joined(known, ", ");
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edits(word, a) < edits(word, b);
  });
  if (nearest == known.end() || edits(word, *nearest) > enough_for(word)) return text;
  return text + "; did you mean '" + *nearest + "'?";
}

std::string no_such_setting(const std::string& wanted) {
  constexpr std::size_t kMost = 3;
  std::vector<std::pair<int, std::string>> near;
  std::vector<std::string> groups, names;
  const int enough = enough_for(wanted);
  const WalkSettings any;
  visit_groups(any, [&](const auto& group) {
    groups.emplace_back(group.kGroup);
    near.emplace_back(edits(wanted, group.kGroup), std::string("the group ") + group.kGroup);
  });
  visit_settings(any, [&](const auto&, const Setting& row) {
    const int by_name = wanted == row.name ? 0 : enough + 1;
    near.emplace_back(std::min({by_name, edits(wanted, row.flat), edits(wanted, row.path())}), row.both_names());
  });
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance, name] : near)
    if (distance <= enough && distance == near.front().first && names.size() < kMost) names.push_back(name);
  const std::string text = "there is no setting '" + wanted + "'; ";
  return names.empty() ? text + "the groups are " + joined(groups, " and ")
                       : text + "did you mean " + joined(names, " or ") + "?";
}

}  // namespace zmpwalk
