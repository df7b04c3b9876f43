#include "zmpwalk/control/least_change.hpp"

#include <Eigen/LU>

#include "testing.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

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
    least.begin(static_cast<int>(C.cols()));
    for (Eigen::Index i = 0; i < C.rows(); ++i) {
      const int row = least.add(c[i]);
      least.row(row) = C.row(i);
    }
  }

  RowMatX C;
  VecX c;
};

}  // namespace

BOOST_AUTO_TEST_CASE(without_a_broken_row_nothing_changes) {
  LeastChange least(3);
  least.begin(2);
  least.row(least.add(1.0)) << 1.0, 2.0;
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y(), Vec2(0, 0), 0.0);
  BOOST_CHECK(!least.is_active(0));
}

BOOST_AUTO_TEST_CASE(one_broken_row_is_met_along_its_normal) {
  // -3 + y_1 + 2 y_2 >= 0: the foot of the perpendicular from the origin is (3, 6) / 5.
  LeastChange least(3);
  least.begin(2);
  least.row(least.add(-3.0)) << 1.0, 2.0;
  least.row(least.add(5.0)) << -1.0, 0.0;
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y(), Vec2(0.6, 1.2), 1e-12);
  BOOST_CHECK(least.is_active(0) && !least.is_active(1));
}

BOOST_AUTO_TEST_CASE(random_problems_meet_the_conditions_of_a_minimum) {
  // Karush, Kuhn, Tucker: all rows hold; y is a sum of active rows, whose weights are not negative. The problem is convex: that suffices.
  LeastChange least(200);
  int most = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const int unknowns = seed % 2 ? 2 + static_cast<int>(seed % 11) : 13 + static_cast<int>(seed % 12),
              rows = 20 + static_cast<int>(seed % 108);
    const Problem problem(seed, unknowns, rows);
    problem.write(least);
    BOOST_REQUIRE_MESSAGE(least.solve(), "seed " << seed);
    const VecX y = least.y(), room = problem.c + problem.C * y;
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
  LeastChange least(4);
  least.begin(3);
  least.row(least.add(-1.0)) << 1.0, 0.0, 0.0;   // y_1 >= 1
  least.row(least.add(-1.0)) << -1.0, 0.0, 0.0;  // y_1 <= -1
  BOOST_CHECK(!least.solve());
  least.begin(3);
  least.row(least.add(-1.0)) << 1.0, 0.0, 0.0;
  BOOST_CHECK(least.solve());
  CHECK_NEAR(least.y(), Vec3(1, 0, 0), 1e-12);
}

BOOST_AUTO_TEST_CASE(too_many_unknowns_or_rows_are_refused) {
  LeastChange least(1);
  BOOST_CHECK_THROW(least.begin(0), InputError);
  BOOST_CHECK_THROW(least.begin(LeastChange::kMost + 1), InputError);
  least.begin(2);
  least.add(1.0);
  BOOST_CHECK_THROW(least.add(1.0), InputError);
}
