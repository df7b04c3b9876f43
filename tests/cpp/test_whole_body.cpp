#include "instant.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/control/wrench_distribution.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

BOOST_AUTO_TEST_CASE(direct_path_is_the_textbook_path) {
  everywhere([](const Instant& at) {
    WholeBodyOptions textbook;
    textbook.textbook = true;
    WholeBodyController direct(at.robot.nv(), at.robot.leg_joints()),
        printed(at.robot.nv(), at.robot.leg_joints(), textbook);
    WholeBodyResult a = direct.result(), b = printed.result();
    direct.prepare(at.dyn(), at.stance, at.f);
    printed.prepare(at.dyn(), at.stance, at.f);
    for (const Vec2& f_xy : {Vec2(0, 0), Vec2(1.5, -2.0)}) {
      direct.solve(f_xy, a);
      printed.solve(f_xy, b);
      CHECK_NEAR(a.tau, b.tau, 1e-8);
      CHECK_NEAR(a.ddq, b.ddq, 1e-8);
      for (const Side side : kSides)
        if (at.stance.standing[side]) CHECK_NEAR(a.f_c.segment<6>(6 * side), b.f_c.segment<6>(6 * side), 1e-8);
      CHECK_NEAR(direct.zmp(f_xy), printed.zmp(f_xy), 1e-8);
    }
    CHECK_NEAR(direct.zmp_slope(), printed.zmp_slope(), 1e-8);
    BOOST_CHECK(!a.damped);
  });
}

BOOST_AUTO_TEST_CASE(direct_path_satisfies_the_equation_of_motion_and_the_tasks) {
  everywhere([](const Instant& at) {
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, at.f);
    controller.solve(at.f.com.head<2>(), out);
    VecX f_c(at.J_c.rows());
    f_c = at.stance.both() ? VecX(out.f_c) : VecX(out.f_c.segment<6>(at.stance.standing[kLeft] ? 0 : 6));
    CHECK_NEAR(at.dyn().A * out.ddq + at.h() + at.J_c.transpose() * f_c, at.applied(out.tau), 1e-9);
    CHECK_NEAR(at.J * out.ddq + at.drift, at.f_star, 1e-9);
    CHECK_NEAR(at.J_c * out.ddq + at.drift_c, VecX::Zero(at.J_c.rows()), 1e-9);
    if (!at.stance.both()) BOOST_CHECK(out.f_c.segment<6>(6 * at.stance.swing()).array().isNaN().all());
  });
}

BOOST_AUTO_TEST_CASE(normal_force_does_not_depend_on_the_horizontal_acceleration) {
  everywhere([](const Instant& at) {
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, at.f);
    const auto total = [&](const Vec2& f_xy) {
      controller.solve(f_xy, out);
      return total_wrench(out.f_c, {at.dyn().sole[0].p_WF, at.dyn().sole[1].p_WF}, Vec3::Zero()).F;
    };
    CHECK_NEAR(total({-20, 5}).z(), total({40, -9}).z(), 1e-8);
    CHECK_NEAR(total({2, 3}), at.dyn().mass * (at.dyn().gravity - Vec3(2, 3, at.f.com.z())), 1e-8);  // Newton
  });
}

BOOST_AUTO_TEST_CASE(standing_wrench_balances_the_weight_under_the_com) {
  for (const Standing standing : kStandings) {
    Instant at(standing, 0);
    at.robot.description().place(mahru(), at.data.get());
    at.robot.read(at.data.get());
    TaskAccelerations none;
    none.posture = VecX::Zero(at.robot.joints());
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, none);
    controller.solve(Vec2::Zero(), out);
    const Wrench total = total_wrench(out.f_c, {at.dyn().sole[0].p_WF, at.dyn().sole[1].p_WF}, at.dyn().com);
    CHECK_NEAR(total.F, at.dyn().mass * at.dyn().gravity, 1e-9);
    CHECK_NEAR(total.M, Vec3::Zero(), 1e-9);
    CHECK_NEAR(controller.zmp(Vec2::Zero()), at.dyn().com.head<2>(), 1e-11);
    if (standing == Standing::kBoth) CHECK_NEAR(out.f_c[2], out.f_c[8], 1e-9);  // half each
  }
}

BOOST_AUTO_TEST_CASE(contact_damping_slows_the_foot_that_does_not_carry_the_zmp) {
  Instant at(Standing::kBoth, 3);
  WholeBodyOptions options;
  options.contact_damping = 50.0;
  WholeBodyController controller(at.robot.nv(), at.robot.leg_joints(), options);
  WholeBodyResult out = controller.result();
  controller.prepare(at.dyn(), at.stance, at.f);
  controller.solve(Vec2::Zero(), out);
  const FrameState &left = at.dyn().sole[kLeft], &right = at.dyn().sole[kRight];
  CHECK_NEAR(left.J * out.ddq + left.drift, Vec6::Zero(), 1e-9);
  CHECK_NEAR(right.J * out.ddq + right.drift, Vec6(-50.0 * right.velocity), 1e-8);
}

