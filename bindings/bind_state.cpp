#include "zmpwalk/robot/state.hpp"

#include "bind_tasks.hpp"

using namespace zmpwalk;

void bind_state(py::module_& m) {
  py::class_<PyState>(
      m, "State",
      "What a control cycle knows of the robot: measured, estimated, or read from a simulator. Plain numbers.\n\n"
      "`controller.state(data)` makes one from a simulator's data; with numbers from elsewhere, fill one in yourself.")
      .def(py::init([](double time, const VecX& q, const VecX& dq) {
             require_size("dq", dq.size(), q.size() - 1);
             PyState state(static_cast<int>(dq.size()));
             state.time = time;
             state.q = q;
             state.dq = dq;
             return state;
           }),
           "time"_a, "q"_a, "dq"_a,
           "Args:\n    time: [s].\n    q: base position (3) [m], base quaternion (w, x, y, z), joint positions [rad]: "
           "(nv + 1,).\n    dq: base velocity in the world's axes (3) [m/s], base angular velocity in the base's axes "
           "(3) [rad/s],\n        joint velocities [rad/s]: (nv,).\n\nRaises:\n    DimensionError: q does not have one "
           "number more than dq.\n\nUsage:\n    >>> out = controller.update(State(t, q, dq))\n")
      .def_readwrite("time", &PyState::time, "[s]")
      .def_readwrite("q", &PyState::q, "base position, base quaternion (w, x, y, z), joints (nv + 1,)")
      .def_readwrite("dq", &PyState::dq,
                     "base velocity (world's axes), base angular velocity (base's axes), joints (nv,)")
      .def_property(
          "wrench",
          [](const PyState& s) {
            Eigen::Matrix<double, 2, 6, Eigen::RowMajor> out;
            out << s.wrench[kLeft].transpose(), s.wrench[kRight].transpose();
            return out;
          },
          [](PyState& s, const Eigen::Matrix<double, 2, 6, Eigen::RowMajor>& wrench) {
            for (const Side side : kSides) s.wrench[side] = wrench.row(side);
          },
          "wrench of each foot on the ground, left and right, force then moment at the sole's centre, world's axes "
          "(2, 6)\n[N, N m]; NaN where it is not known")
      .def_property(
          "contact", [](const PyState& s) { return Vec2(s.contact[kLeft], s.contact[kRight]); },
          [](PyState& s, const Vec2& contact) { s.contact = {contact[0], contact[1]}; },
          "1 where a foot touches the ground, 0 where it does not, NaN where it is unknown; left and right (2,)")
      .def_readwrite(
          "external", &PyState::named,
          "known forces on the robot, {body or site: (6,) force and moment at its frame's origin, world's axes "
          "[N, N m]},\nor None")
      .def("__copy__", [](const PyState& s) { return PyState(s); })
      .def("__repr__", [](const PyState& s) {
        return "State(t = " + std::to_string(s.time) + " s, " + std::to_string(s.dq.size()) + " velocity coordinates)";
      });
}
