#include "robots.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/description.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// A leg of six hinges; `joint` and `site` go in where a test wants them wrong.
std::string leg(const std::string& side, double y, const std::string& site) {
  std::string text;
  for (int i = 0; i < 6; ++i) {
    text += "<body name='" + side + std::to_string(i) + "' pos='0 " + (i ? "0" : std::to_string(y)) +
            " -0.1'><joint name='" + side + "j" + std::to_string(i) + "' type='hinge' axis='" +
            (i % 2 ? "1 0 0" : "0 1 0") + "'/><geom size='0.03'/>";
  }
  return text + site + "</body></body></body></body></body></body>";
}

/// The smallest robot that can be described: a trunk and two legs.
std::string biped() {
  std::string text = "<mujoco><worldbody><body name='trunk' pos='0 0 0.7'><freejoint name='root'/><geom size='0.1'/>";
  text += leg("l", 0.1, "<site name='left_sole' type='box' size='0.1 0.05 0.001' pos='0.02 0 -0.03'/>");
  text += leg("r", -0.1, "<site name='right_sole' type='box' size='0.1 0.05 0.001' pos='0.02 0 -0.03'/>");
  text += "</body></worldbody><actuator>";
  for (const std::string side : {"l", "r"})
    for (int i = 0; i < 6; ++i) text += "<motor joint='" + side + "j" + std::to_string(i) + "'/>";
  return text +
         "</actuator><keyframe><key name='stand' qpos='0 0 0.63 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0'/></keyframe></mujoco>";
}

