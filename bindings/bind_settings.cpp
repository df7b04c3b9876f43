#include <type_traits>

#include "common.hpp"
#include "zmpwalk/settings.hpp"

using namespace zmpwalk;

namespace {

template <class T>
py::object to_python(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return py::str(to_string(value));
  else
    return py::cast(value);
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

template <class T>
void from_python(const std::string& name, const py::handle& value, const std::string& unit, T& out) {
  try {
    if (std::is_same_v<T, bool> != py::isinstance<py::bool_>(value)) throw py::cast_error();
    if constexpr (std::is_enum_v<T>)
      from_string(value.cast<std::string>(), out);
    else
      out = value.cast<T>();
  } catch (const py::cast_error&) {
    throw InputError(name + " = " + std::string(py::repr(value)) + " is of the wrong type; it must be " +
                     kind_of<T>(unit));
  }
}

void set(WalkSettings& settings, const std::string& wanted, const py::handle& value) {
  // footsteps also takes a list of lengths
  if (wanted == "footsteps" && !py::isinstance<py::str>(value)) {
    from_python("footsteps", value, "m", settings.step_lengths);
    settings.footsteps = Footsteps::kList;
    return;
  }
  bool found = false;
  std::string known;
  visit_settings(settings, [&](const char* name, auto& member, const char* unit, const char*) {
    known += std::string(known.empty() ? "" : ", ") + name;
    if (wanted != name) return;
    from_python(wanted, value, unit, member);
    found = true;
  });
  if (!found) throw InputError("there is no setting '" + wanted + "'; there are: law, " + known);
}

py::dict to_dict(const WalkSettings& settings) {
  py::dict out;
  out["law"] = settings.law;
  visit_settings(
      settings, [&](const char* name, const auto& member, const char*, const char*) { out[name] = to_python(member); });
  return out;
}

WalkSettings from_keywords(const std::string& law, const py::dict& keywords) {
  WalkSettings settings(law);
  for (const auto& [name, value] : keywords) set(settings, py::str(name), value);
  return settings;
}

std::string documentation() {
  std::string text =
      "Every gain, bound and switch of the walk. NaN means 'from the robot' and is filled in by WalkingController.\n\n"
      "Args:\n    law: preset, 'default' or 'paper' (the literal law of the paper).\n";
  WalkSettings defaults;
  visit_settings(defaults, [&](const char* name, const auto& member, const char* unit, const char* meaning) {
    text += std::string("    ") + name + ": " + meaning + (*unit ? std::string(" [") + unit + "]" : "") + ". Default " +
            std::string(py::repr(to_python(member))) + ".\n";
  });
  return text +
         "\nRaises:\n    InputError: an unknown name or a value of the wrong type.\n\nUsage:\n"
         "    >>> WalkSettings(law='paper', footsteps='absolute')\n";
}

}  // namespace

void bind_settings(py::module_& m) {
  py::class_<WalkSettings> cls(m, "WalkSettings");
  const std::string text = documentation();
  cls.def(py::init([](const std::string& law, const py::kwargs& keywords) { return from_keywords(law, keywords); }),
          "law"_a = "default", text.c_str());
  cls.def_readonly("law", &WalkSettings::law, "preset this started from");
  WalkSettings defaults;
  visit_settings(defaults, [&](const char* name, auto&, const char* unit, const char* meaning) {
    const std::string key = name;
    const std::string doc = std::string(meaning) + (*unit ? std::string(" [") + unit + "]" : "");
    cls.def_property(
        name, py::cpp_function([key](const WalkSettings& s) { return py::object(to_dict(s)[py::str(key)]); }),
        py::cpp_function([key](WalkSettings& s, const py::object& value) { set(s, key, value); }), doc.c_str());
  });
  cls.def_static(
      "table",
      [] {
        WalkSettings fresh;
        py::dict out;
        visit_settings(fresh, [&](const char* name, auto&, const char* unit, const char* meaning) {
          out[name] = py::make_tuple(unit, meaning);
        });
        return out;
      },
      "Every setting's (unit, meaning) by name, in the order of `to_dict`.");
  cls.def("to_dict", &to_dict, "All settings by name, as plain Python values.");
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
