#include "robots.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

/// A controller with one setting changed is refused, and the message says `text`.
template <class Change>
void refused(Change&& change, const std::string& text) {
  WalkSettings s;
  change(s);
  CHECK_THROWS(WalkingController(mahru(), describe(mahru()), s), InputError, text);
}

void refused_profile(const VelocityProfile& profile, const std::string& text) {
  CHECK_THROWS(WalkingController(mahru(), describe(mahru()), WalkSettings(), profile), InputError, text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(settings_that_break_a_rule_are_refused_with_name_value_and_rule) {
  refused([](auto& s) { s.control_dt = 0.0015; },
          "control_dt = 0.001500 s; it must be a multiple of the model's time step, 0.001000 s");
  refused([](auto& s) { s.control_dt = -0.001; }, "control_dt = -0.001");
  refused([](auto& s) { s.T_ds = 0.0; }, "T_ds = 0.000000");
  refused([](auto& s) { s.T_ss = -1.0; }, "T_ss = -1.0");
  refused([](auto& s) { s.first_swing = "both"; }, "first_swing = 'both' is unknown; there are: right, left");
  refused([](auto& s) { s.com_x_kp = -1.0; }, "com_x_kp = -1.000000; it must be finite and not negative");
  refused([](auto& s) { s.swing_kd = INFINITY; }, "swing_kd = inf");
  refused([](auto& s) { s.zmp_threshold = 0.0; }, "zmp_threshold = 0.000000");
  refused([](auto& s) { s.max_iterations = 0; }, "max_iterations = 0; it must be at least 1");
  refused([](auto& s) { s.sole_fraction = 0.0; }, "sole_fraction = 0.000000");
  refused([](auto& s) { s.footsteps = Footsteps::kList; }, "needs step_lengths");
  refused([](auto& s) { s.footsteps = Footsteps::kList, s.step_lengths = {0.1, kNaN}; }, "step_lengths = nan");
  refused([](auto& s) { s.friction_velocity = 0.0; }, "friction_velocity = 0.000000");
  refused([](auto& s) { s.lateral_reach = kNaN; }, "lateral_reach = nan");
  refused([](auto& s) { s.capture_reach = -0.01; }, "capture_reach = -0.01");
  refused([](auto& s) { s.capture_speed = INFINITY; }, "capture_speed = inf");
  refused([](auto& s) { s.cadence_exponent = -0.4; }, "cadence_exponent = -0.4");
}

BOOST_AUTO_TEST_CASE(a_profile_that_the_legs_cannot_walk_is_refused_with_their_limit) {
  const WalkingController controller(mahru(), describe(mahru()));
  const double limit = controller.reach().speed_limit();
  BOOST_CHECK_GT(limit, 0.25);
  refused_profile(VelocityProfile({0.0, 5.0}, {Vec3(0.1, 0, 0), Vec3(1.01 * limit, 0, 0)}),
                  std::to_string(limit) + " m/s straight ahead");
  refused_profile(VelocityProfile({0.0}, {Vec3(-2.0, 0, 0)}), "(v_x, v_y, w_z) = (-2.000000 m/s, 0.000000 m/s");
  refused_profile(VelocityProfile({0.0}, {Vec3(0, 2.0, 0)}), "this robot's legs reach as far as (0.000000 m/s, ");
  refused_profile(VelocityProfile({0.0}, {Vec3(0, 0, 5.0)}), "5.000000 rad/s");
}

BOOST_AUTO_TEST_CASE(a_fast_start_is_refused_only_where_nothing_limits_its_rate) {
  const auto start = [](bool rate_limit) {
    WalkSettings s;
    s.rate_limit = rate_limit;
    const VelocityProfile stand({0.0}, {Vec3::Zero()});
    const double limit = WalkingController(mahru(), describe(mahru()), s, stand).reach().speed_limit();
    return WalkingController(mahru(), describe(mahru()), s, VelocityProfile({0.0}, {Vec3(0.99 * limit, 0, 0)}))
        .reach()
        .speed_limit();
  };
  BOOST_CHECK_NO_THROW(start(true));
  CHECK_THROWS(start(false), InputError, "the profile starts too fast");
}

BOOST_AUTO_TEST_CASE(within_reach_is_itself_or_scaled_down_to_the_whole_reach) {
  const WalkingController controller(mahru(), describe(mahru()));
  Numbers numbers(4);
  int scaled = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec3 v = numbers.vector(3, 2.0), to = controller.reach().within(v);
    CHECK_NEAR(to.cross(v), Vec3::Zero(), 1e-9);
    BOOST_CHECK_GE(to.dot(v), 0.0);
    if (to == v) {
      BOOST_CHECK_LE(controller.reach().share(v), 1.0);
    } else {
      CHECK_NEAR(controller.reach().share(to), 1.0, 1e-9);
      ++scaled;
    }
    BOOST_CHECK_LE(controller.reach().share(0.5 * v), controller.reach().share(v));
  }
  BOOST_CHECK(scaled > 50 && scaled < 300);
}

BOOST_AUTO_TEST_CASE(slower_steps_reach_less_speed) {
  WalkSettings s;
  s.cadence_exponent = s.cadence_double = 0.0;  // every step takes the same time: the reach is a length
  WalkSettings slow = s;
  slow.T_ss = 1.28;
  slow.T_ds = 0.32;
  const VelocityProfile stand({0.0}, {Vec3::Zero()});
  const WalkingController usual(mahru(), describe(mahru()), s, stand);
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), slow, stand).reach().speed_limit(),
             usual.reach().speed_limit() * usual.settings().T_ss / 1.28, 1e-9);
}