/// Describing the biped with one thing changed fails, and the message says `text`.
void refuses(const std::string& from, const std::string& to, const std::string& text) {
  std::string xml = replaced(biped(), from, to);
  if (to.empty() && from.find("freejoint") != std::string::npos) xml = replaced(xml, "0 0 0.63 1 0 0 0 ", "");
  const ModelPtr m = load_text(xml);
  CHECK_THROWS(describe(m.get()), ModelError, text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_robot_with_soles_and_a_stand_pose_describes_itself) {
  const ModelPtr m = load_text(biped());
  const RobotDescription robot = describe(m.get());
  BOOST_CHECK_EQUAL(robot.name, "trunk");
  BOOST_CHECK_EQUAL(robot.root_joint, "root");
  BOOST_CHECK_EQUAL(robot.stand_keyframe, "stand");
  BOOST_CHECK_EQUAL(robot.feet[kLeft].body, "l5");
  BOOST_CHECK_EQUAL(robot.feet[kRight].length, 0.2);
  BOOST_CHECK_EQUAL(robot.feet[kRight].width, 0.1);
  CHECK_NEAR(robot.feet[kLeft].sole_pos, Vec3(0.02, 0, -0.03), 0.0);
  BOOST_REQUIRE_EQUAL(robot.feet[kLeft].leg_joints.size(), 6U);
  BOOST_CHECK_EQUAL(robot.feet[kLeft].leg_joints.front(), "lj0");
  BOOST_CHECK_EQUAL(robot.feet[kLeft].leg_joints.back(), "lj5");
  BOOST_CHECK_EQUAL(robot.stand_joints.size(), 12U);
  CHECK_NEAR(robot.stand_base_pos, Vec3(0, 0, 0.63), 0.0);
}

BOOST_AUTO_TEST_CASE(the_bundled_humanoid_describes_itself) {
  const RobotDescription robot = describe(mahru());
  BOOST_CHECK_EQUAL(robot.stand_joints.size(), 25U);
  BOOST_CHECK_EQUAL(robot.feet[kLeft].length, 0.25);
  BOOST_CHECK_EQUAL(robot.feet[kLeft].width, 0.14);
}

BOOST_AUTO_TEST_CASE(a_model_that_cannot_walk_is_refused_with_what_is_missing) {
  refuses(
      "<freejoint name='root'/>", "",
      "fixed base: body 'trunk' has no free joint and is fixed to the world; a walking robot needs a floating base: "
      "write <freejoint name=\"root\"/> in it");
  refuses("<site name='left_sole'", "<site name='sole'", "no site 'left_sole'");
  refuses("<site name='left_sole'", "<site name='sole'", "it has sites: sole, right_sole");
  refuses("name='right_sole' type='box'", "name='right_sole' type='ellipsoid'", "'right_sole' is not a box");
  refuses("<key name='stand'", "<key name='home'", "no keyframe 'stand'");
  refuses("lj3' type='hinge'", "lj3' type='slide'", "leg joint 'lj3' is a slide joint; a leg is six hinges");
  refuses(
      "size='0.1 0.05 0.001'", "size='0.01 0.05 0.001'",
      "point foot: the left sole, of body 'l5', is 0.02 x 0.1 m, too small for a leg of 0.5 m, which takes at least "
      "0.05 x 0.02 m");
}

BOOST_AUTO_TEST_CASE(a_robot_with_a_ball_joint_or_a_joint_without_start_value_is_refused) {
  const RobotDescription good = describe(load_text(biped()).get());
  std::string text = biped();
  text.erase(text.find("<keyframe>"));  // its length is that of another robot
  const auto with = [&](const std::string& joint) {
    return load_text(replaced(text + "</mujoco>", "<freejoint name='root'/>",
                              "<freejoint name='root'/><body name='tail'>" + joint + "<geom size='0.1'/></body>"));
  };
  CHECK_THROWS(good.check(with("<joint name='tail' type='ball'/>").get()), ModelError,
               "joint 'tail' is neither hinge nor slide");
  CHECK_THROWS(good.check(with("<joint name='tail'/>").get()), ModelError, "no value for joint 'tail'");
  CHECK_THROWS(good.check(with("<joint/>").get()), ModelError, "at body 'tail' has no name");
}

BOOST_AUTO_TEST_CASE(a_description_with_a_wrong_name_or_number_is_refused) {
  const RobotDescription good = describe(mahru());
  BOOST_CHECK_NO_THROW(good.check(mahru()));
  const auto refused = [&](const auto& change, const std::string& text) {
    RobotDescription bad = good;
    change(bad);
    CHECK_THROWS(bad.check(mahru()), ModelError, text);
  };
  refused([](auto& d) { d.root_joint = "rot"; }, "no joint named 'rot'; it has: root, ");
  refused([](auto& d) { d.root_joint = "l_knee"; }, "'l_knee' is not a free joint");
  refused([](auto& d) { d.feet[kLeft].body = "paw"; }, "no body named 'paw'");
  refused([](auto& d) { d.feet[kRight].sole_site = "pad"; }, "no site named 'pad'");
  refused([](auto& d) { d.feet[kLeft].length = 0.0; }, "point foot: the left sole, of body 'l_foot', is 0 x 0.14 m");
  refused([](auto& d) { d.feet[kLeft].width = kNaN; }, "is 0.25 x nan m, too small");
  refused([](auto& d) { d.feet[kRight].leg_joints.pop_back(); },
          "the right leg that ends at body 'r_foot' has 5 joints");
  refused([](auto& d) { d.feet[kRight].leg_joints[0] = "l_knee"; },
          "the right leg lists joints that do not move its foot 'r_foot': 'l_knee'");
  refused([](auto& d) { d.feet[kLeft].leg_joints[1] = d.feet[kLeft].leg_joints[0]; }, "is listed twice");
  refused([](auto& d) { d.stand_joints.erase("waist_yaw"); }, "no value for joint 'waist_yaw'");
  refused([](auto& d) { d.stand_joints["waist_yaw"] = kNaN; }, "'waist_yaw' is nan; it must be finite");
  refused([](auto& d) { d.stand_joints["tail"] = 0.0; }, "no joint named 'tail'");
  refused([](auto& d) { d.stand_base_quat << 0, 0, 0, 0; }, "unit quaternion");
  refused([](auto& d) { d.stand_base_pos.x() = kNaN; }, "not a position");
}

BOOST_AUTO_TEST_CASE(placed_robot_stands_at_rest_with_flat_soles_on_the_ground) {
  const ModelPtr scene = mahru_in_a_scene();
  for (const mjModel* m : {mahru(), static_cast<const mjModel*>(scene.get())})
    for (const double ground : {0.0, 0.3}) {
      Robot robot(m, describe(mahru()));
      const MjDataPtr d = make_data(m);
      randomize(robot, d.get(), 11);
      const VecX before = Eigen::Map<const VecX>(d->qpos, robot.qpos_address());
      robot.description().place(m, d.get(), ground);
      robot.read(d.get());
      const Dynamics& dyn = robot.dynamics();
      for (const FrameState& sole : dyn.sole) {
        CHECK_NEAR(sole.p_WF.z(), ground, 1e-9);
        CHECK_NEAR(sole.R_WF, Mat3::Identity(), 1e-9);
      }
      CHECK_NEAR(dyn.dq, VecX::Zero(31), 0.0);
      CHECK_NEAR(dyn.q, robot.stand(), 0.0);
      for (const Side side : kSides) BOOST_CHECK_GE(dyn.q[robot.leg_joints()[side][3]], 0.3);  // knees bent
      BOOST_CHECK_GT(robot.joint_margin(d.get()), 0.0);
      CHECK_NEAR(Eigen::Map<const VecX>(d->qpos, robot.qpos_address()), before, 0.0);  // the box stays
    }
}

BOOST_AUTO_TEST_CASE(placed_without_a_height_soles_are_on_a_floor_that_is_above_them) {
  const std::string floor = R"(<geom name="floor" type="plane" size="0 0 0.05" material="floor")";
  for (const double height : {-0.02, 0.0, 0.002, 0.03, 0.1}) {
    const ModelPtr m = load_text(replaced(mahru_text(), floor, floor + " pos='0 0 " + std::to_string(height) + "'"));
    Robot robot(m.get(), describe(m.get()));
    const MjDataPtr d = make_data(m.get());
    robot.description().place(m.get(), d.get());
    robot.read(d.get());
    for (const FrameState& sole : robot.dynamics().sole) CHECK_NEAR(sole.p_WF.z(), std::max(height, 0.0), 1e-9);
    robot.description().place(m.get(), d.get(), 0.0);
    robot.read(d.get());
    for (const FrameState& sole : robot.dynamics().sole) CHECK_NEAR(sole.p_WF.z(), 0.0, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(placing_with_a_wrong_description_changes_nothing) {
  RobotDescription bad = describe(mahru());
  bad.stand_joints["tail"] = 0.0;
  const MjDataPtr d = make_data(mahru());
  const VecX before = Eigen::Map<const VecX>(d->qpos, mahru()->nq);
  CHECK_THROWS(bad.place(mahru(), d.get()), ModelError, "tail");
  CHECK_THROWS(describe(mahru()).place(mahru(), d.get(), kNaN), InputError, "ground = nan");
  CHECK_NEAR(Eigen::Map<const VecX>(d->qpos, mahru()->nq), before, 0.0);
}

BOOST_AUTO_TEST_CASE(a_motor_that_can_only_push_is_refused) {
  const ModelPtr m = load_text(replaced(mahru_text(), "<motor class=\"knee\" name=\"l_knee\"",
                                        "<motor class=\"knee\" ctrlrange=\"5 9\" name=\"l_knee\""));
  CHECK_THROWS(Robot(m.get(), describe(m.get())), ModelError,
               "motor of joint 'l_knee' has a ctrl range without 0 inside");
}