BOOST_AUTO_TEST_CASE(shared_wrenches_add_up_to_the_total_at_one_offset) {
  Numbers numbers(5);
  for (int i = 0; i < 50; ++i) {
    const std::array<Vec3, 2> c{Vec3(0.05, 0.11, 0) + numbers.vector(3, 0.05),
                                Vec3(-0.05, -0.11, 0) + numbers.vector(3, 0.05)};
    const Vec3 F = Vec3(0, 0, -600) + numbers.vector(3, 100), M_P = numbers.vector(3, 20), P = numbers.vector(3, 0.2);
    const Vec12 f = distribute_wrench(F, M_P, P, c, Vec3::UnitY(), i % 2 ? numbers.uniform(0.0, 0.15) : 0.0);
    const Wrench total = total_wrench(f, c, P);
    CHECK_NEAR(total.F, F, 1e-11);
    CHECK_NEAR(total.M, M_P, 1e-11);
    const double a_left = f[2] / F.z();
    BOOST_CHECK_GE(a_left, 0.0);
    BOOST_CHECK_LE(a_left, 1.0);
    CHECK_NEAR(f.segment<3>(0), a_left * F, 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(load_is_shared_by_where_the_zmp_is_between_the_feet) {
  const std::array<Vec3, 2> c{Vec3(0, 0.1, 0), Vec3(0, -0.1, 0)};
  const Vec3 F(0, 0, -100);
  const auto left = [&](double y, const std::array<Vec3, 2>& feet) {
    return distribute_wrench(F, Vec3::Zero(), Vec3(0, y, 0), feet, Vec3::UnitY())[2];
  };
  CHECK_NEAR(left(0.0, c), -50.0, 1e-12);
  CHECK_NEAR(left(0.05, c), -75.0, 1e-12);
  CHECK_NEAR(left(0.3, c), -100.0, 1e-12);  // beyond the foot: all of it, never a pull on the other
  CHECK_NEAR(left(-0.3, c), 0.0, 1e-12);
  // Feet in line, as on a beam: shared along the line between them.
  const std::array<Vec3, 2> beam{Vec3(0.2, 0, 0), Vec3(-0.2, 0, 0)};
  CHECK_NEAR(distribute_wrench(F, Vec3::Zero(), Vec3(0.1, 0, 0), beam, Vec3::UnitY())[2], -75.0, 1e-12);
}

BOOST_AUTO_TEST_CASE(near_a_sole_its_foot_carries_everything_and_between_the_load_goes_over_without_a_jump) {
  const std::array<Vec3, 2> c{Vec3(0.05, 0.1, 0), Vec3(-0.05, -0.1, 0)}, beam{Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)};
  const Vec3 F(20, -10, -100), M_P(0, 0, 3);
  constexpr double h = 1e-4;
  for (const double alone : {0.05, 0.3}) {
    const double margin = std::min(alone, 0.09);  // less than half of the feet's distance, whatever is asked for
    Vec12 before = distribute_wrench(F, M_P, Vec3(0, -0.15, 0), c, Vec3::UnitY(), alone);
    for (double y = -0.15 + h; y < 0.15; y += h) {
      const Vec12 f = distribute_wrench(F, M_P, Vec3(0, y, 0), c, Vec3::UnitY(), alone);
      if (std::abs(y) > 0.1 - margin) CHECK_NEAR(f[2] / F.z(), y > 0 ? 1.0 : 0.0, 1e-12);
      CHECK_NEAR(f, before, 1.01 * F.norm() * h / (0.2 - 2.0 * margin));
      before = f;
    }
    CHECK_NEAR(distribute_wrench(F, M_P, Vec3(0.101 - margin, 0, 0), beam, Vec3::UnitY(), alone)[2], F.z(), 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(straight_legs_damp_the_motion_and_leave_it_finite) {
  for (const Standing standing : kStandings)
    for (const double knee : {0.0, 1e-9, 1e-4}) {
      Instant at(standing, 0);
      at.robot.description().place(mahru(), at.data.get());
      for (const Side side : kSides) {
        at.data->qpos[at.robot.qpos_address() + 7 + at.robot.leg_joints()[side][2]] = -0.5 * knee;
        at.data->qpos[at.robot.qpos_address() + 7 + at.robot.leg_joints()[side][3]] = knee;
        at.data->qpos[at.robot.qpos_address() + 7 + at.robot.leg_joints()[side][4]] = -0.5 * knee;
      }
      at.robot.read(at.data.get());
      WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
      WholeBodyResult out = controller.result();
      controller.prepare(at.dyn(), at.stance, at.f);
      controller.solve(at.f.com.head<2>(), out);
      BOOST_CHECK(out.damped);
      BOOST_CHECK_LE(largest(out.tau), 1e5);
      BOOST_CHECK(controller.zmp(Vec2::Zero()).allFinite());
    }
}

BOOST_AUTO_TEST_CASE(whole_body_control_refuses_what_it_cannot_use) {
  Instant at(Standing::kBoth, 0);
  const auto legs = at.robot.leg_joints();
  WholeBodyController controller(at.robot.nv(), legs);
  Stance nobody;
  nobody.standing = {false, false};
  CHECK_THROWS(controller.prepare(at.dyn(), nobody, at.f), InputError, "no foot stands");
  TaskAccelerations short_posture = at.f;
  short_posture.posture = VecX::Zero(3);
  CHECK_THROWS(controller.prepare(at.dyn(), at.stance, short_posture), DimensionError, "f_star.posture has 3 entries");
  CHECK_THROWS(controller.prepare(Dynamics(12), at.stance, at.f), DimensionError,
               "dynamics.dq has 12 entries; it must have 31");
  CHECK_THROWS(WholeBodyController(31, {legs[0], {1, 2, 3}}), DimensionError,
               "legs[side] has 3 entries; it must have 6");
  CHECK_THROWS(WholeBodyController(31, {legs[0], {1, 2, 3, 4, 5, 25}}), DimensionError, "25 is outside 0..24");
}
