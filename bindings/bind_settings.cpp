#include <type_traits>

#include "common.hpp"
#include "zmpwalk/settings/settings.hpp"

using namespace zmpwalk;

namespace {

template <class T>
py::object to_python(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return py::str(to_string(value));
  else
    return py::cast(value);
}

/// Python's type of a setting, as an annotation.
template <class T>
std::string type_of() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_same_v<T, int>) return "int";
  if constexpr (std::is_same_v<T, double>) return "float";
  if constexpr (std::is_same_v<T, std::vector<double>>) return "list[float]";
  if constexpr (std::is_same_v<T, std::map<std::string, double>>) return "dict[str, float]";
  return "str";
}

/// What a setting of type T must be, for messages.
template <class T>
std::string kind_of(const std::string& unit) {
  const std::string in_unit = unit.empty() ? "" : " [" + unit + "]";
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_same_v<T, int>) return "an integer";
  if constexpr (std::is_same_v<T, double>) return "a number" + in_unit;
  if constexpr (std::is_same_v<T, std::vector<double>>) return "a list of numbers" + in_unit;
  if constexpr (std::is_same_v<T, std::map<std::string, double>>) return "a table, joint name = number" + in_unit;
  return "a word";
}

/// A row of the table as Python shows it.
struct Row {
  std::string group, name, flat, type, unit, range, rule, meaning;
  std::vector<std::string> words, meanings;  // of the words
  py::object default_value;
};

template <class T>
Row row_of(const T& value, const Setting& row) {
  Row out{row.group,   row.name, row.flat, type_of<T>(),    row.unit, row.range.text, row.default_value.text(),
          row.meaning, {},       {},       to_python(value)};
  if constexpr (std::is_enum_v<T>)
    for (const auto& choice : choices(T{})) {
      out.words.emplace_back(choice.word);
      out.meanings.emplace_back(choice.meaning);
    }
  return out;
}

/// What the setting is for, its unit, its words and its default, in one paragraph.
std::string row_text(const Row& row) {
  std::string text = row.meaning + (row.unit.empty() ? "" : " Unit: " + row.unit + ".");
  for (std::size_t i = 0; i < row.words.size(); ++i) {
    const std::string& meaning = row.meanings[i];
    text += (i == 0 ? " One of '" : meaning.empty() ? ", '" : "; '") + row.words[i] + "'";
    if (!meaning.empty()) text += ", which " + meaning;
  }
  if (!row.words.empty()) text += ".";
  return text + " Default: " + (row.rule.empty() ? std::string(py::repr(row.default_value)) : row.rule) + ".";
}

// --- reading

py::object get(const WalkSettings& settings, const std::string& flat) {
  py::object out;
  visit_settings(settings, [&](const auto& member, const Setting& row) {
    if (flat == row.flat) out = to_python(member);
  });
  return out;
}

py::dict to_dict(const WalkSettings& settings) {
  py::dict out;
  out["law"] = settings.law;
  visit_settings(settings, [&](const auto& member, const Setting& row) { out[row.flat] = to_python(member); });
  return out;
}

template <class Group>
py::dict group_dict(const Group& group) {
  py::dict out;
  visit_group(group, [&](const auto& member, const Setting& row) { out[row.name] = to_python(member); });
  return out;
}

// --- writing; `asked` is the setting's name as the caller wrote it

template <class T>
void from_python(const std::string& asked, const py::handle& value, const Setting& row, T& out) {
  try {
    if (std::is_same_v<T, bool> != py::isinstance<py::bool_>(value)) throw py::cast_error();
    if constexpr (std::is_enum_v<T>)
      out = chosen<T>(asked.c_str(), value.cast<std::string>());
    else
      out = value.cast<T>();
  } catch (const py::cast_error&) {
    throw InputError(asked + " = " + std::string(py::repr(value)) + " is of the wrong type; it must be " +
                     kind_of<T>(row.unit));
  }
}

