#include "zmpwalk/robot/rules/model_rules.hpp"

#include "robots.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/robot/rules/leg_rules.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

std::vector<std::string> rules(const Reasons& reasons) {
  std::vector<std::string> out;
  for (const Reason& reason : reasons) out.push_back(reason.rule);
  return out;
}

/// The reasons are of these rules, in this order.
void check_rules(const Reasons& reasons, const std::vector<std::string>& expected) {
  const std::vector<std::string> found = rules(reasons);
  BOOST_CHECK_EQUAL_COLLECTIONS(found.begin(), found.end(), expected.begin(), expected.end());
  for (const Reason& reason : reasons) BOOST_TEST_MESSAGE(reason.text);
}

/// The bundled robot with one text in its file replaced.
ModelPtr mahru_with(const std::string& from, const std::string& to) {
  return load_text(replaced(mahru_text(), from, to));
}

const std::string kClasp =
    "<equality><connect name='clasp' body1='l_hand' body2='r_hand' anchor='0 0 0'/></equality><actuator>";

}  // namespace

BOOST_AUTO_TEST_CASE(a_robot_that_walks_gives_no_reason) {
  const ModelPtr scene = mahru_in_a_scene();
  for (const mjModel* m : {mahru(), static_cast<const mjModel*>(scene.get())}) {
    check_rules(model_reasons(m, describe(mahru())), {});
    check_rules(model_reasons(m), {});
  }
}

BOOST_AUTO_TEST_CASE(three_broken_rules_give_three_reasons_and_the_error_a_line_for_each) {
  const ModelPtr m = mahru_with("<actuator>", kClasp);
  m->opt.gravity[0] = 1.0;
  RobotDescription description = describe(mahru());
  description.feet[kLeft].leg_joints.pop_back();
  const Reasons reasons = model_reasons(m.get(), description);
  check_rules(reasons, {"leg", "equality", "gravity"});
  BOOST_CHECK_EQUAL(reasons[0].text,
                    "the left leg that ends at body 'l_foot' has 5 joints ('l_hip_yaw', 'l_hip_roll', 'l_hip_pitch', "
                    "'l_knee', 'l_ankle_pitch'); placing a flat foot anywhere takes 6: hip 3, knee 1, ankle 2; of the "
                    "joints that move this foot these are not listed: 'l_ankle_roll'");
  try {
    description.check(m.get());
    BOOST_ERROR("nothing was thrown");
  } catch (const ModelError& error) {
    BOOST_CHECK_EQUAL(error.what(), reasons[0].text + "\n" + reasons[1].text + "\n" + reasons[2].text);
    BOOST_REQUIRE_EQUAL(error.reasons.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) BOOST_CHECK_EQUAL(error.reasons[i], reasons[i].text);
  }
}

BOOST_AUTO_TEST_CASE(names_that_do_not_exist_are_one_reason_for_each_kind_and_hide_no_other) {
  RobotDescription description = describe(mahru());
  description.root_joint = "rot";
  description.feet[kRight].leg_joints[2] = "r_hipp";
  description.feet[kRight].sole_site = "pad";
  description.torque_limits["r_hipp"] = -1.0;
  const Reasons reasons = model_reasons(mahru(), description);
  check_rules(reasons, {"names", "names", "motor"});
  BOOST_CHECK_EQUAL(reasons[0].text.substr(0, 53), "the model has no joint named 'rot', 'r_hipp'; it has:");
}

BOOST_AUTO_TEST_CASE(a_description_of_nothing_is_refused) {
  RobotDescription description = describe(mahru());
  for (Foot& foot : description.feet) foot.body = "world", foot.leg_joints.clear();
  check_rules(model_reasons(mahru(), description), {"leg", "leg"});
  description.root_joint.clear();
  for (Foot& foot : description.feet) foot.sole_site.clear();
  check_rules(model_reasons(mahru(), description), {"base"});
  check_rules(model_reasons(mahru(), RobotDescription()), {"names"});
  const LegParts nowhere{"left", 99, {}, {}};
  CHECK_THROWS(model_reasons(mahru(), {1, {nowhere, nowhere}, Vec3::Zero()}), InputError, "body 99 does not exist");
  CHECK_THROWS(model_reasons(mahru(), {1, {nowhere}, Vec3::Zero()}), InputError, "the robot has 1 legs");
}

BOOST_AUTO_TEST_CASE(every_foot_and_joint_that_breaks_a_rule_is_told) {
  RobotDescription description = describe(mahru());
  for (Foot& foot : description.feet) foot.length = 0.02;
  description.stand_joints.erase("waist_yaw");
  description.stand_joints.erase("l_knee");
  description.stand_joints["r_knee"] = kNaN;
  const Reasons reasons = model_reasons(mahru(), description);
  check_rules(reasons, {"sole", "sole", "stand", "stand"});
  BOOST_CHECK_EQUAL(reasons[2].text, "the start pose has no value for joint 'l_knee', 'waist_yaw'");
}

