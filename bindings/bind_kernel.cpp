#include "common.hpp"
#include "zmpwalk/control/kernel_choice.hpp"

using namespace zmpwalk;

void bind_kernel(py::module_& m) {
  m.def(
      "build_info",
      [] {
        py::list names;
        for (const Kernel* each : kernels()) names.append(each->name);
        py::dict out;
        out["version"] = ZMPWALK_VERSION;
        out["mujoco"] = py::module_::import("zmpwalk._core").attr("mujoco_version")();
        out["compiler"] =
#ifdef __clang__
            "Clang " __clang_version__;
#else
            "GCC " __VERSION__;
#endif
        out["kernels"] = names;
        out["kernel"] = kernel().name;
        return out;
      },
      "How this copy was built, and what it runs here.\n\n"
      "Returns:\n    dict: version, mujoco (connected with), compiler, kernels (builds of the inner loops that this "
      "processor runs),\n    kernel (the one that 'auto' takes).\n\n"
      "Usage:\n    >>> zmpwalk.build_info()['kernel']");
}
