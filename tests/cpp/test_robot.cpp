#include <cmath>
#include <functional>
#include <vector>

#include "robots.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"
#include "zmpwalk/robot/contact_forces.hpp"
#include "zmpwalk/robot/robot.hpp"
#include "zmpwalk/robot/shape.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// A robot in a model, with a random state; by itself or as the third tree of a scene.
struct Placed {
  explicit Placed(const mjModel* model, unsigned seed = 0) : m(model), robot(m, describe(mahru())), data(make_data(m)) {
    randomize(robot, data.get(), seed);
    read();
  }
  void read() { robot.read(data.get()); }
  const Dynamics& dyn() const { return robot.dynamics(); }
  /// The state `time` later at constant velocity `dq` (nv,) of the robot, read.
  void moved(const VecX& dq, double time) {
    VecX all = VecX::Zero(m->nv);
    all.segment(robot.dof_address(), robot.nv()) = dq;
    mj_integratePos(m, data->qpos, all.data(), time);
    read();
  }

  const mjModel* m;
  Robot robot;
  MjDataPtr data;
};

const mjModel* scene() {
  static const ModelPtr m = mahru_in_a_scene();
  return m.get();
}

/// All that depends on the state, by central differences along the robot's velocity.
template <class Quantity>
VecX rate(unsigned seed, const VecX& dq, Quantity&& quantity, const mjModel* m = mahru()) {
  const double h = 1e-5;
  Placed before(m, seed), after(m, seed);
  before.moved(dq, -h);
  after.moved(dq, h);
  return (quantity(after.dyn()) - quantity(before.dyn())) / (2 * h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(sole_jacobian_is_the_difference_of_sole_poses) {
  for (const mjModel* m : {mahru(), scene()})
    for (const Side side : kSides) {
      const Placed at(m, 1);
      const Mat3 R = at.dyn().sole[side].R_WF;
      const auto pose = [&](const Dynamics& dyn) {
        return (VecX(6) << dyn.sole[side].p_WF, orientation_error(dyn.sole[side].R_WF, R)).finished();
      };
      for (int i = 0; i < at.robot.nv(); ++i)
        CHECK_NEAR(rate(1, VecX::Unit(at.robot.nv(), i), pose, m), VecX(at.dyn().sole[side].J.col(i)), 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(com_jacobian_is_the_difference_of_the_com_and_mujocos) {
  for (const mjModel* m : {mahru(), scene()}) {
    const Placed at(m, 2);
    for (int i = 0; i < at.robot.nv(); ++i)
      CHECK_NEAR(rate(
                     2, VecX::Unit(at.robot.nv(), i), [](const Dynamics& dyn) { return VecX(dyn.com); }, m),
                 VecX(at.dyn().J_com.col(i)), 1e-8);
    RowMatX J(3, m->nv);
    mj_forward(m, at.data.get());
    mj_jacSubtreeCom(m, at.data.get(), J.data(), at.robot.root_body());
    CHECK_NEAR(J.middleCols(at.robot.dof_address(), at.robot.nv()), at.dyn().J_com, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(velocities_are_jacobian_times_dq) {
  const Placed at(mahru(), 3);
  CHECK_NEAR(at.dyn().dcom, at.dyn().J_com * at.dyn().dq, 1e-12);
  for (const FrameState& sole : at.dyn().sole) CHECK_NEAR(sole.velocity, sole.J * at.dyn().dq, 1e-12);
  CHECK_NEAR(
      VecX(at.dyn().omega_WB),
      rate(3, at.dyn().dq, [&](const Dynamics& dyn) { return VecX(orientation_error(dyn.R_WB, at.dyn().R_WB)); }),
      1e-8);
}

BOOST_AUTO_TEST_CASE(drift_is_the_rate_of_the_velocity_without_acceleration) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Placed at(mahru(), seed);
    const VecX dq = at.dyn().dq;
    CHECK_NEAR(rate(seed, dq, [&](const Dynamics& dyn) { return VecX(dyn.J_com * dq); }), VecX(at.dyn().drift_com),
               1e-7);
    for (const Side side : kSides)
      CHECK_NEAR(rate(seed, dq, [&](const Dynamics& dyn) { return VecX(dyn.sole[side].J * dq); }),
                 VecX(at.dyn().sole[side].drift), 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(inertia_is_mujocos_column_by_column) {
  for (const mjModel* m : {mahru(), scene()}) {
    const Placed at(m, 4);
    mj_forward(m, at.data.get());
    for (int i = 0; i < at.robot.nv(); ++i) {
      const VecX unit = VecX::Unit(m->nv, at.robot.dof_address() + i);
      VecX column(m->nv);
      mj_mulM(m, at.data.get(), column.data(), unit.data());
      CHECK_NEAR(column.segment(at.robot.dof_address(), at.robot.nv()), VecX(at.dyn().A.col(i)), 1e-12);
    }
    CHECK_NEAR(at.dyn().A, at.dyn().A.transpose(), 0.0);
    CHECK_NEAR(at.dyn().A(0, 0), at.dyn().mass, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(velocity_and_gravity_terms_are_mujocos_bias) {
  for (const mjModel* m : {mahru(), scene()}) {
    Placed at(m, 5);
    mj_forward(m, at.data.get());
    const Eigen::Map<const VecX> bias(at.data->qfrc_bias + at.robot.dof_address(), at.robot.nv());
    CHECK_NEAR(at.dyn().b + at.dyn().g, bias, 1e-10);
    CHECK_NEAR(at.dyn().g.head<3>(), Vec3(-at.dyn().mass * at.dyn().gravity), 1e-11);
    CHECK_NEAR(at.dyn().mass * at.dyn().drift_com, at.dyn().drift_momentum.head<3>(), 1e-12);
    Eigen::Map<VecX>(at.data->qvel, m->nv).setZero();
    at.read();
    CHECK_NEAR(at.dyn().b, VecX::Zero(at.robot.nv()), 1e-10);  // at rest nothing but gravity is left
  }
}

BOOST_AUTO_TEST_CASE(passive_forces_and_dry_friction_enter_b_but_not_the_com_drift) {
  const ModelPtr stiff = load_text(replaced(mahru_text(), "armature=\"0.05\" damping=\"0\"",
                                            "armature=\"0.05\" damping=\"0.7\" frictionloss=\"0.4\" stiffness=\"3\""));
  const Placed bare(mahru(), 6), at(stiff.get(), 6);
  VecX passive = VecX::Zero(at.robot.nv());
  for (int j = 0; j < at.robot.joints(); ++j)
    passive[6 + j] = 0.7 * at.dyn().dq[6 + j] + 3.0 * at.dyn().q[j] + 0.4 * std::tanh(at.dyn().dq[6 + j] / 0.02);
  CHECK_NEAR(at.dyn().b, bare.dyn().b + passive, 1e-10);
  CHECK_NEAR(at.dyn().g, bare.dyn().g, 0.0);
  CHECK_NEAR(at.dyn().drift_com, bare.dyn().drift_com, 0.0);
}

BOOST_AUTO_TEST_CASE(free_joint_turns_in_its_own_axes_and_moves_in_the_worlds) {
  Placed at(mahru(), 7);
  CHECK_NEAR(at.dyn().omega_WB, at.dyn().R_WB * at.dyn().dq.segment<3>(3), 1e-14);
  const Vec3 p = at.dyn().p_WB;
  at.moved(VecX::Unit(31, 0), 0.3);
  CHECK_NEAR(at.dyn().p_WB, p + Vec3(0.3, 0, 0), 1e-14);
}

BOOST_AUTO_TEST_CASE(robot_is_the_same_wherever_its_tree_stands_in_the_model) {
  const Placed alone(mahru(), 8), third(scene(), 8);
  BOOST_CHECK_EQUAL(third.robot.dof_address(), 7);
  BOOST_CHECK_EQUAL(third.robot.qpos_address(), 8);
  const Dynamics &a = alone.dyn(), &b = third.dyn();
  CHECK_NEAR(a.A, b.A, 1e-12);
  CHECK_NEAR(a.b, b.b, 1e-12);
  CHECK_NEAR(a.g, b.g, 1e-12);
  CHECK_NEAR(a.com, b.com, 1e-14);
  CHECK_NEAR(a.drift_com, b.drift_com, 1e-12);
  CHECK_NEAR(a.q, b.q, 0.0);
  BOOST_CHECK_EQUAL(a.mass, b.mass);
  for (const Side side : kSides) {
    CHECK_NEAR(a.sole[side].J, b.sole[side].J, 1e-13);
    CHECK_NEAR(a.sole[side].drift, b.sole[side].drift, 1e-12);
  }
  BOOST_CHECK(alone.robot.joint_names() == third.robot.joint_names());
  BOOST_CHECK(alone.robot.leg_joints() == third.robot.leg_joints());
}

BOOST_AUTO_TEST_CASE(torque_goes_to_the_motor_of_each_joint_by_name) {
  const ModelPtr geared = load_text(replaced(mahru_text(), "<motor class=\"knee\" name=\"l_knee\"",
                                             "<motor class=\"knee\" gear=\"-20\" name=\"l_knee\""));
  for (const mjModel* m : {scene(), static_cast<const mjModel*>(geared.get())}) {
    Placed at(m, 9);
    const VecX tau = Numbers(10).vector(at.robot.joints(), 10.0);
    at.robot.write_torque(tau, at.data.get());
    mj_forward(m, at.data.get());
    const Eigen::Map<const VecX> applied(at.data->qfrc_actuator, m->nv);
    CHECK_NEAR(applied.segment(at.robot.dof_address() + 6, at.robot.joints()), tau, 1e-12);
    CHECK_NEAR(applied.squaredNorm(), tau.squaredNorm(), 1e-9);  // and nowhere else
  }
  const Placed at(geared.get());
  BOOST_CHECK_EQUAL(at.robot.torque_limit()[at.robot.leg_joints()[kLeft][3]],
                    20 * at.robot.torque_limit()[at.robot.leg_joints()[kRight][3]]);
}

BOOST_AUTO_TEST_CASE(torque_reaches_a_joint_past_its_servo) {
  // A position servo that its ctrlrange and forcerange both clip: 300 (0.1 - 0.785) is cut to -50 N m.
  const ModelPtr m =
      load_text(replaced(mahru_text(), "<motor class=\"knee\" name=\"l_knee\"",
                         "<position kp=\"300\" ctrlrange=\"-0.1 0.1\" forcerange=\"-50 50\" name=\"l_knee\""));
  Placed at(m.get(), 9);
  const VecX tau = Numbers(10).vector(at.robot.joints(), 10.0);
  at.robot.write_torque(tau, at.data.get());
  mj_forward(m.get(), at.data.get());
  const int knee = at.robot.leg_joints()[kLeft][3], dof = at.robot.dof_address() + 6 + knee;
  const Eigen::Map<const VecX> actuators(at.data->qfrc_actuator, m->nv), applied(at.data->qfrc_applied, m->nv);
  CHECK_NEAR((actuators + applied).tail(at.robot.joints()), tau, 1e-12);
  BOOST_CHECK_EQUAL(actuators[dof], -50.0);
  BOOST_CHECK_EQUAL(at.robot.torque_limit()[knee], 50.0);
  BOOST_CHECK_EQUAL(at.robot.drives()[knee].path, "qfrc_applied: position servo 'l_knee' is silenced");
  BOOST_CHECK_EQUAL((applied.array() != 0.0).count(), 1);
}

BOOST_AUTO_TEST_CASE(robot_knows_its_legs) {
  const Placed at(mahru());
  BOOST_CHECK_EQUAL(at.robot.joints(), 25);
  for (const Side side : kSides) {
    const std::string prefix = side == kLeft ? "l_" : "r_";
    const auto& leg = at.robot.leg_joints()[side];
    BOOST_CHECK_EQUAL(at.robot.joint_names()[leg[3]], prefix + "knee");
    BOOST_CHECK_EQUAL(at.robot.pitch_joint(side, 0, 3), leg[2]);
    BOOST_CHECK_EQUAL(at.robot.pitch_joint(side, 4, 6), leg[4]);
    const int motor = mj_name2id(mahru(), mjOBJ_ACTUATOR, (prefix + "knee").c_str());
    BOOST_CHECK_EQUAL(at.robot.torque_limit()[leg[3]], mahru()->actuator_ctrlrange[2 * motor + 1]);
    const auto length = [&](const std::string& link) {  // of the link above: the distance to the parent body
      return Eigen::Map<const Vec3>(mahru()->body_pos + 3 * mj_name2id(mahru(), mjOBJ_BODY, (prefix + link).c_str()))
          .norm();
    };
    CHECK_NEAR(at.robot.leg_at_stand(side).thigh, length("shank"), 1e-12);
    CHECK_NEAR(at.robot.leg_at_stand(side).shank, length("ankle"), 1e-12);
    CHECK_NEAR(at.robot.ankle_in_sole(side), Vec3(-at.robot.description().feet[side].sole_pos),
               1e-9);  // the foot body sits in the ankle
    BOOST_CHECK(at.robot.is_foot(side, at.robot.foot_body(side)) &&
                !at.robot.is_foot(side, at.robot.foot_body(other(side))));
  }
}

BOOST_AUTO_TEST_CASE(joint_margin_is_the_distance_to_the_nearest_limit) {
  Placed at(mahru());
  at.robot.description().place(mahru(), at.data.get());
  at.data->qpos[at.robot.qpos_address() + 7 + at.robot.leg_joints()[kRight][3]] = 0.05;  // knee range from 0
  CHECK_NEAR(at.robot.joint_margin(at.data.get()), 0.05, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_state_with_nan_or_infinity_is_not_finite) {
  Placed at(scene(), 12);
  BOOST_CHECK(at.robot.is_finite(at.data.get()));
  at.data->qpos[0] = kNaN;  // the box's, not the robot's
  BOOST_CHECK(at.robot.is_finite(at.data.get()));
  at.data->qvel[at.robot.dof_address() + 30] = INFINITY;
  BOOST_CHECK(!at.robot.is_finite(at.data.get()));
}

BOOST_AUTO_TEST_CASE(measured_wrench_is_what_the_contacts_do_to_the_base) {
  for (const mjModel* m : {mahru(), scene()}) {
    Placed at(m);
    at.robot.description().place(m, at.data.get());
    at.data->qvel[at.robot.dof_address() + 2] = -0.1;  // press the soles onto the ground
    at.data->qpos[at.robot.qpos_address() + 2] -= 1e-3;
    mj_forward(m, at.data.get());
    at.read();
    const MeasuredContact contact = measure_contact(at.robot, at.data.get());
    const Sensed felt = felt_by(contact);
    for (const Side side : kSides) {
      BOOST_CHECK_EQUAL(felt.contact[side], 1.0);
      CHECK_NEAR(felt.wrench[side], contact.wrench.segment<6>(6 * side), 0.0);
    }
    const Vec3 p = at.dyn().p_WB;
    const Wrench total = total_wrench(contact.wrench, contact.sole, p);
    const mjtNum* constraint = at.data->qfrc_constraint + at.robot.dof_address();
    CHECK_NEAR(total.F, Vec3(-Eigen::Map<const Vec3>(constraint)), 1e-9);
    CHECK_NEAR(total.M, Vec3(-(at.dyn().R_WB * Eigen::Map<const Vec3>(constraint + 3))), 1e-9);
    BOOST_CHECK_LT(total.F.z(), -100.0);
    CHECK_NEAR(contact.sole[kLeft], at.dyn().sole[kLeft].p_WF, 1e-14);
    const Wrench about = total_wrench(contact.wrench, contact.sole, Vec3::Zero());
    CHECK_NEAR(measured_zmp(contact, Plane{}), Vec2(-about.M.y() / about.F.z(), about.M.x() / about.F.z()), 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_foot_in_the_air_has_no_wrench_and_no_zmp) {
  Placed at(mahru());
  at.robot.description().place(mahru(), at.data.get());
  at.data->qpos[at.robot.qpos_address() + 2] += 0.2;
  mj_forward(mahru(), at.data.get());
  const MeasuredContact contact = measure_contact(at.robot, at.data.get());
  BOOST_CHECK(contact.wrench.array().isNaN().all());
  BOOST_CHECK(measured_zmp(contact).array().isNaN().all());
  const Sensed felt = felt_by(contact);
  for (const Side side : kSides) {
    BOOST_CHECK_EQUAL(felt.contact[side], 0.0);
    BOOST_CHECK(felt.wrench[side].array().isNaN().all());
  }
}

BOOST_AUTO_TEST_CASE(a_state_has_sizes_of_the_robot_finite_numbers_and_a_quaternion_with_a_direction) {
  const State good(31);
  BOOST_CHECK_NO_THROW(require_state(good, 31));
  CHECK_THROWS(require_state(good, 30), DimensionError, "state.q");
  const auto refused = [&](const std::function<void(State&)>& spoil, const std::string& words) {
    State bad = good;
    spoil(bad);
    CHECK_THROWS(require_state(bad, 31), InputError, words);
  };
  refused([](State& s) { s.time = INFINITY; }, "not finite");
  refused([](State& s) { s.q[9] = kNaN; }, "not finite");
  refused([](State& s) { s.dq[30] = -INFINITY; }, "not finite");
  refused([](State& s) { s.q.segment<4>(3).setZero(); },
          "state.q[3:7], has the length 0.000000; it must have the length 1");
  refused([](State& s) { s.q.segment<4>(3) *= 1e-9; }, "length");
  State longer = good;
  longer.q.segment<4>(3) *= 3.0;  // a direction still: MuJoCo makes it a unit quaternion
  BOOST_CHECK_NO_THROW(require_state(longer, 31));
  longer.dq.resize(3);
  CHECK_THROWS(require_state(longer, 31), DimensionError, "state.dq");
}

BOOST_AUTO_TEST_CASE(views_point_into_the_structs_of_mujoco) {
  const mjModel* m = mahru();
  const MjDataPtr d = make_data(m);
  const Model model(m);
  const Data data(d.get());
  BOOST_CHECK(model.handle == m && data.handle == d.get());
  BOOST_CHECK_EQUAL(model.nv, m->nv);
  BOOST_CHECK(model.body_pos == m->body_pos && model.jnt_range == m->jnt_range);
  BOOST_CHECK(data.qpos == d->qpos && data.qfrc_bias == d->qfrc_bias && data.time == &d->time);
  BOOST_CHECK_EQUAL(*model.timestep, m->opt.timestep);
}

BOOST_AUTO_TEST_CASE(numbers_of_kinds_are_those_of_mujoco) {
  const mjModel* m = mahru();
  const auto number = [&](int object, const char* name) { return mj::name2id(m, object, name); };
  BOOST_CHECK_EQUAL(number(mj::kBody, "r_foot"), mj_name2id(m, mjOBJ_BODY, "r_foot"));
  BOOST_CHECK_EQUAL(number(mj::kJoint, "r_knee"), mj_name2id(m, mjOBJ_JOINT, "r_knee"));
  BOOST_CHECK_EQUAL(number(mj::kSite, "left_hand"), mj_name2id(m, mjOBJ_SITE, "left_hand"));
  BOOST_CHECK_EQUAL(number(mj::kKey, "stand"), mj_name2id(m, mjOBJ_KEY, "stand"));
  BOOST_CHECK(number(mj::kJoint, "r_knee") > 0 && number(mj::kSite, "left_hand") >= 0);
}

BOOST_AUTO_TEST_CASE(inertia_times_a_vector_is_that_of_mujoco) {
  const mjModel* m = mahru();
  const MjDataPtr d = make_data(m);
  mj_forward(m, d.get());
  const Data data(d.get());
  RowMatX ours = RowMatX::Zero(m->nv, m->nv);
  mj::compute_inertia(m, data);
  mj::inertia(m, data, 0, static_cast<int>(m->nv), ours.data());
  VecX force = VecX::LinSpaced(m->nv, -1.0, 1.0), product(m->nv);
  mj_mulM(m, d.get(), product.data(), force.data());
  BOOST_CHECK_SMALL((ours * force - product).norm(), 1e-10);
}

BOOST_AUTO_TEST_CASE(shapes_reach_as_far_as_the_points_on_their_surface) {
  const ModelPtr m = load_text(R"(<mujoco>
    <asset><mesh name="wedge" vertex="0.1 0 0  -0.1 0.02 0  -0.1 -0.05 0  0 0 0.08"/></asset>
    <worldbody>
      <geom type="sphere" size="0.07"/>
      <geom type="capsule" size="0.03 0.1"/>
      <geom type="ellipsoid" size="0.03 0.1 0.05"/>
      <geom type="cylinder" size="0.06 0.02"/>
      <geom type="box" size="0.03 0.1 0.05"/>
      <geom type="mesh" mesh="wedge"/>
    </worldbody></mujoco>)");
  // Points on the surface, from two numbers in [0, 1) and a sign.
  const auto on_sphere = [](double a, double b) {
    const double z = 2 * a - 1, r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(2 * M_PI * b), r * std::sin(2 * M_PI * b), z);
  };
  const auto point = [&](int geom, double a, double b, double sign) -> Vec3 {
    const Eigen::Map<const Vec3> size(m->geom_size + 3 * geom);
    const Vec3 s = on_sphere(a, b);
    switch (geom) {
      case 0:
        return size[0] * s;
      case 1:
        return size[0] * s + std::copysign(size[1], s.z()) * Vec3::UnitZ();
      case 2:
        return size.cwiseProduct(s);
      case 3:
        return {size[0] * std::cos(2 * M_PI * b), size[0] * std::sin(2 * M_PI * b), sign * size[1]};
      default:
        return {std::copysign(size[0], s.x()), std::copysign(size[1], s.y()), std::copysign(size[2], s.z())};
    }
  };
  Numbers numbers(5);
  for (int geom = 0; geom < 5; ++geom)
    for (int n = 0; n < 20; ++n) {
      const Vec3 towards = Vec3(numbers.vector(3, 1.0)).normalized();
      double farthest = 0.0;
      for (int k = 0; k < 20000; ++k)
        farthest = std::max(farthest,
                            towards.dot(point(geom, numbers.uniform(0, 1), numbers.uniform(0, 1), k % 2 ? 1.0 : -1.0)));
      const double extent = Shape{m.get(), geom}.extent(towards);
      BOOST_CHECK_GE(extent, farthest - 1e-12);
      BOOST_CHECK_LE(extent, farthest + 2e-3);
    }
  // The mesh's own origin is where MuJoCo puts it, so lengths are compared.
  const Shape wedge{m.get(), 5};
  const Eigen::Quaterniond turn(m->geom_quat[20], m->geom_quat[21], m->geom_quat[22], m->geom_quat[23]);
  const Vec3 x = turn.inverse() * Vec3::UnitX(), z = turn.inverse() * Vec3::UnitZ();
  CHECK_NEAR(wedge.extent(x) + wedge.extent(-x), 0.2, 1e-6);
  CHECK_NEAR(wedge.extent(z) + wedge.extent(-z), 0.08, 1e-6);
}

BOOST_AUTO_TEST_CASE(foot_reaches_to_the_edges_of_its_shapes) {
  const Robot robot(mahru(), describe(mahru()));
  for (const Side side : kSides) {
    const Foot& foot = robot.description().feet[side];
    CHECK_NEAR(robot.foot_reach(side), 0.5 * Vec2(foot.length, foot.width), 1e-9);
  }
}