template <class Group, class T>
void assign(const std::string& asked, const py::handle& value, const Setting& row, Group&, T& out) {
  from_python(asked, value, row, out);
}

/// The mode of the steps also takes their lengths.
void assign(const std::string& asked, const py::handle& value, const Setting& row, StepsSettings& steps,
            Footsteps& mode) {
  if (py::isinstance<py::str>(value)) return from_python(asked, value, row, mode);
  from_python(asked, value, {"", "", "", "m", must_be::kAnything, {}, ""}, steps.lengths);
  mode = Footsteps::kList;
}

/// A setting that is a word now and was true or false once: the words that these stand for.
struct Former {
  const char *group, *name, *now, *yes, *no;

  Setting row() const { return {group, name, name, "", must_be::kAnything, {}, ""}; }
};
constexpr Former kFormer[] = {{"zmp", "lateral_feedback", "lateral_law", "orbit", "paper"}};

template <class Group, class IsIt>
bool set_row(const std::string& asked, const py::handle& value, Group& group, IsIt&& is_it) {
  bool found = false;
  visit_group(group, [&](auto& member, const Setting& row) {
    if (found || !is_it(row)) return;
    assign(asked, value, row, group, member);
    found = true;
  });
  return found;
}

/// Sets the one for which `is_it(row)`, by its former name too; false if there is none.
template <class Group, class IsIt>
bool set_one(const std::string& asked, const py::handle& value, Group& group, IsIt&& is_it) {
  for (const Former& former : kFormer) {
    if (std::string(group.kGroup) != former.group || !is_it(former.row())) continue;
    bool was = false;
    from_python(asked, value, former.row(), was);
    return set_row(asked, py::str(was ? former.yes : former.no), group,
                   [&](const Setting& row) { return std::string(former.now) == row.name; });
  }
  return set_row(asked, value, group, is_it);
}

/// Several at once, from a dict of names in the group, or all from another such group.
template <class Group>
void set_group(const py::handle& value, Group& group) {
  if (py::isinstance<Group>(value)) {
    group = value.cast<Group>();
    return;
  }
  if (!py::isinstance<py::dict>(value))
    throw InputError(std::string(group.kGroup) + " = " + std::string(py::repr(value)) +
                     " is of the wrong type; it is a group of settings: give a dict of names and values");
  Group changed = group;
  for (const auto& [key, each] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string name = py::str(key), path = std::string(group.kGroup) + "." + name;
    if (!set_one(path, each, changed, [&](const Setting& row) { return name == row.name; }))
      throw InputError(no_such_setting(path));
  }
  group = changed;
}

/// Sets what is called `name`: a group, tracking.gain, or tracker_gain.
void set(WalkSettings& settings, const std::string& name, const py::handle& value) {
  bool found = false;
  visit_groups(settings, [&](auto& group) {
    if (found) return;
    if (name == group.kGroup) {
      set_group(value, group);
      found = true;
    } else {
      found = set_one(name, value, group, [&](const Setting& row) { return name == row.flat || name == row.path(); });
    }
  });
  if (!found) throw InputError(no_such_setting(name));
}

WalkSettings from_keywords(const std::string& law, const py::dict& keywords) {
  WalkSettings settings(law);
  for (const auto& [name, value] : keywords) set(settings, py::str(name), value);
  return settings;
}

// --- classes

/// "GaitSettings" for "gait".
std::string class_name(std::string group) {
  group[0] = static_cast<char>(std::toupper(group[0]));
  return group + "Settings";
}

