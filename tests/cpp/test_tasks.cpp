#include <algorithm>
#include <cmath>

#include "instant.hpp"
#include "walk.hpp"
#include "zmpwalk/control/external.hpp"
#include "zmpwalk/control/momentum.hpp"
#include "zmpwalk/control/tasks/com.hpp"
#include "zmpwalk/control/tasks/foot.hpp"
#include "zmpwalk/control/tasks/frame.hpp"
#include "zmpwalk/control/tasks/joint.hpp"
#include "zmpwalk/control/tasks/momentum.hpp"
#include "zmpwalk/control/tasks/posture.hpp"
#include "zmpwalk/control/tasks/trunk.hpp"
#include "zmpwalk/gait/pendulum.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/robot_names.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kDegree = M_PI / 180.0;

/// A random instant of the humanoid with tasks on it.
struct Stacked : Instant {
  using Instant::Instant;

  void add(const std::shared_ptr<Task>& task, double activation = 1.0) {
    NamesOfRobot names(robot);
    task->attach(names);
    task->weight = activation;
    stack.add(task, robot.nv(), 1.0);
    solver.reserve(stack);
  }
  TaskInput input(double t) const { return {dyn(), t, 0.4, 0.3}; }
  /// Long after the tasks began: each acts with its weight.
  void settle() {
    stack.update(input(0.0));
    stack.update(input(10.0));
  }
  WholeBodyResult solve(const Vec2& f_xy, bool with_tasks = true) {
    WholeBodyResult out = solver.result();
    solver.prepare(dyn(), stance, f, with_tasks ? &stack : nullptr);
    solver.solve(f_xy, out);
    return out;
  }
  /// f* - (J ddq + drift) of the task in place `k`.
  VecX miss(std::size_t k, const WholeBodyResult& out) const {
    const TaskRows& rows = stack.entries()[k].rows;
    return rows.f_star - rows.drift - rows.J * out.ddq;
  }

  WholeBodyController solver{robot.nv(), robot.leg_joints()};
  TaskStack stack;
};

std::shared_ptr<FrameTask> hand(const std::string& name, FramePart part = FramePart::kPose,
                                RelativeTo to = RelativeTo::kWorld) {
  const auto task = std::make_shared<FrameTask>(name, part, to);
  return task;
}

/// A task with random rows: no built-in one, and as hard as one likes.
struct RandomTask : Task {
  RandomTask(int count, unsigned number) : m(count), seed(number) {}
  int rows() const override { return m; }
  void compute(const TaskInput& in, TaskRows& out) override {
    Numbers numbers(seed);
    for (int i = 0; i < m; ++i) out.J.row(i) = numbers.vector(in.dynamics.nv(), 1.0);
    out.drift = numbers.vector(m, 1.0);
    out.f_star = numbers.vector(m, 5.0);
  }
  int m;
  unsigned seed;
};

template <class Check>
void at_some_instants(Check&& check) {
  for (const Standing standing : kStandings)
    for (unsigned seed = 0; seed < 6; ++seed) {
      Stacked at(standing, seed);
      check(at);
    }
}

}  // namespace

// --- the solver

BOOST_AUTO_TEST_CASE(tasks_are_met_and_the_walks_own_rows_stay_as_they_were) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    at.add(std::make_shared<MomentumTask>(MomentumTask::Axes::kAll));
    at.settle();
    const Vec2 f_xy = at.f.com.head<2>();
    const WholeBodyResult out = at.solve(f_xy);
    CHECK_NEAR(at.miss(0, out), VecX::Zero(6), 1e-8);
    CHECK_NEAR(at.miss(1, out), VecX::Zero(3), 1e-8);
    CHECK_NEAR(at.J.topRows(at.stance.both() ? 6 : 12) * out.ddq + at.drift.head(at.stance.both() ? 6 : 12),
               at.f_star.head(at.stance.both() ? 6 : 12), 1e-9);
    CHECK_NEAR(at.J_c * out.ddq + at.drift_c, VecX::Zero(at.J_c.rows()), 1e-9);
    VecX f_c(at.J_c.rows());
    f_c = at.stance.both() ? VecX(out.f_c) : VecX(out.f_c.segment<6>(at.stance.standing[kLeft] ? 0 : 6));
    CHECK_NEAR(at.dyn().A * out.ddq + at.h() + at.J_c.transpose() * f_c, at.applied(out.tau), 1e-8);
  });
}

BOOST_AUTO_TEST_CASE(a_cycle_with_tasks_leaves_nothing_behind) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    at.settle();
    const VecX free = at.solve(Vec2(0.4, -0.3), false).ddq, first = at.solve(Vec2(0.4, -0.3)).ddq;
    CHECK_NEAR(at.solve(Vec2(0.4, -0.3)).ddq, first, 0.0);
    CHECK_NEAR(at.solve(Vec2(0.4, -0.3), false).ddq, free, 0.0);
    BOOST_CHECK_GT(largest(first - free), 1.0);
  });
}

