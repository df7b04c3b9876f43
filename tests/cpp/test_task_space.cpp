#include <Eigen/Eigenvalues>

#include "instant.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

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
  everywhere(
      [](const Instant& at) { CHECK_NEAR(at.J_c * at.contact.JbarT_c().transpose(), identity(at.J_c.rows()), 1e-9); });
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

BOOST_AUTO_TEST_CASE(operators_refuse_wrong_shapes_and_tasks_without_inertia) {
  Instant at(Standing::kBoth, 0);
  CHECK_THROWS(at.contact.compute(at.dyn().A, at.dyn().b, VecX::Zero(3), at.J_c, at.drift_c), DimensionError,
               "g has 3 entries");
  CHECK_THROWS(TaskSpace(at.contact, at.dyn().b, at.dyn().g, at.J.leftCols(30), at.drift), DimensionError,
               "J is (19, 30)");
  const RowMatX unmoved = RowMatX::Zero(1, 31);  // a task that no motion changes has no inertia
  CHECK_THROWS(TaskSpace(at.contact, at.dyn().b, at.dyn().g, unmoved, VecX::Zero(1)), InputError, "positive definite");
}
