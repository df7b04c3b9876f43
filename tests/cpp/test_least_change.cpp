#include "zmpwalk/control/least_change.hpp"

#include <Eigen/LU>

#include "testing.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// The row of these entries; the others are zero.
LeastChange::Row row(const Eigen::RowVectorXd& entries) {
  LeastChange::Row out = LeastChange::Row::Zero();
  out.head(entries.size()) = entries;
  return out;
}

/// A random problem that has a solution: each row holds at some point, a few do not at y = 0.
struct Problem {
  Problem(unsigned seed, int unknowns, int rows) : C(rows, unknowns), c(rows) {
    Numbers numbers(seed);
    const VecX inside = numbers.vector(unknowns, 1.0);
    for (int i = 0; i < rows; ++i) {
      C.row(i) = numbers.vector(unknowns, 1.0).transpose();
      c[i] = numbers.uniform(0.0, 1.0) - C.row(i).dot(inside);
    }
  }
  void write(LeastChange& least) const {
    least.begin();
    for (Eigen::Index i = 0; i < C.rows(); ++i) least.add(c[i], row(C.row(i)));
  }

  RowMatX C;
  VecX c;
};

}  // namespace

BOOST_AUTO_TEST_CASE(without_a_broken_row_nothing_changes) {
  LeastChange least;
  least.add(1.0, row(Eigen::RowVector2d(1.0, 2.0)));
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y(), LeastChange::Y::Zero(), 0.0);
  BOOST_CHECK(!least.is_active(0));
}

BOOST_AUTO_TEST_CASE(one_broken_row_is_met_along_its_normal) {
  // -3 + y_1 + 2 y_2 >= 0: the foot of the perpendicular from the origin is (3, 6) / 5.
  LeastChange least;
  least.add(-3.0, row(Eigen::RowVector2d(1.0, 2.0)));
  least.add(5.0, row(Eigen::RowVector2d(-1.0, 0.0)));
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y().head<2>(), Vec2(0.6, 1.2), 1e-12);
  CHECK_NEAR(least.y().tail<11>(), VecX::Zero(11), 0.0);
  BOOST_CHECK(least.is_active(0) && !least.is_active(1));
}

BOOST_AUTO_TEST_CASE(random_problems_meet_the_conditions_of_a_minimum) {
  // Karush, Kuhn, Tucker: all rows hold; y is a sum of active rows, whose weights are not negative. The problem is convex: that suffices.
  LeastChange least;
  int most = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const int unknowns = 2 + static_cast<int>(seed % 12), rows = 20 + static_cast<int>(seed % 71);
    const Problem problem(seed, unknowns, rows);
    problem.write(least);
    BOOST_REQUIRE_MESSAGE(least.solve(), "seed " << seed);
    const VecX y = least.y().head(unknowns), room = problem.c + problem.C * y;
    BOOST_CHECK_GE(room.minCoeff(), -1e-7);
    std::vector<int> active;
    for (int i = 0; i < rows; ++i)
      if (least.is_active(i)) active.push_back(i);
    MatX N(unknowns, static_cast<Eigen::Index>(active.size()));
    for (std::size_t k = 0; k < active.size(); ++k) {
      N.col(static_cast<Eigen::Index>(k)) = problem.C.row(active[k]).transpose();
      BOOST_CHECK_SMALL(room[active[k]], 1e-9);
    }
    if (active.empty()) {
      CHECK_NEAR(y, VecX::Zero(unknowns), 0.0);
      continue;
    }
    const VecX weights = N.fullPivLu().solve(y);
    CHECK_NEAR(N * weights, y, 1e-8);
    BOOST_CHECK_GE(weights.minCoeff(), -1e-9);
    most = std::max(most, least.passes());
  }
  BOOST_CHECK_LT(most, LeastChange::kPasses / 2);
}

BOOST_AUTO_TEST_CASE(contradictory_rows_are_reported) {
  LeastChange least;
  const LeastChange::Row first = row(Eigen::RowVector3d(1.0, 0.0, 0.0));
  least.add(-1.0, first);   // y_1 >= 1
  least.add(-1.0, -first);  // y_1 <= -1
  BOOST_CHECK(!least.solve());
  least.begin();
  least.add(-1.0, first);
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y().head<3>(), Vec3(1, 0, 0), 1e-12);
}

BOOST_AUTO_TEST_CASE(too_many_rows_are_refused) {
  LeastChange least;
  for (int i = 0; i < LeastChange::kRows; ++i) least.add(1.0, LeastChange::Row::Zero());
  BOOST_CHECK_THROW(least.add(1.0, LeastChange::Row::Zero()), InputError);
}