std::string documentation() {
  std::string text =
      "Every gain, bound and switch of the walk, in groups: `settings.tracking.gain`.\n\n"
      "Each setting has one word as well (in brackets below, where it is not the name itself), which does the same as\n"
      "keyword, as attribute and in files. NaN means 'from the robot': WalkingController fills it in. Defaults scale\n"
      "with the height z_c of the COM over the soles at the start, with gravity g, and with T_c = sqrt(z_c / g), the\n"
      "time constant in which the robot would fall over.\n\nArgs:\n    law: preset, 'default' or 'paper' (the literal "
      "law of the paper).\n";
  const WalkSettings defaults;
  visit_groups(defaults, [&](const auto& group) {
    text +=
        std::string("    ") + group.kGroup + ": " + group.kMeaning + " A dict, or " + class_name(group.kGroup) + ".\n";
    visit_group(group, [&](const auto& member, const Setting& row) {
      const std::string name = row.name, word = name == row.flat ? "" : " (" + std::string(row.flat) + ")";
      text += "        " + name + word + ": " + row_text(row_of(member, row)) + "\n";
    });
  });
  return text +
         "\nRaises:\n    InputError: an unknown name or a value of the wrong type.\n\nUsage:\n"
         "    >>> WalkSettings(law='paper', steps={'mode': 'absolute', 'width': 0.2}, tracker_gain=4.0)\n";
}

template <class Group>
void bind_group(py::module_& m, py::class_<WalkSettings>& cls, const Group& defaults) {
  py::class_<Group> group(m, class_name(Group::kGroup).c_str(), Group::kMeaning);
  visit_group(defaults, [&](const auto& member, const Setting& row) {
    const std::string name = row.name, path = row.path(), doc = row_text(row_of(member, row));
    group.def_property(
        row.name, [name](const Group& g) { return py::object(group_dict(g)[py::str(name)]); },
        [name, path](Group& g, const py::object& value) {
          set_one(path, value, g, [&](const Setting& each) { return name == each.name; });
        },
        doc.c_str());
  });
  group.def("to_dict", &group_dict<Group>, "The group's settings by name, as plain Python values.");
  group.def("__repr__",
            [](const Group& g) { return class_name(Group::kGroup) + "(" + std::string(py::str(group_dict(g))) + ")"; });
  group.def(
      "__eq__", [](const Group& a, const Group& b) { return py::repr(group_dict(a)).equal(py::repr(group_dict(b))); },
      py::is_operator());
  group.def("__copy__", [](const Group& g) { return g; });
  group.def("__deepcopy__", [](const Group& g, const py::dict&) { return g; });
  group.def(py::pickle([](const Group& g) { return group_dict(g); },
                       [](const py::dict& state) {
                         Group g;
                         set_group(state, g);
                         return g;
                       }));
  cls.def_property(
      Group::kGroup,
      py::cpp_function(
          [](WalkSettings& s) {
            Group* out = nullptr;
            visit_groups(s, [&](auto& each) {
              if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Group>) out = &each;
            });
            return out;
          },
          py::return_value_policy::reference_internal),
      [](WalkSettings& s, const py::object& value) { set(s, Group::kGroup, value); }, Group::kMeaning);
}

}  // namespace

