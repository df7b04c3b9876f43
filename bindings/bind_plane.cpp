#include <cmath>
#include <sstream>

#include "common.hpp"
#include "zmpwalk/zmp/contact.hpp"

using namespace zmpwalk;

namespace {

/// A plane of the caller's, whose normal may have any length.
Plane checked_plane(const Vec3& normal, double offset) {
  const double length = normal.norm();
  if (!std::isfinite(length) || !std::isfinite(offset) || !(normal.z() > 0.0))
    throw InputError("normal = (" + std::to_string(normal.x()) + ", " + std::to_string(normal.y()) + ", " +
                     std::to_string(normal.z()) + "), offset = " + std::to_string(offset) +
                     " is no ground: both must be finite, and the normal must point up");
  return length == 1.0 ? Plane{normal, offset} : Plane{normal / length, offset / length};
}

}  // namespace

Side side_of(const std::string& name) {
  if (name == "left") return kLeft;
  if (name == "right") return kRight;
  throw InputError("support = '" + name + "' is unknown; there are: left, right");
}

void bind_plane(py::module_& m) {
  py::class_<Plane>(m, "Plane", "A plane in the world: the points p with normal . p = offset.")
      .def(py::init(&checked_plane), py::arg_v("normal", Vec3(Vec3::UnitZ()), "(0, 0, 1)"), "offset"_a = 0.0,
           "Level ground at z = 0 by default. A column zmp_plane gives both: Plane(row[:3], row[3]).\n\n"
           "Args:\n    normal: (3,), pointing up, of any length.\n    offset: normal . p of the plane's points p "
           "[m].\n\nRaises:\n    InputError: a number is not finite, or the normal does not point up.")
      .def_static(
          "through",
          [](const Vec3& p, const Vec3& normal) {
            const Vec3 n = checked_plane(normal, 0.0).normal;
            return checked_plane(n, n.dot(p));
          },
          "p"_a, py::arg_v("normal", Vec3(Vec3::UnitZ()), "(0, 0, 1)"),
          "The plane through `p` (3,) [m] with that normal; level by default.")
      .def_readonly("normal", &Plane::normal, "of length 1 (3,)")
      .def_readonly("offset", &Plane::offset, "distance from the world's origin along the normal [m]")
      .def("distance", &Plane::distance, "p"_a, "Distance of `p` (3,) from the plane, positive above it [m].")
      .def("project", &Plane::project, "p"_a, "The point of the plane that is nearest to `p` (3,) [m].")
      .def("height", &Plane::height, "xy"_a, "Height of the plane at world x and y `xy` (2,) [m].")
      .def(
          "__eq__", [](const Plane& a, const Plane& b) { return a == b; }, py::is_operator())
      .def("__repr__",
           [](const Plane& p) {
             std::ostringstream text;
             text << "Plane(normal=[" << p.normal.x() << ", " << p.normal.y() << ", " << p.normal.z()
                  << "], offset=" << p.offset << ")";
             return text.str();
           })
      .def(py::pickle([](const Plane& p) { return py::make_tuple(p.normal, p.offset); },
                      [](const py::tuple& t) { return Plane{t[0].cast<Vec3>(), t[1].cast<double>()}; }));
  py::class_<Contact>(m, "Contact",
                      "A foot on the ground: where its sole is, what it stands on, and how large and how rough it is.")
      .def(py::init([](const Vec3& p_WF, const Mat3& R_WF, bool standing, const Plane& ground, double length,
                       double width,
                       double friction) { return Contact{p_WF, R_WF, standing, ground, length, width, friction}; }),
           "p_WF"_a, "R_WF"_a, "standing"_a = true, py::arg_v("ground", Plane(), "Plane()"),
           py::arg_v("length", kNaN, "float('nan')"), py::arg_v("width", kNaN, "float('nan')"),
           py::arg_v("friction", kNaN, "float('nan')"),
           "Args:\n    p_WF: sole centre (3,) [m].\n    R_WF: sole axes (3, 3), x forward, z out of the ground.\n"
           "    standing: False where the foot swings.\n    ground: Plane under it.\n    length, width: of the sole "
           "[m]; NaN: unknown.\n    friction: tangential force per normal force that does not slip yet; NaN: unknown.")
      .def_readwrite("p_WF", &Contact::p_WF, "sole centre (3,) [m]")
      .def_readwrite("R_WF", &Contact::R_WF, "sole axes (3, 3)")
      .def_readwrite("standing", &Contact::standing, "False where the foot swings")
      .def_readwrite("ground", &Contact::ground, "Plane under it")
      .def_readwrite("length", &Contact::length, "of the sole along its x [m]")
      .def_readwrite("width", &Contact::width, "of the sole along its y [m]")
      .def_readwrite("friction", &Contact::friction, "tangential force per normal force that does not slip yet")
      .def("to_world", &Contact::to_world, "p_F"_a,
           "World x and y of the point of the sole that is `p_F` (2,) from its centre, sole axes (2,) [m].")
      .def("to_sole", &Contact::to_sole, "p"_a,
           "The point of the sole plane with world x and y `p` (2,), from the sole's centre, sole axes (2,) [m].")
      .def("cop", &Contact::cop, "f"_a,
           "Centre of pressure of a wrench (6,) about the sole's centre, world axes: from that centre, sole axes (2,) "
           "[m].")
      .def("can_carry", &Contact::can_carry, "f"_a,
           "True where the sole can give this wrench (6,), robot on ground: pressed, its centre of pressure on the "
           "sole, within friction.");
  m.def(
      "common_plane",
      [](const std::array<Contact, 2>& feet, const std::string& support) {
        return common_plane(feet, side_of(support));
      },
      "feet"_a, "support"_a,
      "Plane on which the ZMP of two feet is taken, through the support sole's centre.\n\n"
      "One standing foot: the ground under the support foot. Two: the plane that contains the line between the two "
      "places where they "
      "stand, and otherwise leans as the two grounds do on average.\n\n"
      "Args:\n    feet: Contact of the left and the right foot.\n    support: 'left' or 'right'.\n\nRaises:\n    "
      "InputError: support is neither.");
  m.def("zmp_on_plane", &zmp_on_plane, "F"_a, "M"_a, "s"_a, "plane"_a,
        "Eq. 14, 15 on any plane: the point of `plane` about which a wrench has a moment along its normal only (3,) "
        "[m].\n\n"
        "Args:\n    F: force (3,) [N].\n    M: moment about `s` (3,) [N m].\n    s: any point (3,) [m], world axes "
        "all.\n    plane: Plane.");
}