BOOST_AUTO_TEST_CASE(a_base_that_is_no_free_joint_is_told_with_its_joints_and_what_to_write) {
  const std::string free = "<freejoint name=\"root\"/>", ball = "<joint name='turn' type='ball'/>";
  const std::string slides =
      "<joint name='x' type='slide' axis='1 0 0'/><joint name='y' type='slide' axis='0 1 0'/>"
      "<joint name='z' type='slide'/>";
  std::string text = mahru_text();
  text.erase(text.find("<keyframe>"), text.find("</keyframe>") + 11 - text.find("<keyframe>"));
  const auto reason = [&](const std::string& base) {
    const ModelPtr m = load_text(replaced(text, free, base));
    const Reasons reasons = model_reasons(m.get());
    check_rules(reasons, {"base"});
    RobotDescription description = describe(mahru());
    check_rules(model_reasons(m.get(), description), {"base", "names"});  // no joint 'root'
    description.root_joint.clear();
    check_rules(model_reasons(m.get(), description), {"base"});
    BOOST_CHECK_EQUAL(model_reasons(m.get(), description).front().text, reasons.front().text);
    return reasons.front().text;
  };
  BOOST_CHECK_EQUAL(reason(slides + ball),
                    "no floating base: body 'pelvis' hangs from the world by 'x' (slide), 'y' (slide), 'z' (slide), "
                    "'turn' (ball) and has no free joint; a walking robot needs a floating base: write <freejoint "
                    "name=\"root\"/> in body 'pelvis' in place of these joints, whose actuators, sensors and keyframe "
                    "values go too");
  BOOST_CHECK_NE(reason("<joint name='swing'/>").find("by 'swing' (hinge) and"), std::string::npos);
  BOOST_CHECK_EQUAL(reason("").substr(0, 63), "fixed base: body 'pelvis' has no free joint and is fixed to the");
}

BOOST_AUTO_TEST_CASE(joints_of_the_base_on_links_of_their_own_are_told_too) {
  const std::string link = "<inertial pos='0 0 0' mass='0.001' diaginertia='1e-6 1e-6 1e-6'/>";
  std::string legs;
  for (const std::string name : {"a", "b"})
    legs += "<body name='" + name + "'><joint name='hip_" + name + "'/><geom size='0.1'/></body>";
  const ModelPtr m = load_text("<mujoco><worldbody><body name='cart'><joint name='x' type='slide'/>" + link +
                               "<body name='mast'><joint name='z' type='slide'/>" + link +
                               "<body name='trunk'><joint name='turn' type='ball'/><geom size='0.2'/>" + legs +
                               "</body></body></body></worldbody></mujoco>");
  const Reasons reasons = model_reasons(m.get());
  check_rules(reasons, {"base"});
  BOOST_CHECK_EQUAL(
      reasons[0].text.substr(0, 97),
      "no floating base: body 'cart' hangs from the world by 'x' (slide), 'z' (slide), 'turn' (ball) and");
}

BOOST_AUTO_TEST_CASE(a_sole_on_the_ankles_other_link_is_told_with_the_joint_below_and_the_link_of_the_sole) {
  RobotDescription description = describe(mahru());
  description.feet[kLeft].body = "l_ankle";
  description.feet[kLeft].sole_site.clear();
  description.feet[kLeft].leg_joints.pop_back();
  const Reasons reasons = model_reasons(mahru(), description);
  check_rules(reasons, {"leg"});
  BOOST_CHECK_NE(reasons[0].text.find("ankle 2; below body 'l_ankle' hangs joint 'l_ankle_roll': if the ankle goes on "
                                      "there, the sole's geoms and site belong to body 'l_foot'"),
                 std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_leg_without_knee_in_fourth_place_or_without_ankle_roll_is_told_by_its_axes) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const auto with = [&](const std::array<Vec3, 6>& turns) {
    LegAxes axes;
    for (int i = 0; i < 6; ++i) axes.col(i) = turns[i];
    Reasons out;
    add_leg_axes("the leg", axes, x, y, out);
    std::string text;
    for (const Reason& reason : out) text += reason.text.substr(0, reason.text.find(':')) + ".";
    return text;
  };
  BOOST_CHECK_EQUAL(with({z, x, y, y, y, x}), "");
  BOOST_CHECK_EQUAL(with({z, x, -y, y, x, -y}), "");
  BOOST_CHECK_EQUAL(with({y, y, z, x, y, x}), "the leg is not hip 3 joints, knee, ankle 2.");
  BOOST_CHECK_EQUAL(with({z, x, z, y, y, x}), "the leg is not hip 3 joints, knee, ankle 2.");
  BOOST_CHECK_EQUAL(with({z, x, y, y, y, z}), "the leg has no ankle roll.");
  BOOST_CHECK_EQUAL(with({z, x, y, y, z, z}), "the leg has no ankle pitch.the leg has no ankle roll.");
}

BOOST_AUTO_TEST_CASE(what_is_wrong_with_both_soles_of_a_start_pose_is_told_of_both) {
  RobotDescription description = describe(mahru());
  description.stand_base_pos.z() += 0.2;
  try {
    Robot(mahru(), description);
    BOOST_ERROR("nothing was thrown");
  } catch (const ModelError& error) {
    BOOST_REQUIRE_EQUAL(error.reasons.size(), 2U);
    BOOST_CHECK_NE(error.reasons[1].find("the right sole is tilted by"), std::string::npos);
  }
}
