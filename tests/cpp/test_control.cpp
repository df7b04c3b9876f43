#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "robots.hpp"
#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/control/task_space.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/control/wrench_distribution.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr unsigned kSeeds = 20;

/// One random instant of the humanoid, its contact space and its stacked tasks.
struct Instant {
  Instant(Standing standing, unsigned seed, bool with_posture = true)
      : robot(mahru(), describe(mahru())),
        data(make_data(mahru())),
        stance(stance_of(standing)),
        f(random_tasks(robot.joints(), 100 + seed)),
        contact(robot.nv(), stance.both() ? 12 : 6) {
    randomize(robot, data.get(), seed);
    robot.read(data.get());
    const ContactRows rows = contact_rows(dyn(), stance);
    J_c = rows.J;
    drift_c = rows.drift;
    contact.compute(dyn().A, dyn().b, dyn().g, J_c, drift_c);
    stack(with_posture);
  }

  const Dynamics& dyn() const { return robot.dynamics(); }
  VecX h() const { return dyn().b + dyn().g; }
  TaskSpace task() const { return TaskSpace(contact, dyn().b, dyn().g, J, drift); }
  /// S' tau.
  VecX applied(const VecX& tau) const { return (VecX(dyn().nv()) << VecX::Zero(6), tau).finished(); }
  /// Motion under `tau` with the standing feet at rest, and the wrench that holds them, by one linear system: no operator of ours.
  std::pair<VecX, VecX> motion(const VecX& tau) const {
    const long n = dyn().nv(), k = J_c.rows();
    MatX K = MatX::Zero(n + k, n + k);
    K << dyn().A, J_c.transpose(), J_c, MatX::Zero(k, k);
    const VecX x = K.fullPivLu().solve((VecX(n + k) << applied(tau) - h(), -drift_c).finished());
    return {x.head(n), x.tail(k)};
  }

  Robot robot;
  MjDataPtr data;
  Stance stance;
  TaskAccelerations f;
  ContactSpace contact;
  RowMatX J_c, J;
  VecX drift_c, drift, f_star;

 private:
  void stack(bool with_posture) {
    std::vector<int> posture;
    for (int j = 0; with_posture && j < robot.joints(); ++j) {
      const auto& legs = robot.leg_joints();
      if (std::count(legs[0].begin(), legs[0].end(), j) + std::count(legs[1].begin(), legs[1].end(), j) == 0) posture.push_back(j);
    }
    const int swing = stance.both() ? 0 : 6, rows = 6 + swing + static_cast<int>(posture.size());
    J = RowMatX::Zero(rows, dyn().nv());
    drift = f_star = VecX::Zero(rows);
    J.topRows<3>() = dyn().J_com;
    J.block<3, 3>(3, 3) = dyn().R_WB;  // angular velocity in world axes
    drift.head<3>() = dyn().drift_com;
    f_star.head<6>() << f.com, f.trunk;
    if (swing) {
      J.middleRows<6>(6) = dyn().sole[stance.swing()].J;
      drift.segment<6>(6) = dyn().sole[stance.swing()].drift;
      f_star.segment<6>(6) = f.swing;
    }
    for (std::size_t i = 0; i < posture.size(); ++i) {
      J(6 + swing + i, 6 + posture[i]) = 1.0;
      f_star[6 + swing + i] = f.posture[posture[i]];
    }
  }
};

template <class Check>
void everywhere(Check&& check, bool with_posture = true) {
  for (const Standing standing : kStandings)
    for (unsigned seed = 0; seed < kSeeds; ++seed) check(Instant(standing, seed, with_posture));
}

RowMatX identity(long n) { return RowMatX::Identity(n, n); }

}  // namespace

