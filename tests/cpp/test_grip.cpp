#include <cmath>

#include "testing.hpp"
#include "zmpwalk/walk/grip.hpp"

// What the walk finds out about the friction under its feet.

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};
const SoleSize kSole{0.25, 0.14};
constexpr double kMass = 60.0, kWeight = kMass * 9.81, kBelieved = 1.0;
constexpr double kQuick = 0.2;  // [m/s], ten times as fast as soles that turn

WalkSettings feeling() {
  WalkSettings s;
  s.limits.feel_slip = true;
  return s;
}

/// A robot that stands on its left foot, whose force acts at a point of the sole.
struct Standing {
  Standing() : grip(resolve(feeling(), kRobot), kSole, kRobot.com_height, 9.81, kBelieved), dynamics(6) {
    dynamics.mass = kMass;
    gait.support = kLeft;
    grip.reset();
  }
  /// Robot on ground: weight and the force `along` at `at`, with the moment `twist` about that point.
  void push(const Vec2& along, const Vec2& at = Vec2::Zero(), double twist = 0.0) {
    wrench << along, -kWeight, -at.y() * kWeight, at.x() * kWeight, at.x() * along.y() - at.y() * along.x() + twist;
  }
  void move(const Vec2& along, double turn = 0.0) { dynamics.sole[kLeft].velocity << along, 0, 0, 0, turn; }
  /// Whether the friction has changed meanwhile.
  bool run(double time) {
    Vec12 asked = Vec12::Zero();
    asked.head<6>() = wrench;  // of the left foot
    bool changed = false;
    for (int k = 0; k < std::lround(time / 0.001); ++k) changed |= grip.update(gait, dynamics, asked);
    return changed;
  }

  Grip grip;
  Dynamics dynamics;
  GaitOutput gait;
  Vec6 wrench = Vec6::Zero();
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_foot_that_slides_holds_less_than_what_was_asked_of_it) {
  Standing on;
  on.push({0.1 * kWeight, 0.0});
  on.move({kQuick, 0.0});
  BOOST_CHECK(on.run(0.1));
  CHECK_NEAR(on.grip.friction(kLeft), 0.65 * 0.1, 1e-12);
  CHECK_NEAR(on.grip.friction(kRight), kBelieved, 0.0);
  BOOST_CHECK_LT(on.grip.pace(), 0.5);
}

BOOST_AUTO_TEST_CASE(a_sole_that_turns_about_the_point_of_its_force_does_not_slip) {
  Standing on;
  const Vec2 at(0.08, 0.03);
  const double turn = 2.0;
  on.push({0.05 * kWeight, 0.0}, at, 0.02 * kWeight * kSole.length);
  on.move(turn * Vec2(at.y(), -at.x()), turn);
  BOOST_CHECK(!on.run(0.3));
  on.move(turn * Vec2(at.y(), -at.x()) + Vec2(kQuick, 0.0), turn);
  BOOST_CHECK(on.run(0.1));
}

BOOST_AUTO_TEST_CASE(a_sole_that_moves_under_half_of_the_believed_friction_tells_nothing_new) {
  Standing on;
  on.push({0.0, 0.55 * kWeight});
  on.move({kQuick, 0.0});
  BOOST_CHECK(!on.run(0.3));
  // Its twist counts as well: r is half the sole's diagonal.
  const double r = 0.5 * std::hypot(kSole.length, kSole.width);
  on.push({0.3 * kWeight, 0.0}, Vec2::Zero(), 0.25 * r * kWeight);
  BOOST_CHECK(!on.run(0.3));
  on.push({0.3 * kWeight, 0.0}, Vec2::Zero(), 0.15 * r * kWeight);
  BOOST_CHECK(on.run(0.1));
  CHECK_NEAR(on.grip.friction(), 0.65 * 0.45, 1e-12);
}

BOOST_AUTO_TEST_CASE(what_was_lost_is_believed_again_after_a_while) {
  Standing on;
  on.push({0.1 * kWeight, 0.0});
  on.move({kQuick, 0.0});
  on.run(0.1);
  on.move({0.0, 0.0});
  on.run(3.0);
  BOOST_CHECK_GT(on.grip.friction(), 0.2);
  BOOST_CHECK_LT(on.grip.friction(), 0.5);
  on.run(120.0);
  CHECK_NEAR(on.grip.friction(), kBelieved, 0.0);
  CHECK_NEAR(on.grip.pace(), 1.0, 0.0);
}
