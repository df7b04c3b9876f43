#include "common.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

using namespace zmpwalk;

void bind_reference_iteration(py::module_& m) {
  py::class_<ReferenceResult>(m, "ReferenceResult", "What III-B ends with.")
      .def_readonly("zmp_ref", &ReferenceResult::zmp_ref, "(2,) [m]")
      .def_readonly("zmp_est", &ReferenceResult::zmp_est, "(2,) [m]")
      .def_readonly("passes", &ReferenceResult::passes)
      .def_readonly("converged", &ReferenceResult::converged);
  using Estimate = std::function<Vec2(const Vec2&)>;
  m.def(
      "iterate_reference",
      [](const Estimate& estimate, const Vec2& zmp_des, double threshold, int max_passes) {
        return iterate_reference(estimate, zmp_des, zmp_des, Vec2::Ones(), threshold, max_passes);
      },
      "estimate"_a, "zmp_des"_a, "threshold"_a = 1e-3, "max_passes"_a = 200,
      "The loop of III-B: r_ref <- r_ref + r_des - r_est(r_ref).\n\nArgs:\n    estimate: callable (2,) -> (2,).\n    "
      "zmp_des: (2,) [m].\n"
      "    threshold: [m].");
  m.def(
      "solve_reference",
      [](const Estimate& estimate, const Vec2& zmp_des, const Mat2& slope, double threshold) {
        return solve_reference(estimate, zmp_des, zmp_des, Vec2::Ones(), slope, threshold);
      },
      "estimate"_a, "zmp_des"_a, "slope"_a, "threshold"_a = 1e-3,
      "The fixed point of that loop in closed form, for an affine estimate.");
}