BOOST_AUTO_TEST_CASE(both_estimates_agree_with_tasks_in_the_stack) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    at.add(hand("r_hand", FramePart::kOrientation, RelativeTo::kWalk), 0.6);
    at.add(std::make_shared<JointTask>(std::vector<std::string>{"waist_yaw", "r_elbow"}));
    at.settle();
    at.solver.prepare(at.dyn(), at.stance, at.f, &at.stack);
    ZmpEstimator estimator(at.robot.nv());
    estimator.update(at.dyn().A, at.dyn().b, at.dyn().g, at.J_c, at.drift_c, at.solver.feet(), at.stance.support);
    for (const Vec2& f_xy : {Vec2(0, 0), Vec2(1.5, -2.0)}) {
      WholeBodyResult out = at.solver.result();
      at.solver.solve(f_xy, out);
      CHECK_NEAR(estimator.estimate(out.tau).zmp, at.solver.zmp(f_xy), 1e-9);
    }
  });
}

BOOST_AUTO_TEST_CASE(a_task_changes_the_posture_as_little_as_it_can) {
  // The change of the joints outside the legs is orthogonal to whatever leaves the task alone.
  Stacked at(Standing::kLeft, 3);
  at.add(hand("l_hand", FramePart::kPosition));
  at.settle();
  const VecX change = at.solve(Vec2(0.3, 0.2)).ddq - at.solve(Vec2(0.3, 0.2), false).ddq;
  // Another motion that meets the task: a little of a second task, which the first one sees nothing of.
  Stacked other(Standing::kLeft, 3);
  other.add(hand("l_hand", FramePart::kPosition));
  other.add(std::make_shared<RandomTask>(2, 9));
  other.settle();
  const VecX further = other.solve(Vec2(0.3, 0.2)).ddq - other.solve(Vec2(0.3, 0.2), false).ddq;
  std::vector<int> posture;
  for (int j = 0; j < at.robot.joints(); ++j)
    if (!at.robot.is_leg_joint(j)) posture.push_back(6 + j);
  double product = 0.0;
  for (const int i : posture) product += change[i] * (further[i] - change[i]);
  BOOST_CHECK_SMALL(product, 1e-8);
  BOOST_CHECK_GT((further - change).norm(), 1.0);
}

BOOST_AUTO_TEST_CASE(a_later_task_takes_nothing_from_an_earlier_one) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    at.add(std::make_shared<RandomTask>(9, 4));  // 6 + 9 rows for 13 joints: the second has to give way
    at.settle();
    const WholeBodyResult out = at.solve(Vec2(0.5, -0.5));
    CHECK_NEAR(at.miss(0, out), VecX::Zero(6), 1e-8);
    BOOST_CHECK_GT(largest(at.miss(1, out)), 0.1);
    BOOST_CHECK(out.tau.allFinite());
  });
}

BOOST_AUTO_TEST_CASE(priority_not_the_order_of_adding_decides) {
  Stacked at(Standing::kBoth, 1);
  const auto first = std::make_shared<RandomTask>(8, 1), second = std::make_shared<RandomTask>(8, 2);
  first->priority = 2;
  second->priority = 1;
  at.add(first);
  at.add(second);
  at.settle();
  BOOST_CHECK(at.stack.entries()[0].task == second);
  CHECK_NEAR(at.miss(0, at.solve(Vec2::Zero())), VecX::Zero(8), 1e-7);
}

BOOST_AUTO_TEST_CASE(tasks_said_twice_or_out_of_reach_leave_the_motion_finite) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    const VecX once = (at.settle(), at.solve(Vec2(0.1, 0.2)).ddq);
    at.add(hand("l_hand"));
    at.settle();
    CHECK_NEAR(at.solve(Vec2(0.1, 0.2)).ddq, once, 1e-6);
    at.add(std::make_shared<RandomTask>(20, 5));
    at.settle();
    BOOST_CHECK_LE(largest(at.solve(Vec2(0.1, 0.2)).ddq), 1e4);
  });
}

BOOST_AUTO_TEST_CASE(a_straight_arm_is_damped_and_comes_through_without_a_jump) {
  // The elbow goes through its singular position; the motion is bounded and continuous all the way.
  Stacked at(Standing::kLeft, 0);
  at.robot.description().place(mahru(), at.data.get());
  at.update();
  at.add(hand("l_hand", FramePart::kPosition));
  int elbow = 0;
  while (at.robot.joint_names()[elbow] != "l_elbow") ++elbow;
  at.data->qvel[0] = 0.3;
  VecX before;
  for (double q = -0.3; q < 0.3; q += 1e-3) {
    at.data->qpos[at.robot.qpos_address() + 7 + elbow] = q;
    at.update();
    at.settle();
    const VecX ddq = at.solve(Vec2::Zero()).ddq;
    BOOST_CHECK_LE(largest(ddq), 2000.0);
    if (before.size()) CHECK_NEAR(ddq, before, 0.02 * 2000.0);
    before = ddq;
  }
}

