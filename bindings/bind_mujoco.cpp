#include <cstdint>

#include "common.hpp"

using namespace zmpwalk;

namespace {

/// `wanted` keeps a class of the mujoco package, found at first use: an update from Python has no time for an import.
template <class Struct>
Struct* pointer_of(const py::object& object, const char* type, PyObject*& wanted) {
  if (!wanted) wanted = py::object(py::module_::import("mujoco").attr(type)).release().ptr();
  if (Py_TYPE(object.ptr()) != reinterpret_cast<PyTypeObject*>(wanted) && !py::isinstance(object, wanted))
    throw py::type_error(std::string("expected a mujoco.") + type + ", got " +
                         std::string(py::str(py::type::of(object).attr("__name__"))));
  static PyObject* const address = PyUnicode_InternFromString("_address");
  // A class that inherits from it may say anything: its base class is asked.
  const bool own = Py_TYPE(object.ptr()) == reinterpret_cast<PyTypeObject*>(wanted);
  const auto number = own ? py::reinterpret_steal<py::object>(PyObject_GetAttr(object.ptr(), address))
                          : py::object(py::handle(wanted).attr("_address").attr("__get__")(object));
  if (!number) throw py::error_already_set();
  return reinterpret_cast<Struct*>(number.cast<std::uintptr_t>());
}

PyObject *model_class = nullptr, *data_class = nullptr;

/// Version of the MuJoCo that the core is connected with.
std::string version;

template <class T>
std::uintptr_t address(const T* p) {
  return reinterpret_cast<std::uintptr_t>(p);
}

}  // namespace

Model model_of(const py::object& model) { return pointer_of<const mjModel_>(model, "MjModel", model_class); }
Data data_of(const py::object& data) { return pointer_of<mjData_>(data, "MjData", data_class); }

void bind_mujoco(py::module_& m) {
  m.def(
      "connect",
      [](const std::string& adapter, const std::string& libmujoco, const std::string& of_version) {
        connect(adapter, libmujoco);
        if (version.empty()) version = of_version;
      },
      "adapter"_a, "libmujoco"_a, "version"_a,
      "Connects the core with MuJoCo; `import zmpwalk` calls it. Later calls change nothing.\n\n"
      "Args:\n    adapter: file of the adapter for this version.\n    libmujoco: file of MuJoCo's library.\n    "
      "version: "
      "of MuJoCo.");
  m.def("mujoco_version", [] { return version; }, "MuJoCo version that the core is connected with; empty without one.");
  m.def(
      "seen",
      [](const py::object& model, const py::object& data) {
        const Model a = model_of(model);
        const Data b = data_of(data);
        py::dict counts, of_model, of_data;
#define COUNT(name) counts[#name] = a.name;
#define ARRAY(type, name) of_model[#name] = address(a.name);
#define DOUBLES(name) of_data[#name] = address(b.name);
        ZMPWALK_MODEL_COUNTS(COUNT)
        ZMPWALK_MODEL_ARRAYS(ARRAY)
        ZMPWALK_DATA_ARRAYS(DOUBLES)
        of_model["opt.gravity"] = address(a.gravity);
        counts["opt.timestep"] = *a.timestep;
        counts["opt.integrator"] = *a.integrator;
        counts["opt.disableflags"] = *a.disableflags;
        py::list contacts;
        for (int i = 0; i < *b.ncon; ++i) {
          const zmpwalk_contact c = mj::contact(b, i);
          contacts.append(py::make_tuple(c.geom[0], c.geom[1], Vec3(Eigen::Map<const Vec3>(c.pos))));
        }
        py::dict out;
        out["numbers"] = counts;
        out["model"] = of_model;
        out["data"] = of_data;
        out["time"] = *b.time;
        out["contacts"] = contacts;
        return out;
      },
      "model"_a, "data"_a,
      "What the core sees of a model and its data, to be compared with what the mujoco package shows.\n\n"
      "Returns:\n    dict: numbers by name; model and data, addresses of arrays by name; time; contacts, (geom, geom, "
      "position).");
}
