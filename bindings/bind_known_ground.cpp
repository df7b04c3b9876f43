#include "common.hpp"
#include "zmpwalk/gait/known_ground.hpp"

using namespace zmpwalk;

namespace {

/// (x_0, x_1, y_0, y_1, height, rise_x, rise_y) of each patch.
KnownGround of_patches(const RowMatX& rows) {
  if (rows.cols() != 7)
    throw InputError("a patch has seven numbers, (x_0, x_1, y_0, y_1, height, rise_x, rise_y); these have " +
                     std::to_string(rows.cols()));
  std::vector<GroundPatch> patches;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto r = rows.row(i);
    patches.push_back({Vec2(r[0], r[2]), Vec2(r[1], r[3]), r[4], Vec2(r[5], r[6])});
  }
  return KnownGround(std::move(patches));
}

RowMatX rows_of(const KnownGround& ground) {
  RowMatX out(static_cast<Eigen::Index>(ground.patches().size()), 7);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const GroundPatch& p = ground.patches()[static_cast<std::size_t>(i)];
    out.row(i) << p.lower.x(), p.upper.x(), p.lower.y(), p.upper.y(), p.height, p.rise.x(), p.rise.y();
  }
  return out;
}

}  // namespace

void bind_known_ground(py::module_& m) {
  py::class_<KnownGround>(
      m, "KnownGround",
      "Ground that the user knows: a height for each place, from plane patches or from heights on a "
      "grid.\n\nWhere patches overlap, the highest one counts. Between the points of a grid heights "
      "are bilinear. KnownGround() knows nothing.")
      .def(py::init<>())
      .def_static(
          "of_patches", &of_patches, "patches"_a,
          "Args:\n    patches: (n, 7), each (x_0, x_1, y_0, y_1, height, rise_x, rise_y): a rectangle along the "
          "world's axes [m], the\n        height of its middle [m], and how much higher it becomes per metre "
          "along x and along y.\n\nRaises:\n    InputError: a number is not finite, or a patch has no area.")
      .def_static(
          "of_grid",
          [](const Vec2& corner, double spacing, const RowMatX& heights) {
            return KnownGround(corner, spacing, heights);
          },
          "corner"_a, "spacing"_a, "heights"_a,
          "Args:\n    corner: world x and y of heights[0, 0] (2,) [m].\n    spacing: between points [m].\n    heights: "
          "rows along x, columns along y [m].\n\nRaises:\n    InputError: fewer than two rows or columns, a spacing "
          "that "
          "is not positive, a number that is not finite.")
      .def_property_readonly("patches", &rows_of, "the patches as `of_patches` takes them, (n, 7); none of a grid")
      .def_property_readonly("corner", &KnownGround::corner, "of a grid (2,) [m]")
      .def_property_readonly("spacing", &KnownGround::spacing, "of a grid [m]")
      .def_property_readonly(
          "heights", [](const KnownGround& g) { return RowMatX(g.heights()); }, "of a grid [m]; empty for patches")
      .def_property_readonly("known", &KnownGround::known, "whether anything is known")
      .def(
          "height", [](const KnownGround& g, const Vec2& p) { return g.at(p).height; }, "p"_a,
          "Height at world x and y `p` (2,) [m]; not-a-number where there is no ground.")
      .def(
          "rise", [](const KnownGround& g, const Vec2& p) { return g.at(p).rise; }, "p"_a,
          "How much higher the ground becomes per metre along x and along y, at world x and y `p` (2,).");
}