BOOST_AUTO_TEST_CASE(activation_leads_from_one_stack_to_the_other_without_a_jump) {
  at_some_instants([](Stacked& at) {
    at.add(hand("l_hand"));
    at.add(std::make_shared<RandomTask>(4, 8), 0.7);
    at.stack.update(at.input(0.0));
    CHECK_NEAR(at.solve(Vec2(1, 1)).ddq, at.solve(Vec2(1, 1), false).ddq, 0.0);  // the very bits, where nothing acts
    VecX before = at.solve(Vec2(1, 1)).ddq;
    double farthest = 0.0;
    for (double t = 0.0; t <= 1.0; t += 0.005) {
      at.stack.update(at.input(t));
      const VecX now = at.solve(Vec2(1, 1)).ddq;
      farthest = std::max(farthest, largest(now - before));
      before = now;
    }
    at.settle();
    const double whole = largest(at.solve(Vec2(1, 1)).ddq - at.solve(Vec2(1, 1), false).ddq);
    BOOST_CHECK_LE(farthest, 0.005 * 1.875 * 3.0 * whole);  // the blend's steepest slope is 1.875
  });
}

// --- rows of the tasks

BOOST_AUTO_TEST_CASE(frames_accelerate_in_their_carrier_as_the_reference_says) {
  // Along the motion that the solver finds, by differences of places and rotations seen from the carrier.
  constexpr double h = 1e-4;
  for (const RelativeTo to : {RelativeTo::kWorld, RelativeTo::kWalk, RelativeTo::kTrunk})
    for (unsigned seed = 0; seed < 4; ++seed) {
      Stacked at(Standing::kLeft, seed);
      const auto task = std::make_shared<FrameTask>("l_hand", FramePart::kPose, to);
      at.add(task);
      Robot robot(mahru(), describe(mahru()));
      const int frame = robot.watch("l_hand");
      const MjDataPtr d = make_data(mahru());
      VecX ddq = VecX::Zero(at.robot.nv());
      const auto place = [&](double time) {
        mju_copy(d->qpos, at.data->qpos, at.robot.nv() + 1);
        const VecX mean = at.dyn().dq + 0.5 * time * ddq;
        mj_integratePos(mahru(), d->qpos, mean.data(), time);
        robot.read(d.get());
        const Dynamics& dyn = robot.dynamics();
        const Mat3 R_WC = to == RelativeTo::kWorld  ? Mat3(Mat3::Identity())
                          : to == RelativeTo::kWalk ? rotation_z(0.4 + 0.3 * time)
                                                    : dyn.R_WB;
        const Vec3 p_WC = to == RelativeTo::kWorld ? Vec3(Vec3::Zero()) : to == RelativeTo::kWalk ? dyn.com : dyn.p_WB;
        return std::make_pair(Vec3(R_WC.transpose() * (dyn.frames[frame].p_WF - p_WC)),
                              Mat3(R_WC.transpose() * dyn.frames[frame].R_WF));
      };
      const auto rates = [&] {
        const auto [p_0, R_0] = place(-h);
        const auto [p_1, R_1] = place(0.0);
        const auto [p_2, R_2] = place(h);
        Vec6 velocity, acceleration;
        const Vec3 turn_01 = orientation_error(R_1, R_0), turn_12 = orientation_error(R_2, R_1);
        velocity << (p_2 - p_0) / (2.0 * h), (turn_01 + turn_12) / (2.0 * h);
        acceleration << (p_2 - 2.0 * p_1 + p_0) / (h * h), (turn_12 - turn_01) / (h * h);
        return std::make_pair(velocity, acceleration);
      };
      PoseReference reference;  // the frame is where it should be, and moves as it should
      std::tie(reference.p, reference.R) = place(0.0);
      reference.velocity = rates().first;
      reference.acceleration = Numbers(seed).vector(6, 3.0);
      task->set(reference);
      at.settle();
      ddq = at.solve(Vec2(0.2, 0.4)).ddq;
      CHECK_NEAR(rates().second, reference.acceleration, 2e-4 * (1.0 + largest(ddq)));
    }
}

