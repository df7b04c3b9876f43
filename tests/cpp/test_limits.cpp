#include "zmpwalk/control/limits.hpp"

#include "instant.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/zmp/estimate.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr SoleGrip kSole{0.25, 0.14, 0.6};
constexpr double kWeight = 600.0;

/// Ample limits of the robot at an instant: nothing holds it back.
RobotLimits ample(const Robot& robot) {
  RobotLimits limits;
  limits.torque = VecX::Constant(robot.joints(), 1e6);
  limits.range.assign(static_cast<std::size_t>(robot.joints()), {-100.0, 100.0});
  limits.sole = {SoleGrip{100.0, 100.0, 100.0}, SoleGrip{100.0, 100.0, 100.0}};
  limits.weight = robot.dynamics().mass * 9.81;
  limits.height = 0.747;
  limits.range_rate = 100.0;
  return limits;
}

/// The closed form at an instant, and what it becomes within limits.
struct Kept {
  Kept(const Instant& at, const RobotLimits& limits)
      : controller(at.robot.nv(), at.robot.leg_joints()), before(controller.result()) {
    controller.prepare(at.dyn(), at.stance, at.f);
    controller.solve(at.f.com.head<2>(), before);
    after = before;
    keeper = std::make_unique<LimitKeeper>(limits, controller);
    possible = keeper->keep(at.dyn(), at.stance, after);
  }

  WholeBodyController controller;
  WholeBodyResult before, after;
  std::unique_ptr<LimitKeeper> keeper;
  bool possible;
};

void satisfies_the_equations(const Instant& at, const WholeBodyResult& out) {
  const VecX f_c = at.stance.both() ? VecX(out.f_c) : VecX(out.f_c.segment<6>(at.stance.standing[kLeft] ? 0 : 6));
  CHECK_NEAR(at.dyn().A * out.ddq + at.h() + at.J_c.transpose() * f_c, at.applied(out.tau), 1e-6);
  CHECK_NEAR(at.J_c * out.ddq + at.drift_c, VecX::Zero(at.J_c.rows()), 1e-6);
}

}  // namespace

BOOST_AUTO_TEST_CASE(wrench_of_corners_that_press_within_their_friction_is_within_the_rows) {
  const SoleRows rows = sole_rows(kSole, kWeight);
  const double X = 0.5 * kSole.length, Y = 0.5 * kSole.width, k = kSole.friction * std::hypot(X, Y) / (X + Y);
  Numbers numbers(1);
  for (int n = 0; n < 2000; ++n) {
    Vec6 f = Vec6::Zero();
    for (const double x : {X, -X})
      for (const double y : {Y, -Y}) {
        const double f_z = numbers.uniform(0.0, 1.0) < 0.5 ? 0.0 : numbers.uniform(0.0, 300.0);
        // Within the octagon of the circle, and within the corner's square of side 2 k.
        const Vec2 side = numbers.vector(2, std::min(k, kSole.friction * std::sqrt(0.5) * 0.92)) * f_z;
        const Vec3 force(side.x(), side.y(), f_z);
        f.head<3>() += force;
        f.tail<3>() += Vec3(x, y, 0.0).cross(force);
      }
    BOOST_CHECK_GE((rows * f).minCoeff(), -1e-12);
  }
}

BOOST_AUTO_TEST_CASE(rows_end_where_the_sole_does) {
  const SoleRows rows = sole_rows(kSole, kWeight);
  const double X = 0.5 * kSole.length, Y = 0.5 * kSole.width, mu = kSole.friction, N = 500.0;
  const auto least = [&](const Vec6& f, SoleLimit limit) {
    double room = 1e9;
    for (int i = 0; i < kSoleRows; ++i)
      if (sole_limit(i) == limit) room = std::min(room, rows.row(i).dot(f));
    return room;
  };
  const auto wrench = [](double f_x, double f_y, double f_z, double m_x, double m_y, double m_z) {
    return (Vec6() << f_x, f_y, f_z, m_x, m_y, m_z).finished();
  };
  BOOST_CHECK_LT(least(wrench(0, 0, -1, 0, 0, 0), SoleLimit::kLoad), 0.0);
  const double edge = mu * N * std::cos(M_PI / 8.0);  // of the octagon
  BOOST_CHECK_SMALL(least(wrench(edge, 0, N, 0, 0, 0), SoleLimit::kFriction), 1e-12);
  BOOST_CHECK_LT(least(wrench(0, -1.01 * edge, N, 0, 0, 0), SoleLimit::kFriction), 0.0);
  BOOST_CHECK_SMALL(least(wrench(0, 0, N, Y * N, 0, 0), SoleLimit::kCop), 1e-12);
  BOOST_CHECK_LT(least(wrench(0, 0, N, 0, -1.01 * X * N, 0), SoleLimit::kCop), 0.0);
  // A pure twist: every corner on its circle.
  const double twist = mu * N * std::hypot(X, Y);
  BOOST_CHECK_SMALL(least(wrench(0, 0, N, 0, 0, -twist), SoleLimit::kYaw), 1e-12);
  BOOST_CHECK_LT(least(wrench(0, 0, N, 0, 0, 1.01 * twist), SoleLimit::kYaw), 0.0);
  // With all load in one corner there is no couple left.
  BOOST_CHECK_LT(least(wrench(0, 0, N, Y * N, -X * N, 0.01 * twist), SoleLimit::kYaw), 0.0);
}