BOOST_AUTO_TEST_CASE(contact_operators_of_two_masses_by_hand) {
  // A mass m on the ground, a mass M over it, a force tau between them. q = (height of m, distance).
  const double m = 2.0, M = 3.0, g = 10.0, tau = 17.0;
  ContactSpace contact(2, 1);
  const RowMatX A = (RowMatX(2, 2) << m + M, M, M, M).finished();
  const RowMatX J_c = (RowMatX(1, 2) << 1, 0).finished();
  contact.compute(A, VecX::Zero(2), Eigen::Vector2d((m + M) * g, M * g), J_c, VecX::Zero(1));
  CHECK_NEAR(contact.Lambda_c()(0, 0), m, 1e-14);
  CHECK_NEAR(contact.JbarT_c(), (RowMatX(1, 2) << 1, -1).finished(), 1e-14);
  CHECK_NEAR(contact.p_c()[0], m * g, 1e-13);
  CHECK_NEAR(contact.N_c(), (RowMatX(2, 2) << 0, 1, 0, 1).finished(), 1e-14);
  VecX f_c(1);
  contact.wrench(VecX::Constant(1, tau), f_c);
  CHECK_NEAR(f_c[0], -(m * g + tau), 1e-13);  // on the ground: the weight of m and what pushes M up
}

BOOST_AUTO_TEST_CASE(contact_jacobian_times_its_inverse_is_identity) {
  everywhere([](const Instant& at) { CHECK_NEAR(at.J_c * at.contact.JbarT_c().transpose(), identity(at.J_c.rows()), 1e-9); });
}

BOOST_AUTO_TEST_CASE(contact_inertia_is_symmetric_positive_definite) {
  everywhere([](const Instant& at) {
    const RowMatX& Lambda = at.contact.Lambda_c();
    CHECK_NEAR(Lambda, Lambda.transpose(), 1e-9);
    BOOST_CHECK_GT(Eigen::SelfAdjointEigenSolver<MatX>(Lambda).eigenvalues().minCoeff(), 0.0);
  });
}