BOOST_AUTO_TEST_CASE(a_command_that_is_not_finite_is_refused_and_nothing_changes) {
  WalkingController controller(mahru(), describe(mahru()));
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()})
    CHECK_THROWS(controller.command({0.1, bad, 0}), InputError, "is not finite");
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  controller.reset(d.get());
  BOOST_CHECK(std::isnan(controller.update(d.get()).command.x()));
}

BOOST_AUTO_TEST_CASE(printed_footsteps_are_reported_as_a_mismatch_before_they_are_walked) {
  WalkSettings printed("paper");
  printed.footsteps = Footsteps::kPrinted;
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), printed).plan_mismatch(8.0), 0.0625, 1e-9);
  CHECK_NEAR(WalkingController(mahru(), describe(mahru()), WalkSettings("paper")).plan_mismatch(8.0), 0.0, 1e-3);
  BOOST_CHECK_EQUAL(WalkingController(mahru(), describe(mahru())).plan_mismatch(8.0), 0.0);
}

BOOST_AUTO_TEST_CASE(controller_takes_scale_and_bounds_from_the_robot) {
  const WalkingController controller(mahru(), describe(mahru()));
  const WalkSettings& s = controller.settings();
  CHECK_NEAR(s.T_ss + s.T_ds, 0.8, 0.02);
  CHECK_NEAR(controller.Tc(), std::sqrt(controller.com_height() / 9.81), 1e-12);
  BOOST_CHECK_EQUAL(s.control_dt, mahru()->opt.timestep);
  CHECK_NEAR(s.step_width, 0.22, 1e-9);
  for (const Side side : kSides) {
    CHECK_NEAR(controller.bounds(side).upper.x(), 0.5 * s.sole_fraction * 0.25,
               1e-12);  // strong ankles: the sole decides
    CHECK_NEAR(controller.bounds(side).lower.y(), -0.5 * s.sole_fraction * 0.14, 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(weak_ankles_narrow_the_bounds_and_weaker_ones_leave_no_room) {
  const auto with_ankle = [](double limit) {
    const std::string range = std::to_string(limit);
    return load_text(
        replaced(mahru_text(), "<motor class=\"ankle_pitch\" name=\"l_ankle_pitch\"",
                 "<motor class=\"ankle_pitch\" ctrlrange=\"-" + range + " " + range + "\" name=\"l_ankle_pitch\""));
  };
  const ModelPtr weak = with_ankle(40.0);
  const WalkingController controller(weak.get(), describe(weak.get()));
  const double weight = controller.robot().dynamics().mass * 9.81;
  CHECK_NEAR(controller.bounds(kLeft).upper.x(), controller.robot().ankle_in_sole(kLeft).x() + 0.9 * 40.0 / weight,
             1e-9);
  BOOST_CHECK_LT(controller.bounds(kLeft).upper.x(), controller.bounds(kRight).upper.x());
}
