#include "common.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/control/wrench_distribution.hpp"

using namespace zmpwalk;

namespace {

/// Keeps the Dynamics it was last prepared with, which the core only points to.
struct PyWholeBody : WholeBodyController {
  using WholeBodyController::WholeBodyController;
  py::object dynamics;
};

}  // namespace

void bind_whole_body(py::module_& m) {
  py::class_<TaskAccelerations>(m, "TaskAccelerations", "Commanded accelerations f* of the walk's own tasks.")
      .def(py::init([](const Vec3& com, const Vec3& trunk, const Vec6& swing, const VecX& posture) {
             return TaskAccelerations{com, trunk, swing, posture};
           }),
           "com"_a, "trunk"_a, "swing"_a, "posture"_a)
      .def_readwrite("com", &TaskAccelerations::com, "of the COM (3,) [m/s^2]")
      .def_readwrite("trunk", &TaskAccelerations::trunk, "of the trunk's orientation (3,), world axes [rad/s^2]")
      .def_readwrite("swing", &TaskAccelerations::swing, "of the swing sole (6,), linear then angular, world axes")
      .def_readwrite("posture", &TaskAccelerations::posture,
                     "of the joints (joints,); entries of leg joints are not used");
  py::class_<WholeBodyResult>(m, "WholeBodyResult", "Torque, motion and contact wrenches.")
      .def_readonly("tau", &WholeBodyResult::tau, "(joints,) [N m]")
      .def_readonly("ddq", &WholeBodyResult::ddq, "(nv,)")
      .def_readonly("f_c", &WholeBodyResult::f_c, "robot on ground, left then right (12,), NaN in the air")
      .def_readonly("damped", &WholeBodyResult::damped,
                    "whether the motion was damped, since a leg was nearly straight");
  py::class_<PyWholeBody>(
      m, "WholeBodyController",
      "Computes the joint torques of a biped that give COM, trunk, swing foot and posture their commanded "
      "accelerations "
      "while the standing feet keep still (eq. 1-7).\n\n"
      "Everything is affine in the COM's horizontal acceleration: after one prepare(), zmp() and solve() cost next to "
      "nothing for each acceleration.")
      .def(py::init([](int nv, const std::array<std::vector<int>, 2>& legs, bool textbook, bool posture_task,
                       bool wrench_distribution, double contact_damping) {
             WholeBodyOptions options;
             options.textbook = textbook;
             options.posture_task = posture_task;
             options.wrench_distribution = wrench_distribution;
             options.contact_damping = contact_damping;
             return std::make_unique<PyWholeBody>(nv, legs, options);
           }),
           "nv"_a, "legs"_a, py::kw_only(), "textbook"_a = false, "posture_task"_a = true,
           "wrench_distribution"_a = true, "contact_damping"_a = 0.0,
           "Args:\n    nv: velocity coordinates.\n    legs: joint indices of the two legs, six each.\n"
           "    textbook: equations as printed instead of the direct path; the same numbers.\n\nRaises:\n    "
           "DimensionError.")
      .def(
          "prepare",
          [](PyWholeBody& c, const py::object& dynamics, const std::array<bool, 2>& standing,
             const std::string& support, const TaskAccelerations& f_star, const std::array<Plane, 2>& ground) {
            Stance stance;
            stance.standing = standing;
            stance.support = side_of(support);
            if ((standing[kLeft] || standing[kRight]) && !standing[stance.support])
              throw InputError("support = '" + support + "' does not stand");
            stance.ground = ground;
            c.prepare(dynamics.cast<const Dynamics&>(), stance, f_star);
            c.dynamics = dynamics;
          },
          "dynamics"_a, "standing"_a, "support"_a, "f_star"_a,
          py::arg_v("ground", std::array<Plane, 2>{}, "(Plane(), Plane())"),
          "Takes one instant.\n\nArgs:\n    dynamics: Dynamics.\n    standing: (left, right).\n    support: 'left' or "
          "'right', about which the ZMP is taken.\n"
          "    f_star: TaskAccelerations; com's x and y are not used here.\n"
          "    ground: Plane under the left and the right foot; level by default.\n\nRaises:\n    InputError: no foot "
          "stands. "
          "DimensionError.")
      .def(
          "zmp", [](const PyWholeBody& c, const Vec2& f_xy) { return c.zmp(f_xy); }, "f_xy"_a,
          "World x and y of the ZMP on zmp_plane (2,) [m] for horizontal COM acceleration (2,) [m/s^2]; affine on a "
          "level "
          "plane.")
      .def_property_readonly(
          "zmp_plane", [](const PyWholeBody& c) { return c.zmp_plane(); }, "plane on which the ZMP is taken")
      .def_property_readonly(
          "feet", [](const PyWholeBody& c) { return c.feet(); }, "Contact of the left and the right foot, as prepared")
      .def(
          "yaw_moment", [](const PyWholeBody& c, const Vec2& f_xy) { return c.yaw_moment(f_xy); }, "f_xy"_a,
          "Vertical moment of the ground on the robot about its COM, d/dt L_z, for COM acceleration (2,) [N m].")
      .def_property_readonly(
          "zmp_slope", [](const PyWholeBody& c) { return c.zmp_slope(); },
          "d zmp / d f_xy (2, 2) [s^2], on a tilted plane at f_xy = 0")
      .def(
          "solve",
          [](const PyWholeBody& c, const Vec2& f_xy) {
            WholeBodyResult out = c.result();
            c.solve(f_xy, out);
            return out;
          },
          "f_xy"_a, "Torque for horizontal COM acceleration (2,) [m/s^2].");
  m.def(
      "distribute_wrench", &distribute_wrench, "F"_a, "M_P"_a, "P"_a, "c"_a, "along"_a, "alone"_a = 0.0,
      "Shares a total wrench (F, M about P) between two feet with sole centres c, exactly, whatever their heights and "
      "tilts; (12,).");
}