BOOST_AUTO_TEST_CASE(sole_without_size_or_friction_is_refused) {
  BOOST_CHECK_THROW(sole_rows({0.0, 0.1, 1.0}, 1.0), InputError);
  BOOST_CHECK_THROW(sole_rows({0.1, 0.1, 0.0}, 1.0), InputError);
  BOOST_CHECK_THROW(sole_rows({0.1, 0.1, 1.0}, kNaN), InputError);
}

BOOST_AUTO_TEST_CASE(torque_within_its_limits_keeps_every_bit) {
  everywhere([](const Instant& at) {
    const Kept kept(at, ample(at.robot));
    BOOST_CHECK(kept.possible);
    BOOST_CHECK(kept.after.tau == kept.before.tau && kept.after.ddq == kept.before.ddq);
    BOOST_CHECK(!kept.keeper->active().any());
  });
}

BOOST_AUTO_TEST_CASE(what_gives_changes_motion_wrench_and_torque_as_the_tasks_do) {
  // Two routes: the columns of the slack, and the closed form for tasks that differ by as much.
  everywhere([](const Instant& at) {
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult now = controller.result(), changed = now, asked = now;
    TaskGive give;
    give.load_force = 50.0;
    controller.prepare(at.dyn(), at.stance, at.f);
    controller.solve(at.f.com.head<2>(), now);
    TaskSlack slack(at.robot.nv());
    controller.slack(give, now, slack);
    const LimitKeeper::Change y = Numbers(3).vector(TaskSlack::kColumns, 1.0);
    changed = now;
    controller.apply(slack, y, changed);
    satisfies_the_equations(at, changed);

    TaskAccelerations f = at.f;
    const bool swings = !at.stance.both();
    f.com += Vec3(give.com * y[0], give.com * y[1], give.height * y[2]);
    f.trunk += give.trunk * y.segment<3>(3);
    if (swings) f.swing += (Vec6() << give.swing * y.segment<3>(6), give.swing_angular * y.segment<3>(9)).finished();
    for (const Side side : kSides)
      for (int i = 0; i < 6; ++i) {
        const int j = at.robot.leg_joints()[side][static_cast<std::size_t>(i)];
        BOOST_CHECK_SMALL(now.ddq[6 + j] + slack.leg_ddq.row(6 * side + i) * y - changed.ddq[6 + j], 1e-9);
        BOOST_CHECK_SMALL(now.tau[j] + slack.leg_tau.row(6 * side + i) * y - changed.tau[j], 1e-9);
      }
    controller.prepare(at.dyn(), at.stance, f);
    controller.solve(f.com.head<2>(), asked);
    CHECK_NEAR(changed.ddq, asked.ddq, 1e-8);
    if (swings) CHECK_NEAR(changed.tau, asked.tau, 1e-7);
    CHECK_NEAR(controller.zmp_of(changed.f_c), controller.zmp(f.com.head<2>()), 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(torques_are_kept_within_limits_that_the_closed_form_breaks) {
  int held = 0, possible = 0;
  everywhere([&](const Instant& at) {
    RobotLimits limits = ample(at.robot);
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, at.f);
    controller.solve(at.f.com.head<2>(), out);
    // Three quarters of what the hardest leg joints are asked for.
    for (const auto& leg : at.robot.leg_joints())
      for (const int j : leg) limits.torque[j] = 20.0 + 0.75 * std::abs(out.tau[j]);
    const Kept kept(at, limits);
    possible += kept.possible;
    if (!kept.possible) {
      BOOST_CHECK(kept.after.tau == kept.before.tau);
      return;
    }
    BOOST_CHECK((kept.after.tau.array().abs() <= limits.torque.array()).all());
    satisfies_the_equations(at, kept.after);
    held += kept.keeper->active().torques != 0;
    // The estimate of (9)-(15) speaks of this torque.
    ZmpEstimator estimator(at.robot.nv());
    estimator.update(at.dyn().A, at.dyn().b, at.dyn().g, at.J_c, at.drift_c, kept.controller.feet(), at.stance.support);
    CHECK_NEAR(estimator.estimate(kept.after.tau).zmp, kept.controller.zmp_of(kept.after.f_c), 1e-7);
  });
  BOOST_CHECK_GE(possible, 55);
  BOOST_CHECK_GE(held, 30);
}

BOOST_AUTO_TEST_CASE(soles_are_kept_within_what_they_can_hold) {
  int held = 0, exactly = 0;
  everywhere([&](const Instant& at) {
    RobotLimits limits = ample(at.robot);
    limits.sole = {SoleGrip{0.25, 0.14, 0.5}, SoleGrip{0.25, 0.14, 0.5}};
    const Kept kept(at, limits);
    if (!kept.possible) return;
    satisfies_the_equations(at, kept.after);
    held += kept.keeper->active().feet != 0;
    exactly += kept.keeper->active().feet != 0 && kept.keeper->excess() < 1e-5;
    for (const Side side : kSides) {
      if (!at.stance.standing[side]) continue;
      const Mat3& R = at.dyn().sole[side].R_WF;
      Vec6 f;
      f << -R.transpose() * kept.after.f_c.segment<3>(6 * side),
          -R.transpose() * kept.after.f_c.segment<3>(6 * side + 3);
      BOOST_CHECK_GE((sole_rows(limits.sole[side], limits.weight) * f).minCoeff(), -kept.keeper->excess() - 1e-6);
    }
  });
  BOOST_CHECK_GE(held, 30);
  BOOST_CHECK_GE(exactly, 25);
}

BOOST_AUTO_TEST_CASE(joint_at_the_end_of_its_range_is_braked) {
  for (const Standing standing : {Standing::kLeft, Standing::kRight}) {
    Instant at(standing, 2);
    RobotLimits limits = ample(at.robot);
    const int knee = at.robot.leg_joints()[at.stance.swing()][3];
    const double q = at.dyn().q[knee], dq = at.dyn().dq[6 + knee];
    limits.range[static_cast<std::size_t>(knee)] = {-10.0, q + 0.01};
    at.f.swing[2] += 60.0;  // the foot is to come up
    const Kept kept(at, limits);
    BOOST_REQUIRE(kept.possible);
    const double most = limits.range_rate * (0.25 * limits.range_rate * 0.01 - dq);
    BOOST_CHECK_GT(kept.before.ddq[6 + knee], most);
    BOOST_CHECK_CLOSE(kept.after.ddq[6 + knee], most, 1e-6);
    BOOST_CHECK_EQUAL(kept.keeper->active().ranges, std::int64_t{1} << knee);
    BOOST_CHECK_EQUAL(kept.keeper->active().names(at.robot.joint_names()).front(),
                      "range of " + at.robot.joint_names()[knee]);
  }
}

BOOST_AUTO_TEST_CASE(what_counts_less_gives_first) {
  // A weak hip in the swing: foot and trunk give more, each in its size, than the COM's horizontal acceleration.
  int held = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Instant at(Standing::kLeft, seed);
    RobotLimits limits = ample(at.robot);
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, at.f);
    controller.solve(at.f.com.head<2>(), out);
    const int hip = at.robot.leg_joints()[kRight][2];
    limits.torque[hip] = 0.7 * std::abs(out.tau[hip]);
    const Kept kept(at, limits);
    BOOST_REQUIRE(kept.possible && kept.keeper->active().torques == std::int64_t{1} << hip);
    const LimitKeeper::Change& y = kept.keeper->change();
    const TaskGive& give = kept.keeper->give();
    BOOST_CHECK_LT(give.com * y.head<2>().norm(), 0.05 * give.swing * y.segment<3>(6).norm());
    ++held;
  }
  BOOST_CHECK_EQUAL(held, kSeeds);
}

BOOST_AUTO_TEST_CASE(where_no_motion_keeps_all_limits_the_soles_give_and_the_torques_do_not) {
  const Instant at(Standing::kLeft, 0);
  RobotLimits limits = ample(at.robot);
  limits.torque.setConstant(1e-3);
  limits.sole = {SoleGrip{0.25, 0.14, 0.5}, SoleGrip{0.25, 0.14, 0.5}};
  const Kept kept(at, limits);
  BOOST_REQUIRE(kept.possible);
  BOOST_CHECK_GE(kept.keeper->excess(), 0.0);
  for (const auto& leg : at.robot.leg_joints())
    for (const int j : leg) BOOST_CHECK_LE(std::abs(kept.after.tau[j]), 1e-3);
  satisfies_the_equations(at, kept.after);
}
