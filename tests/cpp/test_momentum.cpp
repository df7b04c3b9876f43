#include "instant.hpp"
#include "zmpwalk/control/momentum.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

BOOST_AUTO_TEST_CASE(yaw_momentum_is_the_sum_over_the_bodies) {
  everywhere([](const Instant& at) {
    const mjModel* m = mahru();
    mj_forward(m, at.data.get());
    const mjData* d = at.data.get();
    double sum = 0.0;
    for (int body = 1; body < m->nbody; ++body) {
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(d->ximat + 9 * body);
      mjtNum v_com[6], centre[3] = {d->xipos[3 * body], d->xipos[3 * body + 1], d->xipos[3 * body + 2]};
      mju_transformSpatial(v_com, d->cvel + 6 * body, 0, centre, d->subtree_com + 3 * m->body_rootid[body], nullptr);
      const Vec3 omega = Eigen::Map<const Vec3>(v_com), velocity = Eigen::Map<const Vec3>(v_com + 3);
      const Vec3 inertia = Eigen::Map<const Vec3>(m->body_inertia + 3 * body);
      const Vec3 spin = R * inertia.cwiseProduct(R.transpose() * omega);
      const Vec3 arm = Eigen::Map<const Vec3>(centre) - at.dyn().com;
      sum += (spin + m->body_mass[body] * arm.cross(velocity)).z();
    }
    VecX c(at.dyn().nv());
    momentum_row(at.dyn(), Vec3::UnitZ(), c.transpose());
    BOOST_CHECK_SMALL(c.dot(at.dyn().dq) - sum, 1e-10);
  });
}

BOOST_AUTO_TEST_CASE(yaw_moment_is_the_derivative_of_the_yaw_momentum) {
  everywhere([](const Instant& at) {
    constexpr double h = 1e-6;
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(at.dyn(), at.stance, at.f);
    const Vec2 f_xy(0.4, -0.7);
    controller.solve(f_xy, out);
    const auto momentum_after = [&](double time) {  // along the motion that the controller has found
      const MjDataPtr d = make_data(mahru());
      const int n = at.robot.nv();
      mju_copy(d->qpos, at.data->qpos, n + 1);
      const VecX mean = at.dyn().dq + 0.5 * time * out.ddq, dq = at.dyn().dq + time * out.ddq;
      mj_integratePos(mahru(), d->qpos, mean.data(), time);
      mju_copy(d->qvel, dq.data(), n);
      Robot robot(mahru(), describe(mahru()));
      robot.read(d.get());
      VecX c(n);
      momentum_row(robot.dynamics(), Vec3::UnitZ(), c.transpose());
      return c.dot(robot.dynamics().dq);
    };
    const double slope = (momentum_after(h) - momentum_after(-h)) / (2.0 * h);
    BOOST_CHECK_SMALL(controller.yaw_moment(f_xy) - slope, 1e-5 * (1.0 + std::abs(slope)));
  });
}
