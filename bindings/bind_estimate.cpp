#include "common.hpp"
#include "zmpwalk/zmp/bounds.hpp"
#include "zmpwalk/zmp/estimate.hpp"

using namespace zmpwalk;

void bind_estimate(py::module_& m) {
  py::class_<ZmpEstimate>(m, "ZmpEstimate", "What a torque will do to the ground.")
      .def_readonly("zmp", &ZmpEstimate::zmp, "world x and y, on the common plane of the feet (2,) [m]")
      .def_readonly("f_c", &ZmpEstimate::f_c, "robot on ground, left then right (12,), NaN in the air")
      .def_readonly("in_contact", &ZmpEstimate::in_contact,
                    "Whether the ground carries: without load there is no ZMP.");
  py::class_<ZmpEstimator>(
      m, "ZmpEstimator",
      "Estimates the ZMP that a torque will produce, before it is sent (eq. 9-15), with one or two standing feet.")
      .def(py::init<int>(), "nv"_a)
      .def(
          "update",
          [](ZmpEstimator& e, const Eigen::Ref<const RowMatX>& A, const VecX& b, const VecX& g,
             const Eigen::Ref<const RowMatX>& J_c, const VecX& drift_c, const std::array<bool, 2>& standing,
             const std::array<Vec3, 2>& soles, const std::string& support, const std::array<Plane, 2>& ground) {
            const long rows = 6 * (standing[kLeft] + standing[kRight]);
            require_shape("J_c", J_c.rows(), J_c.cols(), rows, J_c.cols());
            std::array<Contact, 2> feet;
            for (const Side side : kSides) {
              feet[side].p_WF = soles[side];
              feet[side].standing = standing[side];
              feet[side].ground = ground[side];
            }
            e.update(A, b, g, J_c, drift_c, feet, side_of(support));
          },
          "A"_a, "b"_a, "g"_a, "J_c"_a, "drift_c"_a, "standing"_a, "soles"_a, "support"_a,
          py::arg_v("ground", std::array<Plane, 2>{}, "(Plane(), Plane())"),
          "Takes the state of one instant; after that, `estimate` works for any torque.\n\nArgs:\n    A (nv, nv), b, g "
          "(nv,): inertia, velocity and gravity terms.\n"
          "    J_c (6 k, nv), drift_c (6 k,): of the k standing feet, left before right.\n    standing: (left, "
          "right).\n"
          "    soles: sole centres in W (2, 3) [m].\n    support: foot whose sole centre the plane of the ZMP "
          "contains.\n"
          "    ground: Plane under the left and the right foot; level by default.\n\nRaises:\n    DimensionError, "
          "InputError.")
      .def_property_readonly(
          "zmp_plane", [](const ZmpEstimator& e) { return e.zmp_plane(); },
          "plane on which the ZMP is taken: common_plane of the feet")
      .def("estimate", &ZmpEstimator::estimate, "tau"_a,
           "ZMP and wrenches that the joint torque (joints,) [N m] will produce.");
  m.def("zmp_of_wrench", &zmp_of_wrench, "F"_a, "M"_a,
        "Eq. 14, 15 on the level plane through the point about which M is taken, from that point: (-M_y / F_z, M_x / "
        "F_z) "
        "(2,) [m].");
  m.def(
      "zmp_bounds",
      [](double length, double width, const Vec2& ankle, double pitch_torque, double roll_torque, double weight,
         double sole_fraction, double torque_fraction) {
        const ZmpBounds b =
            zmp_bounds({length, width, ankle, pitch_torque, roll_torque}, weight, sole_fraction, torque_fraction);
        return std::make_pair(b.lower, b.upper);
      },
      "length"_a, "width"_a, "ankle"_a, "pitch_torque"_a, "roll_torque"_a, "weight"_a, "sole_fraction"_a = 0.72,
      "torque_fraction"_a = 0.9,
      "Bounds of the ZMP in one sole, from its size and the torque of the ankle: (lower, upper) about the sole's "
      "centre, "
      "each (2,) [m].");
}