void bind_settings(py::module_& m) {
  py::class_<Row>(m, "Setting", "A row of the table of settings, see `WalkSettings.table`.")
      .def_readonly("group", &Row::group, "its group, such as 'tracking'")
      .def_readonly("name", &Row::name, "its name in the group, such as 'gain'")
      .def_readonly("flat", &Row::flat, "its one word, such as 'tracker_gain'")
      .def_readonly("type", &Row::type, "its type, as an annotation")
      .def_readonly("unit", &Row::unit, "SI; '' where it has none")
      .def_readonly("range", &Row::range, "the rule for its number or numbers; '' for what is no number")
      .def_readonly("words", &Row::words, "the words that there are, where it is one of a few")
      .def_readonly("default", &Row::default_value, "default; NaN where it depends on the robot")
      .def_readonly("rule", &Row::rule, "how the robot gives its default; '' where it does not depend on the robot")
      .def_readonly("meaning", &Row::meaning, "what it is for")
      .def_property_readonly("text", &row_text, "what it is for, its unit, its words and its default, in one paragraph")
      .def("__repr__", [](const Row& r) { return "Setting(" + r.group + "." + r.name + ": " + row_text(r) + ")"; });
  py::class_<WalkSettings> cls(m, "WalkSettings");
  const std::string text = documentation();
  cls.def(py::init([](const std::string& law, const py::kwargs& keywords) { return from_keywords(law, keywords); }),
          "law"_a = "default", text.c_str());
  cls.def_readonly("law", &WalkSettings::law, "preset this started from");
  const WalkSettings defaults;
  visit_groups(defaults, [&](const auto& group) { bind_group(m, cls, group); });
  visit_settings(defaults, [&](const auto& member, const Setting& row) {
    const std::string flat = row.flat, doc = row.path() + ": " + row_text(row_of(member, row));
    cls.def_property(
        row.flat, [flat](const WalkSettings& s) { return get(s, flat); },
        [flat](WalkSettings& s, const py::object& value) { set(s, flat, value); }, doc.c_str());
  });
  for (const Former& former : kFormer)
    cls.def_property(
        former.name, [former](const WalkSettings& s) { return get(s, former.now).equal(py::str(former.yes)); },
        [former](WalkSettings& s, const py::object& value) { set(s, former.name, value); });
  cls.def_static(
      "table",
      [] {
        const WalkSettings fresh;
        py::dict out;
        visit_settings(fresh,
                       [&](const auto& member, const Setting& row) { out[row.path().c_str()] = row_of(member, row); });
        return out;
      },
      "Every setting, as a `Setting` by its path such as 'tracking.gain'.");
  cls.def_static(
      "find",
      [](const std::string& name) {
        const WalkSettings fresh;
        py::object out;
        visit_settings(fresh, [&](const auto& member, const Setting& row) {
          if (name == row.flat || name == row.path()) out = py::cast(row_of(member, row));
        });
        for (const Former& former : kFormer)
          if (name == former.name || name == former.row().path()) {
            const std::string now = std::string(former.group) + "." + former.now;
            Row row = row_of(true, former.row());
            row.default_value = py::bool_(get(fresh, former.now).equal(py::str(former.yes)));
            row.meaning = "It is " + now + " now: true stands for '" + former.yes + "', false for '" + former.no + "'.";
            out = py::cast(row);
          }
        if (!out) throw InputError(no_such_setting(name));
        return out.cast<Row>();
      },
      "name"_a,
      "The row of one setting.\n\nArgs:\n    name: 'tracking.gain', or its one word 'tracker_gain'.\n\nRaises:\n    "
      "InputError: there is none; the message names the nearest.\n\nUsage: `print(WalkSettings.find('T_ss').text)`");
  cls.def(
      "update",
      [](WalkSettings& s, const py::kwargs& changes) {
        WalkSettings changed = s;
        for (const auto& [name, value] : changes) set(changed, py::str(name), value);
        s = changed;
      },
      "Changes settings, named as in the constructor: all of them or, if one is refused, none.\n\nRaises:\n    "
      "InputError: an unknown name or a value of the wrong type.\n\nUsage: `settings.update(tracking={'gain': 3.0}, "
      "T_ss=0.6)`");
  cls.def("to_dict", &to_dict, "All settings by their one word, as plain Python values.");
  cls.def("__repr__", [](const WalkSettings& s) { return "WalkSettings(" + std::string(py::str(to_dict(s))) + ")"; });
  cls.def(
      "__eq__",
      [](const WalkSettings& a, const WalkSettings& b) { return py::repr(to_dict(a)).equal(py::repr(to_dict(b))); },
      py::is_operator());
  cls.def("__copy__", [](const WalkSettings& s) { return s; });
  cls.def("__deepcopy__", [](const WalkSettings& s, const py::dict&) { return s; });
  cls.def(py::pickle([](const WalkSettings& s) { return to_dict(s); },
                     [](py::dict state) {
                       const std::string law = state.attr("pop")("law").cast<std::string>();
                       return from_keywords(law, state);
                     }));
}
