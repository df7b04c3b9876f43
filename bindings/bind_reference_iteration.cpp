#include "common.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

using namespace zmpwalk;

void bind_reference_iteration(py::module_& m) {
  py::class_<ReferenceResult>(m, "ReferenceResult",
                              "What III-B ends with: the reference ZMP for the pendulum, and how good it is.")
      .def_readonly("zmp_ref", &ReferenceResult::zmp_ref, "reference ZMP (2,) [m]")
      .def_readonly("zmp_est", &ReferenceResult::zmp_est, "estimated ZMP that it leads to (2,) [m]")
      .def_readonly("passes", &ReferenceResult::passes)
      .def_readonly("converged", &ReferenceResult::converged);
  using Estimate = std::function<Vec2(const Vec2&)>;
  m.def(
      "iterate_reference",
      [](const Estimate& estimate, const Vec2& zmp_des, double threshold, int max_passes) {
        return iterate_reference(estimate, zmp_des, zmp_des, Vec2::Ones(), threshold, max_passes);
      },
      "estimate"_a, "zmp_des"_a, "threshold"_a = 1e-3, "max_passes"_a = 200,
      "The loop of III-B: it adds r_des - r_est(r_ref) to the reference r_ref until the estimate is the desired "
      "ZMP.\n\nArgs:\n    estimate: callable, reference ZMP (2,) -> estimated ZMP (2,) [m].\n    "
      "zmp_des: (2,) [m].\n"
      "    threshold: largest difference that is good enough [m].");
  m.def(
      "solve_reference",
      [](const Estimate& estimate, const Vec2& zmp_des, const Mat2& slope, double threshold) {
        return solve_reference(estimate, zmp_des, zmp_des, Vec2::Ones(), slope, threshold);
      },
      "estimate"_a, "zmp_des"_a, "slope"_a, "threshold"_a = 1e-3,
      "Where the loop of `iterate_reference` ends, in closed form, for an estimate that is affine in the reference.");
}