BOOST_AUTO_TEST_CASE(forces_through_the_contact_null_space_do_not_load_the_contact) {
  everywhere([](const Instant& at) {
    const RowMatX N = at.contact.N_c();
    CHECK_NEAR(N * at.J_c.transpose(), RowMatX::Zero(N.rows(), at.J_c.rows()), 1e-9);
    CHECK_NEAR(at.contact.JbarT_c() * N, RowMatX::Zero(at.J_c.rows(), N.rows()), 1e-9);
    CHECK_NEAR(N * N, N, 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(jacobian_times_its_inverse_is_identity) {
  everywhere([](const Instant& at) { CHECK_NEAR(at.J * at.task().JbarT.transpose(), identity(at.J.rows()), 1e-9); });
}

BOOST_AUTO_TEST_CASE(modified_jacobian_passes_task_forces_through_the_motors) {
  everywhere([](const Instant& at) {
    const TaskSpace task = at.task();
    CHECK_NEAR(task.JbarT.rightCols(at.robot.joints()) * task.J_k.transpose(), identity(at.J.rows()), 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(torque_7_gives_the_commanded_task_acceleration_and_still_feet) {
  everywhere([](const Instant& at) {
    const TaskSpace task = at.task();
    const VecX tau = task.torque(task.force(at.f_star));
    VecX f_c(at.J_c.rows());
    at.contact.wrench(tau, f_c);
    const auto [ddq, force] = at.motion(tau);
    CHECK_NEAR(at.J * ddq + at.drift, at.f_star, 1e-9);
    CHECK_NEAR(at.J_c * ddq + at.drift_c, VecX::Zero(at.J_c.rows()), 1e-9);
    CHECK_NEAR(f_c, force, 1e-8);  // (9) against the linear system
    const VecX ddq_9 = at.contact.A_inv() * (at.applied(tau) - at.h() - at.J_c.transpose() * f_c);
    CHECK_NEAR(ddq_9, ddq, 1e-9);
    CHECK_NEAR(at.dyn().A * ddq + at.h() + at.J_c.transpose() * force, at.applied(tau), 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(torque_7_as_printed_misses_the_commanded_acceleration) {
  everywhere([](const Instant& at) {
    const TaskSpace task = at.task();
    const VecX tau = task.torque(task.Lambda * (at.f_star + task.mu + task.p));
    BOOST_CHECK_GE(gap(at.J * at.motion(tau).first + at.drift, at.f_star), 1.0);
  });
}

BOOST_AUTO_TEST_CASE(null_space_torque_leaves_the_tasks_alone) {
  everywhere(
      [](const Instant& at) {
        const TaskSpace task = at.task();
        const VecX tau = task.torque(task.force(at.f_star));
        const VecX tau_0 = task.N_k * Numbers(7).vector(at.robot.joints(), 30.0);
        BOOST_CHECK_GE(tau_0.norm(), 1.0);
        CHECK_NEAR(at.J * at.motion(tau + tau_0).first + at.drift, at.f_star, 1e-9);
      },
      false);
}

BOOST_AUTO_TEST_CASE(internal_torques_exist_between_two_feet_and_move_nothing) {
  everywhere([](const Instant& at) {
    const TaskSpace task = at.task();
    BOOST_REQUIRE_EQUAL(task.V_n.cols(), at.stance.both() ? 6 : 0);
    if (!at.stance.both()) return;
    const VecX tau = task.torque(task.force(at.f_star)), internal = task.V_n * Numbers(8).vector(6, 20.0);
    const auto [ddq, f_c] = at.motion(tau);
    const auto [ddq_too, f_c_too] = at.motion(tau + internal);
    CHECK_NEAR(ddq_too, ddq, 1e-9);
    BOOST_CHECK_GE(gap(f_c_too, f_c), 1.0);
  });
}

BOOST_AUTO_TEST_CASE(direct_path_is_the_textbook_path) {
  everywhere([](const Instant& at) {
    WholeBodyOptions textbook;
    textbook.textbook = true;
    WholeBodyController direct(at.robot.nv(), at.robot.leg_joints()), printed(at.robot.nv(), at.robot.leg_joints(), textbook);
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
  const SoleState &left = at.dyn().sole[kLeft], &right = at.dyn().sole[kRight];
  CHECK_NEAR(left.J * out.ddq + left.drift, Vec6::Zero(), 1e-9);
  CHECK_NEAR(right.J * out.ddq + right.drift, Vec6(-50.0 * right.velocity), 1e-8);
}

BOOST_AUTO_TEST_CASE(shared_wrenches_add_up_to_the_total_at_one_offset) {
  Numbers numbers(5);
  for (int i = 0; i < 50; ++i) {
    const std::array<Vec3, 2> c{Vec3(0.05, 0.11, 0) + numbers.vector(3, 0.05), Vec3(-0.05, -0.11, 0) + numbers.vector(3, 0.05)};
    const Vec3 F = Vec3(0, 0, -600) + numbers.vector(3, 100), M_P = numbers.vector(3, 20), P = numbers.vector(3, 0.2);
    const Vec12 f = distribute_wrench(F, M_P, P, c, Vec3::UnitY());
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
  CHECK_THROWS(controller.prepare(Dynamics(12), at.stance, at.f), DimensionError, "dynamics.dq has 12 entries; it must have 31");
  CHECK_THROWS(WholeBodyController(31, {legs[0], {1, 2, 3}}), DimensionError, "legs[side] has 3 entries; it must have 6");
  CHECK_THROWS(WholeBodyController(31, {legs[0], {1, 2, 3, 4, 5, 25}}), DimensionError, "25 is outside 0..24");
  CHECK_THROWS(at.contact.compute(at.dyn().A, at.dyn().b, VecX::Zero(3), at.J_c, at.drift_c), DimensionError, "g has 3 entries");
  CHECK_THROWS(TaskSpace(at.contact, at.dyn().b, at.dyn().g, at.J.leftCols(30), at.drift), DimensionError, "J is (19, 30)");
  const RowMatX unmoved = RowMatX::Zero(1, 31);  // a task that no motion changes has no inertia
  CHECK_THROWS(TaskSpace(at.contact, at.dyn().b, at.dyn().g, unmoved, VecX::Zero(1)), InputError, "positive definite");
}
