#include <mujoco/mujoco.h>

#include <cmath>

#include "testing.hpp"
#include "walk.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// The humanoid at 0.25 m/s, pushed when the right foot lifts off.
struct Pushed {
  Pushed(const WalkSettings& s, const Vec3& force)
      : controller(mahru(), describe(mahru()), s,
                   VelocityProfile({0.0, 1.25}, {Vec3::Zero(), Vec3(0.25, 0, 0)}, Interpolation::kLinear)),
        simulation(controller),
        recorder(controller, 8.0) {
    Push push{4.981, 0.08, "", Vec6::Zero()};
    push.wrench.head<3>() = force;
    simulation.push(push);
    result = simulation.run(8.0, recorder, {}, 0.1, {}, 0.0, OnFall::kGoOn);
  }
  Eigen::Map<const RowMatX> column(const std::string& name) const {
    for (const Column& c : recorder.columns())
      if (c.name == name) return {c.values.data(), static_cast<long>(recorder.rows()), c.width};
    throw std::runtime_error("no column " + name);
  }
  WalkingController controller;
  Simulation simulation;
  Recorder recorder;
  RunResult result;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_fall_is_foreseen_before_the_trunk_tilts_and_torques_and_speeds_stay_low_to_the_ground) {
  for (const bool timing : {false, true}) {
    const Pushed walk(with([&](WalkSettings& s) { s.steps.timing = timing; }), {0, timing ? 236.0 : 300.0, 0});
    BOOST_CHECK(walk.result.fell == Fall::kDown);
    BOOST_CHECK(walk.result.alarm == Fall::kLost);
    BOOST_CHECK(walk.result.alarm_text.find("beyond what any foothold within reach can catch") != std::string::npos);
    const auto t = walk.column("t"), qpos = walk.column("qpos"), foreseen = walk.column("fall_foreseen"),
               tau = walk.column("tau"), qvel = walk.column("qvel");
    long first = 0, tilted = 0;
    while (!(foreseen(first, 0) > 0.0)) ++first;
    const auto tilt = [&](long k) {
      return std::acos(1.0 - 2.0 * (qpos(k, 4) * qpos(k, 4) + qpos(k, 5) * qpos(k, 5)));
    };
    while (!(tilt(tilted) > 10.0 * M_PI / 180.0)) ++tilted;
    BOOST_CHECK_LT(t(first, 0), t(tilted, 0) - 0.2);
    BOOST_CHECK_LT((foreseen.bottomRows(foreseen.rows() - first).array() - 1.0).abs().maxCoeff(), 1e-12);
    BOOST_CHECK(tau.allFinite());
    const VecX limit = walk.controller.robot().torque_limit();
    BOOST_CHECK((tau.cwiseAbs().colwise().maxCoeff().transpose().array() <= limit.array()).all());
    const long crouching = qvel.rows() - first - 1;
    BOOST_CHECK_LT(qvel.bottomRows(crouching).rightCols(25).cwiseAbs().maxCoeff(), 10.0);
  }
}

BOOST_AUTO_TEST_CASE(a_walk_that_catches_itself_has_no_fall_foreseen) {
  const Pushed walk(WalkSettings(), {0, 80, 0});
  BOOST_CHECK(walk.result.fell == Fall::kNone && walk.result.alarm == Fall::kNone);
  CHECK_NEAR(walk.column("fall_gap").maxCoeff(), 0.0, 0.0);
}

BOOST_AUTO_TEST_CASE(without_the_crouch_the_walk_goes_on_and_is_the_walk_that_foresees_nothing) {
  const auto run = [](bool foresee) {
    WalkSettings s;
    s.fall.crouch = false;
    s.fall.foresee = foresee;
    return Pushed(s, {0, 600, 0});
  };
  const Pushed sees(run(true)), blind(run(false));
  BOOST_CHECK(sees.result.alarm == Fall::kLost && blind.result.alarm != Fall::kLost);
  BOOST_CHECK_EQUAL(sees.recorder.rows(), blind.recorder.rows());
  CHECK_NEAR(sees.column("tau"), blind.column("tau"), 0.0);
}

BOOST_AUTO_TEST_CASE(a_robot_that_starts_anew_has_nothing_foreseen) {
  Pushed walk(WalkSettings(), {0, 600, 0});
  BOOST_CHECK(walk.controller.output().foreseen);
  const MjDataPtr d = make_data(mahru());
  walk.controller.robot().description().place(mahru(), d.get());
  walk.controller.reset(d.get());
  for (int k = 0; k < 200; ++k) {
    walk.controller.update(d.get());
    mj_step(mahru(), d.get());
  }
  BOOST_CHECK(!walk.controller.output().foreseen);
  BOOST_CHECK(walk.controller.output().tau.norm() > 1.0);
}

BOOST_AUTO_TEST_CASE(the_crouch_bends_both_legs_towards_their_limits_and_damps_no_joint_beyond_its_torque) {
  const Robot robot(mahru(), describe(mahru()));
  const DampedCrouch crouch(robot, robot.timestep());
  for (const Side side : kSides) {
    const auto& leg = robot.leg_joints()[side];
    BOOST_CHECK_GT(std::abs(crouch.posture()[leg[3]] - robot.stand()[leg[3]]), 0.5);
    const double hip = crouch.posture()[robot.pitch_joint(side, 0, 3)] - robot.stand()[robot.pitch_joint(side, 0, 3)];
    const double knee = crouch.posture()[leg[3]] - robot.stand()[leg[3]];
    BOOST_CHECK_LT(hip * knee, 0.0);  // all pitch joints of the humanoid turn about y
  }
  BOOST_CHECK_GT(crouch.damping().minCoeff(), 0.0);
  Dynamics still = robot.dynamics();
  VecX tau = VecX::Zero(robot.joints());
  still.q = crouch.posture();
  still.dq.setZero();
  crouch.crouch_torque(still, tau);
  CHECK_NEAR(tau.norm(), 0.0, 1e-12);
  still.dq.setConstant(1e6);
  BOOST_CHECK_GT(crouch.crouch_torque(still, tau), 1.0);
  CHECK_NEAR(tau, -robot.torque_limit(), 1e-12);
}

BOOST_AUTO_TEST_CASE(the_hips_of_the_crouch_turn_a_leaning_trunk_upright_and_nothing_else_turns_it) {
  const Robot robot(mahru(), describe(mahru()));
  const DampedCrouch crouch(robot, robot.timestep());
  Dynamics leaning = robot.dynamics();
  leaning.q = crouch.posture();
  leaning.dq.setZero();
  VecX tau = VecX::Zero(robot.joints());
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.8, 0)}) {
    leaning.R_WB = Eigen::AngleAxisd(0.1, axis).toRotationMatrix();
    crouch.crouch_torque(leaning, tau);
    Vec3 on_trunk = Vec3::Zero();
    for (const Side side : kSides)
      for (const int i : {0, 1, 2}) {
        const int j = robot.leg_joints()[side][i];
        on_trunk -= tau[j] * leaning.sole[side].J.col(6 + j).tail<3>();
        tau[j] = 0.0;
      }
    BOOST_CHECK_LT(on_trunk.dot(axis), -1.0);
    CHECK_NEAR(tau.norm(), 0.0, 1e-12);
  }
}
