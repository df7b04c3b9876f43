#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <utility>
#include <vector>

#include "robots.hpp"
#include "zmpwalk/control/contact_space.hpp"
#include "zmpwalk/control/task_space.hpp"

// Random instants of the humanoid with everything that equations 1-13 work on.

namespace zmpwalk::testing {

inline constexpr unsigned kSeeds = 20;

/// One random instant of the humanoid, its contact space and its stacked tasks.
struct Instant {
  Instant(Standing standing, unsigned seed, bool with_posture = true)
      : robot(mahru(), describe(mahru())),
        data(make_data(mahru())),
        stance(stance_of(standing)),
        f(random_tasks(robot.joints(), 100 + seed)),
        contact(robot.nv(), stance.both() ? 12 : 6) {
    randomize(robot, data.get(), seed);
    update(with_posture);
  }

  /// Everything anew for the state in `data`.
  void update(bool with_posture = true) {
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
      if (std::count(legs[0].begin(), legs[0].end(), j) + std::count(legs[1].begin(), legs[1].end(), j) == 0)
        posture.push_back(j);
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

}  // namespace zmpwalk::testing