BOOST_AUTO_TEST_CASE(a_frame_that_is_where_it_should_be_stays_there_in_its_carrier) {
  // The frame rests in its carrier, and the reference is its place: the acceleration asked for is the carrier's own.
  for (const RelativeTo to : {RelativeTo::kWalk, RelativeTo::kTrunk}) {
    Stacked at(Standing::kBoth, 2);
    at.add(hand("l_hand", FramePart::kPose, to));
    at.stack.update(at.input(0.0));
    const auto task = std::static_pointer_cast<FrameTask>(at.stack.entries()[0].task);
    at.settle();
    const WholeBodyResult out = at.solve(Vec2(0.1, -0.3));
    CHECK_NEAR(at.miss(0, out), VecX::Zero(6), 1e-8);
    const FrameState& frame = at.dyn().frames[0];
    const Mat3 R = to == RelativeTo::kWalk ? rotation_z(0.4) : at.dyn().R_WB;
    const Vec3 p = to == RelativeTo::kWalk ? at.dyn().com : at.dyn().p_WB;
    CHECK_NEAR(task->reference().p, Vec3(R.transpose() * (frame.p_WF - p)), 1e-12);
    CHECK_NEAR(Mat3(R * task->reference().R), frame.R_WF, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(momentum_rows_give_the_rate_of_the_momentum) {
  everywhere([](const Instant& at) {
    constexpr double h = 1e-6;
    const int n = at.robot.nv();
    const VecX ddq = Numbers(7).vector(n, 5.0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto momentum_after = [&](double time) {
        const MjDataPtr d = make_data(mahru());
        mju_copy(d->qpos, at.data->qpos, n + 1);
        const VecX mean = at.dyn().dq + 0.5 * time * ddq, dq = at.dyn().dq + time * ddq;
        mj_integratePos(mahru(), d->qpos, mean.data(), time);
        mju_copy(d->qvel, dq.data(), n);
        Robot robot(mahru(), describe(mahru()));
        robot.read(d.get());
        VecX c(n);
        momentum_row(robot.dynamics(), Vec3::Unit(axis), c.transpose());
        return c.dot(robot.dynamics().dq);
      };
      VecX c(n);
      momentum_row(at.dyn(), Vec3::Unit(axis), c.transpose());
      const double rate = c.dot(ddq) + momentum_drift(at.dyn(), Vec3::Unit(axis));
      const double slope = (momentum_after(h) - momentum_after(-h)) / (2.0 * h);
      BOOST_CHECK_SMALL(rate - slope, 1e-5 * (1.0 + std::abs(slope)));
    }
  });
}

BOOST_AUTO_TEST_CASE(a_soft_trunk_comes_back_slowly_and_a_stiff_one_as_its_gains_say) {
  everywhere([](const Instant& at) {
    TrunkTask trunk;
    trunk.R_HB = rotation_z(0.3) * at.dyn().R_WB;  // a third of a radian from where it should be
    trunk.kp = 300;
    trunk.kd = 35;
    const auto answer = [&](double softness) {
      trunk.softness = softness;
      return trunk.acceleration(at.dyn(), Mat3::Identity(), 0.0);
    };
    const Vec3 stiff = answer(0.0), error = orientation_error(trunk.R_HB, at.dyn().R_WB);
    CHECK_NEAR(stiff, Vec3(300 * error - 35 * at.dyn().omega_WB), 1e-9);
    trunk.soft_rate = 2.0;
    trunk.soft_most = 3.0;
    trunk.soft_angle = error.norm();  // twice as stiff there
    const Vec3 soft = answer(1.0), free = 8.0 * error - std::sqrt(2.0) * 4.0 * at.dyn().omega_WB;
    CHECK_NEAR(soft, free.cwiseMax(-6.0).cwiseMin(6.0), 1e-9);
    CHECK_NEAR(answer(0.25), Vec3(0.75 * stiff + 0.25 * soft), 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(the_walks_own_tasks_stacked_are_what_the_direct_path_solves) {
  everywhere([](const Instant& at) {
    const Dynamics& dyn = at.dyn();
    const TaskInput in{dyn, 0.0, 0.3, 0.2};
    Numbers numbers(11);
    ComTask com;
    com.p = dyn.com + numbers.vector(3, 0.05);
    com.kp = Vec3(100, 100, 200);
    com.kd = Vec3(20, 20, 28);
    TrunkTask trunk;
    trunk.turn = turning({0.1, 0.2, 0.3}, {-0.1, 0.1, 0.2}, {0.2, -0.3, 0.1});
    trunk.kp = 300;
    trunk.kd = 35;
    FootTask foot;
    foot.side = at.stance.swing();
    foot.reference.p = dyn.sole[foot.side].p_WF + numbers.vector(3, 0.05);
    foot.reference.acceleration = numbers.vector(6, 2.0);
    foot.kp = 900;
    foot.kd = 60;
    PostureTask posture(dyn.joints());
    posture.q = dyn.q + numbers.vector(dyn.joints(), 0.2);
    posture.ddq = numbers.vector(dyn.joints(), 2.0);
    posture.kp = 100;
    posture.kd = 20;

    TaskAccelerations f;
    f.com = com.acceleration(dyn);
    f.trunk = trunk.acceleration(dyn, rotation_z(in.heading), in.heading_rate);
    f.swing = foot.acceleration(dyn);
    f.posture = VecX::Zero(dyn.joints());
    posture.acceleration(dyn, f.posture);
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    WholeBodyResult out = controller.result();
    controller.prepare(dyn, at.stance, f);
    controller.solve(f.com.head<2>(), out);

    const auto miss = [&](Task& task) {
      TaskRows rows(task.rows(), dyn.nv());
      task.compute(in, rows);
      return VecX(rows.J * out.ddq + rows.drift - rows.f_star);
    };
    CHECK_NEAR(miss(com), VecX::Zero(3), 1e-9);
    CHECK_NEAR(miss(trunk), VecX::Zero(3), 1e-9);
    if (!at.stance.both()) CHECK_NEAR(miss(foot), VecX::Zero(6), 1e-9);
    const VecX of_joints = miss(posture);
    for (int j = 0; j < dyn.joints(); ++j)
      if (!at.robot.is_leg_joint(j)) BOOST_CHECK_SMALL(of_joints[j], 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(watched_frames_are_those_of_mujoco) {
  Robot robot(mahru(), describe(mahru()));
  const int hand = robot.watch("l_hand"), site = robot.watch("imu");
  BOOST_CHECK_EQUAL(robot.watch("l_hand"), hand);
  const MjDataPtr d = make_data(mahru());
  randomize(robot, d.get(), 5);
  robot.read(d.get());
  mj_forward(mahru(), d.get());
  const int body = mj_name2id(mahru(), mjOBJ_BODY, "l_hand"), imu = mj_name2id(mahru(), mjOBJ_SITE, "imu");
  CHECK_NEAR(robot.dynamics().frames[hand].p_WF, Eigen::Map<const Vec3>(d->xpos + 3 * body), 1e-12);
  CHECK_NEAR(robot.dynamics().frames[site].p_WF, Eigen::Map<const Vec3>(d->site_xpos + 3 * imu), 1e-12);
  RowMatX J(6, mahru()->nv);
  mj_jacBody(mahru(), d.get(), J.data(), J.data() + 3 * mahru()->nv, body);
  CHECK_NEAR(robot.dynamics().frames[hand].J, J, 1e-12);
  CHECK_THROWS(robot.watch("tail"), InputError, "no body or site 'tail'; there are: pelvis");
  CHECK_THROWS(robot.watch("floor"), InputError, "no body or site 'floor'");
}

BOOST_AUTO_TEST_CASE(tasks_refuse_what_they_cannot_use) {
  Robot robot(mahru(), describe(mahru()));
  NamesOfRobot names(robot);
  CHECK_THROWS(FrameTask("tail").attach(names), InputError, "no body or site 'tail'");
  CHECK_THROWS(FrameTask("l_hand", FramePart::kPose, RelativeTo::kWorld, -1.0), InputError, "kp = -1");
  PoseReference bad;
  bad.R *= 2.0;
  CHECK_THROWS(FrameTask("l_hand").set(bad), InputError, "no rotation");
  CHECK_THROWS(JointTask({}), InputError, "at least one joint");
  CHECK_THROWS(JointTask({"l_elbow", "l_elbow"}), InputError, "'l_elbow' twice");
  CHECK_THROWS(JointTask({"l_knee"}).attach(names), InputError, "a joint of a leg");
  CHECK_THROWS(JointTask({"l_ellbow"}).attach(names), InputError, "there are: waist_yaw");
  JointTask elbow({"l_elbow"});
  elbow.attach(names);
  CHECK_THROWS(elbow.set(VecX::Constant(1, 1.0), VecX::Zero(1), VecX::Zero(1)), InputError, "its range is -2.27");
  CHECK_THROWS(elbow.set(VecX::Zero(2), VecX::Zero(1), VecX::Zero(1)), DimensionError, "q has 2 entries");

  WalkingController controller(mahru(), describe(mahru()));
  const auto task = hand("l_hand");
  controller.add(task);
  CHECK_THROWS(controller.add(task), InputError, "added already");
  CHECK_THROWS(controller.remove(*hand("l_hand")), InputError, "has not been added");
  CHECK_THROWS(controller.add(hand("r_hand"), -1.0), InputError, "blend = -1");
  const auto none = hand("r_hand");
  none->weight = 0.0;
  CHECK_THROWS(controller.add(none), InputError, "weight is 0");
  WalkingController textbook(mahru(), describe(mahru()), with([](WalkSettings& s) { s.control.textbook = true; }));
  CHECK_THROWS(textbook.add(hand("l_hand")), InputError, "tasks need the direct path");
  BOOST_CHECK(textbook.added_tasks().entries().empty());
}

// --- known forces

BOOST_AUTO_TEST_CASE(a_known_force_is_in_the_equation_of_motion_and_in_both_estimates) {
  at_some_instants([](Stacked& at) {
    const int frame = at.robot.watch("l_hand");
    at.robot.read(at.data.get());
    Vec6 w;
    w << 15, -8, 12, 1.0, 2.0, -0.5;
    at.robot.apply_external({{frame, w}});
    const VecX free = at.dyn().b + at.dyn().frames[frame].J.transpose() * w;
    const WholeBodyResult out = at.solve(Vec2(0.4, 0.1), false);
    VecX f_c(at.J_c.rows());
    f_c = at.stance.both() ? VecX(out.f_c) : VecX(out.f_c.segment<6>(at.stance.standing[kLeft] ? 0 : 6));
    // The motion asked for, under the true force, with the wrench that the ground gives.
    CHECK_NEAR(at.dyn().A * out.ddq + free + at.dyn().g + at.J_c.transpose() * f_c,
               at.applied(out.tau) + at.dyn().frames[frame].J.transpose() * w, 1e-9);
    CHECK_NEAR(at.J * out.ddq + at.drift,
               (VecX(at.f_star) << Vec2(0.4, 0.1), at.f_star.tail(at.f_star.size() - 2)).finished(), 1e-9);
    ZmpEstimator estimator(at.robot.nv());
    estimator.update(at.dyn().A, at.dyn().b, at.dyn().g, at.J_c, at.drift_c, at.solver.feet(), at.stance.support);
    CHECK_NEAR(estimator.estimate(out.tau).zmp, at.solver.zmp(Vec2(0.4, 0.1)), 1e-9);
  });
}

BOOST_AUTO_TEST_CASE(a_standing_robot_carries_the_zmp_where_the_forced_pendulum_says) {
  // At rest the ZMP lies under the shifted COM, for any force and moment.
  Numbers numbers(3);
  for (int i = 0; i < 10; ++i) {
    Instant at(Standing::kBoth, 0);
    at.robot.description().place(mahru(), at.data.get());
    const int frame = at.robot.watch("r_hand");
    at.robot.read(at.data.get());
    at.robot.apply_external({{frame, Vec6(numbers.vector(6, 20.0))}});
    TaskAccelerations none;
    none.posture = VecX::Zero(at.robot.joints());
    WholeBodyController controller(at.robot.nv(), at.robot.leg_joints());
    controller.prepare(at.dyn(), at.stance, none);
    const ForcedPendulum forced = forced_pendulum(at.dyn(), at.dyn().sole[kLeft].p_WF.z());
    CHECK_NEAR(controller.zmp(Vec2::Zero()), Vec2(at.dyn().com.head<2>() + forced.shift), 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(without_a_force_the_pendulum_is_the_free_one) {
  const Instant at(Standing::kBoth, 1);
  const ForcedPendulum forced = forced_pendulum(at.dyn(), 0.0);
  CHECK_NEAR(forced.shift, Vec2::Zero(), 0.0);
  BOOST_CHECK_EQUAL(forced.gravity, at.dyn().gravity.norm());
}

BOOST_AUTO_TEST_CASE(a_point_mass_under_a_force_moves_as_the_shifted_pendulum) {
  // By hand: m = 2 kg at z = 1 m, F = (3, 0, 4) N through it: N = 2 g - 4, x'' = (N r_z...) / m.
  Dynamics dyn(12);
  dyn.mass = 2.0;
  dyn.gravity = Vec3(0, 0, -10);
  dyn.com = Vec3(0.2, 0.0, 1.0);
  dyn.F_ext = Vec3(3, 0, 4);
  const ForcedPendulum forced = forced_pendulum(dyn, 0.0);
  BOOST_CHECK_CLOSE(forced.shift.x(), 3.0 / 16.0, 1e-10);
  BOOST_CHECK_CLOSE(forced.gravity, 8.0, 1e-10);
  // The ground's force goes from r through the mass: R_x / R_z = (x - r) / z with R_z = N; Newton: m x'' = R_x + F_x.
  const double r = 0.05, ddx = (16.0 * (0.2 - r) / 1.0 + 3.0) / 2.0;
  BOOST_CHECK_CLOSE(LinearInvertedPendulum(1.0, forced.gravity).acceleration(0.2 + forced.shift.x(), r), ddx, 1e-9);
}

BOOST_AUTO_TEST_CASE(a_force_that_lifts_the_whole_weight_leaves_a_pendulum_of_a_tenth_of_it) {
  Dynamics dyn(12);
  dyn.mass = 2.0;
  dyn.gravity = Vec3(0, 0, -10);
  dyn.com = Vec3(0, 0, 1.0);
  for (const double lift : {18.0, 20.0, 50.0}) {
    dyn.F_ext = Vec3(1, 0, lift);
    const ForcedPendulum forced = forced_pendulum(dyn, 0.0);
    BOOST_CHECK_CLOSE(forced.gravity, 1.0, 1e-10);
    BOOST_CHECK_CLOSE(forced.shift.x(), 0.5, 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(the_com_height_takes_the_gravity_that_a_force_leaves_until_the_next_walk) {
  ComHeight height(0.8, 10.0, resolve(WalkSettings(), {0.8, 10.0, 0.001, 0.2}));
  height.reset(0.8, 0.0);
  BOOST_CHECK(!height.weigh(10.0));
  BOOST_CHECK(height.weigh(12.5));
  BOOST_CHECK_CLOSE(height.pendulum().Tc(), std::sqrt(0.8 / 12.5), 1e-12);
  BOOST_CHECK(!height.weigh(12.5));
  height.reset(0.8, 0.0);
  BOOST_CHECK_CLOSE(height.pendulum().Tc(), std::sqrt(0.8 / 10.0), 1e-12);
}

// --- walks

namespace {

/// From rest to `speed` straight ahead within `time`.
VelocityProfile ramp(double speed, double time) {
  return {{0.0, time}, {Vec3::Zero(), Vec3(speed, 0, 0)}, Interpolation::kLinear};
}

/// A walk in a loop of our own, with tasks and a force at a hand.
struct Carried {
  explicit Carried(const VelocityProfile& profile, const WalkSettings& s = WalkSettings())
      : controller(mahru(), describe(mahru()), s, profile), data(make_data(mahru())) {
    controller.robot().description().place(mahru(), data.get());
    controller.reset(data.get());
  }
  /// One cycle; `each` sees the state it was for and what was decided.
  template <class Each>
  void walk_until(double t, Each&& each) {
    while (data->time < t - 1e-9) {
      const CycleOutput& out = controller.update(data.get(), Terms::kCompute, sensed);
      mj_step(mahru(), data.get());
      each(out);
      BOOST_REQUIRE(out.fell == Fall::kNone);
    }
  }
  /// Estimate minus MuJoCo's contact forces of this cycle [m].
  Vec2 estimate_error(const CycleOutput& out) const {
    const MeasuredContact contact = measure_contact(controller.robot(), data.get());
    return out.zmp_est - measured_zmp(contact, Plane::through(contact.sole[out.support > 0 ? kLeft : kRight]));
  }
  Sensed sensed;
  WalkingController controller;
  MjDataPtr data;
};

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_hand_stays_in_the_world_while_the_robot_walks_by) {
  Carried walk(ramp(0.25, 1.5));
  walk.walk_until(3.0, [](const CycleOutput&) {});
  // A point ahead of the hand: the hand goes there within half a second, and the robot walks up to it and past.
  const int frame = walk.controller.watch("l_hand");
  const FrameState at = walk.controller.robot().dynamics().frames[frame];
  const auto task = hand("l_hand");
  PoseReference there;
  there.p = at.p_WF + Vec3(0.22, 0.1, 0.1);
  there.R = at.R_WF;
  task->set(there);
  walk.controller.add(task, 0.5);
  std::vector<double> x, y;
  double off = 0.0, turned = 0.0, outside = 0.0;
  walk.walk_until(5.2, [&](const CycleOutput& out) {
    const Vec2 error = walk.estimate_error(out).cwiseAbs();
    x.push_back(error.x());
    y.push_back(error.y());
    if (out.phase == 1)
      outside = std::max({outside, (out.zmp_lower - out.zmp_est).maxCoeff(), (out.zmp_est - out.zmp_upper).maxCoeff()});
    if (out.t < 3.75) return;
    const FrameState& now = walk.controller.robot().dynamics().frames[frame];
    off = std::max(off, (now.p_WF - there.p).norm());
    turned = std::max(turned, orientation_error(there.R, now.R_WF).norm());
  });
  BOOST_CHECK_LE(off, 0.002);
  BOOST_CHECK_LE(turned, 0.5 * kDegree);
  BOOST_CHECK_LE(outside, 1e-5);
  BOOST_CHECK_LE(percentile(x, 0.5), 5e-5);
  BOOST_CHECK_LE(percentile(y, 0.5), 5e-5);
  BOOST_TEST_MESSAGE("hand off by " << 1e3 * off << " mm, " << turned / kDegree << " deg; estimate - CoP median "
                                    << 1e3 * percentile(x, 0.5) << ", " << 1e3 * percentile(y, 0.5) << " mm, p95 "
                                    << 1e3 * percentile(x, 0.95) << ", " << 1e3 * percentile(y, 0.95) << " mm");
  walk.controller.remove(*task, 0.5);
  walk.walk_until(7.0, [](const CycleOutput&) {});
}

BOOST_AUTO_TEST_CASE(adding_and_removing_a_task_bends_the_torque_no_more_than_the_blend) {
  // The same walk with and without the task: their torques part no faster than the blend lets them.
  const auto torques = [](bool with_task) {
    Carried walk(ramp(0.0, 1.0));
    const auto task = std::make_shared<JointTask>(std::vector<std::string>{"l_elbow", "waist_yaw"});
    task->set(Vec2(-1.3, 0.2), Vec2::Zero(), Vec2::Zero());
    std::vector<VecX> tau;
    const auto keep = [&](const CycleOutput& out) { tau.push_back(out.tau); };
    walk.walk_until(0.3, keep);
    if (with_task) walk.controller.add(task, 0.4);
    walk.walk_until(1.0, keep);
    if (with_task) walk.controller.remove(*task, 0.4);
    walk.walk_until(1.6, keep);
    return tau;
  };
  const auto with_task = torques(true), without = torques(false);
  double step = 0.0, largest_change = 0.0;
  for (std::size_t k = 1; k < with_task.size(); ++k) {
    const VecX before = with_task[k - 1] - without[k - 1], now = with_task[k] - without[k];
    step = std::max(step, (now - before).lpNorm<Eigen::Infinity>());
    largest_change = std::max(largest_change, now.lpNorm<Eigen::Infinity>());
  }
  BOOST_CHECK_GT(largest_change, 1.0);
  // A quintic's steepest change of acceleration is 10.4 / T times its largest acceleration; a fifth more for the feedback.
  BOOST_CHECK_LE(step, 1.2 * 10.4 / 0.4 * 0.001 * largest_change);
}

BOOST_AUTO_TEST_CASE(a_known_force_at_a_hand_leaves_the_estimate_as_true_as_without_it) {
  const auto errors = [](const Vec3& force, bool told) {
    Carried walk(ramp(0.0, 1.0), with([](WalkSettings& s) { s.gait.stand = false; }));
    const int body = mj_name2id(mahru(), mjOBJ_BODY, "l_hand"), frame = walk.controller.watch("l_hand");
    std::array<std::vector<double>, 2> out;
    Vec6 w = Vec6::Zero();
    walk.walk_until(8.0, [&](const CycleOutput& cycle) {
      const double t = walk.data->time;
      w.head<3>() = std::min(1.0, std::max(0.0, t - 1.0)) * force;  // grows within a second
      // MuJoCo's force acts at the body's COM: moved there, with its moment.
      const Vec3 arm =
          Eigen::Map<const Vec3>(walk.data->xipos + 3 * body) - Eigen::Map<const Vec3>(walk.data->xpos + 3 * body);
      Eigen::Map<Vec6>{walk.data->xfrc_applied + 6 * body} << w.head<3>(), -arm.cross(Vec3(w.head<3>()));
      if (told) walk.sensed.external = {{frame, w}};
      if (t < 2.5) return;
      const Vec2 error = walk.estimate_error(cycle).cwiseAbs();
      out[0].push_back(error.x());
      out[1].push_back(error.y());
    });
    BOOST_TEST_MESSAGE("force " << force.transpose() << (told ? " told" : " untold") << ": median "
                                << 1e3 * percentile(out[0], 0.5) << ", " << 1e3 * percentile(out[1], 0.5) << " mm, p95 "
                                << 1e3 * percentile(out[0], 0.95) << ", " << 1e3 * percentile(out[1], 0.95));
    return out;
  };
  const auto free = errors(Vec3::Zero(), true);
  for (const Vec3& force : {Vec3(-20, 0, 0), Vec3(0, 20, 0), Vec3(0, 0, -20)}) {
    const auto known = errors(force, true);
    for (int i = 0; i < 2; ++i) {
      BOOST_CHECK_LE(percentile(known[i], 0.5), percentile(free[i], 0.5) + 5e-6);
      BOOST_CHECK_LE(percentile(known[i], 0.95), percentile(free[i], 0.95) + 1e-4);
    }
  }
  BOOST_CHECK_GT(percentile(errors(Vec3(-20, 0, 0), false)[0], 0.5), 10.0 * percentile(free[0], 0.5));  // untold
}

BOOST_AUTO_TEST_CASE(the_pendulum_takes_the_time_constant_of_a_known_vertical_force) {
  // A load on the trunk, told. What the pendulum leaves out is a moment, of legs that swing: the estimated ZMP less the reference, times the
  // load on the ground. The force on the trunk does not change it.
  const auto left_out = [](double load) {
    Carried walk(ramp(0.0, 1.0), with([](WalkSettings& s) { s.gait.stand = false; }));
    const int body = mj_name2id(mahru(), mjOBJ_BODY, "pelvis"), frame = walk.controller.watch("pelvis");
    const Dynamics& dyn = walk.controller.robot().dynamics();
    const double z_c = walk.controller.com_height(), g = dyn.gravity.norm();
    std::vector<double> moment;
    double off = 0.0;
    Vec6 w = Vec6::Zero();
    walk.walk_until(5.0, [&](const CycleOutput& cycle) {
      const double N = dyn.mass * g - w.z(), t = walk.data->time;
      off = std::max(off, gap(walk.controller.Tc(), std::sqrt(z_c * dyn.mass / N)));
      if (t > 2.5 && cycle.phase == 1) moment.push_back(N * std::abs(cycle.zmp_est.y() - cycle.zmp_ref.y()));
      w.z() = -std::min(1.0, std::max(0.0, t - 1.0)) * load;  // grows within a second
      const Vec3 arm =
          Eigen::Map<const Vec3>(walk.data->xipos + 3 * body) - Eigen::Map<const Vec3>(walk.data->xpos + 3 * body);
      Eigen::Map<Vec6>{walk.data->xfrc_applied + 6 * body} << w.head<3>(), -arm.cross(Vec3(w.head<3>()));
      walk.sensed.external = {{frame, w}};
    });
    CHECK_NEAR(off, 0.0, 1e-12);
    BOOST_TEST_MESSAGE("load " << load << " N: left out " << percentile(moment, 0.5) << " N m");
    return percentile(moment, 0.5);
  };
  BOOST_CHECK_CLOSE(left_out(150.0), left_out(0.0), 15.0);  // 43 % less with the time constant of the free robot
}

BOOST_AUTO_TEST_CASE(two_hands_carry_a_tray_while_the_robot_walks_and_turns) {
  const auto raised = [] {
    const RowMatX q = (RowMatX(2, 8) << 0.25, 0.15, -0.55, 0, 0.25, -0.15, -0.55, 0,  //
                       0.3, 0.1, -1.6, 0, 0.3, -0.1, -1.6, 0)
                          .finished();
    return JointMotion(Vec2(0, 1),
                       {"l_shoulder_pitch", "l_shoulder_roll", "l_elbow", "l_wrist_pitch", "r_shoulder_pitch",
                        "r_shoulder_roll", "r_elbow", "r_wrist_pitch"},
                       q);
  }();
  Carried walk(ramp(0.25, 2.0));
  walk.controller.move(raised);
  walk.walk_until(2.0, [](const CycleOutput&) {});
  std::array<int, 2> frame{walk.controller.watch("l_hand"), walk.controller.watch("r_hand")};
  std::array<Mat3, 2> R_H;
  const double heading = walk.controller.output().heading;
  for (const Side side : kSides)
    R_H[side] = rotation_z(heading).transpose() * walk.controller.robot().dynamics().frames[frame[side]].R_WF;
  for (const Side side : kSides) {
    const auto task = hand(side == kLeft ? "l_hand" : "r_hand", FramePart::kOrientation, RelativeTo::kWalk);
    PoseReference level;
    level.R = R_H[side];
    task->set(level);
    walk.controller.add(task);
  }
  walk.controller.command(Vec3(0.25, 0.0, 0.25));
  double worst = 0.0;
  walk.walk_until(9.0, [&](const CycleOutput& out) {
    if (out.t < 2.6) return;
    for (const Side side : kSides)
      worst = std::max(worst, orientation_error(rotation_z(out.heading) * R_H[side],
                                                walk.controller.robot().dynamics().frames[frame[side]].R_WF)
                                  .norm());
  });
  BOOST_TEST_MESSAGE("orientation within " << worst / kDegree << " deg");
  BOOST_CHECK_LE(worst, 1.0 * kDegree);
  BOOST_CHECK_GT(walk.controller.output().heading, 1.0);
}
