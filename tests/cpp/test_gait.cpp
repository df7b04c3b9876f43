#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/gait_generator.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};  // the robot of the gains: period 0.8 s
constexpr double kHalfSole = 0.07;

WalkSettings settings(const std::string& law = "default") { return resolve(WalkSettings(law), kRobot); }

/// A point mass that is a pendulum sideways and moves steadily ahead, walked by the gait. `yaw` turns the whole scene.
struct PointWalk {
  explicit PointWalk(const WalkSettings& s, double yaw = 0.0, double speed = 0.2)
      : profile({0.0}, {Vec3(speed, 0, 0)}),
        pendulum(kRobot.com_height, kRobot.gravity),
        dt(s.control_dt),
        R(rotation_z(yaw)),
        gait(s, profile, kHalfSole) {
    in.p_sole = {R * Vec3(0, 0.11, 0), R * Vec3(0, -0.11, 0)};
    in.R_sole = {R, R};
    in.dcom = (R * Vec3(speed, 0, 0)).head<2>();
    gait.reset(in, pendulum);
  }
  const GaitOutput& step() {
    const GaitOutput& out = gait.update(in);
    const Vec2 ahead = R.col(0).head<2>(), left = R.col(1).head<2>(), p = in.com - out.origin;
    const PendulumState y = pendulum.step(dt, {p.dot(left), in.dcom.dot(left)}, out.zmp_lateral);
    in.com = out.origin + (p.dot(ahead) + in.dcom.dot(ahead) * dt) * ahead + y.x * left;
    in.dcom = in.dcom.dot(ahead) * ahead + y.v * left;
    in.t += dt;
    if (out.phase.phase == Phase::kSingleSupport) {
      in.p_sole[out.swing] = out.swing_target.p;
      in.R_sole[out.swing] = out.swing_target.R;
    }
    return out;
  }

  VelocityProfile profile;
  LinearInvertedPendulum pendulum;
  double dt;
  Mat3 R;
  GaitGenerator gait;
  GaitInput in;
};

/// When support switched, in each double support [s since it began].
std::vector<double> switch_times(PointWalk& walk, double duration) {
  std::vector<double> times;
  Side support = kRight;
  while (walk.in.t < duration) {
    const GaitOutput& out = walk.step();
    if (out.support != support) times.push_back(out.phase.time);
    support = out.support;
  }
  return times;
}

}  // namespace

BOOST_AUTO_TEST_CASE(schedule_is_first_double_support_then_single_and_double_in_turn) {
  const Schedule schedule(0.18, 0.16, 0.64);
  const auto is = [&](double t, Phase phase, int step, double time, double duration) {
    const GaitPhase at = schedule.at(t);
    BOOST_CHECK(at.phase == phase);
    BOOST_CHECK_EQUAL(at.step, step);
    CHECK_NEAR(at.time, time, 3e-9);
    CHECK_NEAR(at.duration, duration, 1e-15);
  };
  is(0.0, Phase::kDoubleSupport, 0, 0.0, 0.18);
  is(0.18 - 2e-9, Phase::kDoubleSupport, 0, 0.18, 0.18);
  is(0.18 - 0.5e-9, Phase::kSingleSupport, 0, 0.0, 0.64);  // a nanosecond early counts as reached
  is(0.82 - 2e-9, Phase::kSingleSupport, 0, 0.64, 0.64);
  is(0.82, Phase::kDoubleSupport, 1, 0.0, 0.16);
  is(0.98, Phase::kSingleSupport, 1, 0.0, 0.64);
  is(0.18 + 10 * 0.8 + 0.1, Phase::kSingleSupport, 10, 0.1, 0.64);
  CHECK_NEAR(schedule.lift_off(10), 8.18, 1e-15);
  CHECK_NEAR(schedule.period(), 0.8, 1e-15);
}

BOOST_AUTO_TEST_CASE(schedule_counts_down_to_the_middles_of_the_coming_phases) {
  const Schedule schedule(0.18, 0.16, 0.64);
  CHECK_NEAR(schedule.at(0.0).to_mid_single, 0.18 + 0.32, 1e-12);
  CHECK_NEAR(schedule.at(0.0).to_mid_double, 0.18 + 0.64 + 0.08, 1e-12);
  CHECK_NEAR(schedule.at(0.6).to_mid_single, -0.1, 1e-12);
  CHECK_NEAR(schedule.at(0.6).to_mid_double, 0.3, 1e-12);
  CHECK_NEAR(schedule.at(0.9).to_mid_double, 0.8, 1e-12);  // in double support: the one after this
}

BOOST_AUTO_TEST_CASE(phases_last_the_same_number_of_cycles_however_times_are_summed) {
  const Schedule schedule(0.18, 0.16, 0.64);
  double t = 0.0;
  std::vector<int> cycles{0};
  Phase phase = Phase::kDoubleSupport;
  for (int k = 0; k < 60000; ++k, t += 0.001) {
    const GaitPhase now = schedule.at(t);
    if (now.phase != phase) cycles.push_back(0);
    phase = now.phase;
    ++cycles.back();
  }
  BOOST_CHECK_EQUAL(cycles[0], 180);
  for (std::size_t i = 1; i + 1 < cycles.size(); ++i) BOOST_CHECK_EQUAL(cycles[i], i % 2 ? 640 : 160);
}

BOOST_AUTO_TEST_CASE(schedule_refuses_phases_without_length) {
  CHECK_THROWS(Schedule(0.0, 0.16, 0.64), InputError, "T_ds_first = 0.000000");
  CHECK_THROWS(Schedule(0.18, -1, 0.64), InputError, "T_ds = -1");
  CHECK_THROWS(Schedule(0.18, 0.16, kNaN), InputError, "T_ss = nan");
}

BOOST_AUTO_TEST_CASE(swing_foot_arrives_at_rest_at_a_foothold_that_moves_until_late) {
  SwingFoot foot;
  foot.begin(Vec3(0, 0.11, 0.01), rotation_z(3.0), 0.64, 0.03, 0.04);
  Foothold hold{Vec2(0.2, 0.11), -3.0};
  double top = 0.0, speed = 0.0;
  for (int k = 0; k <= 640; ++k) {
    const double t = k * 1e-3;
    if (t < 0.7 * 0.64) hold.p += Vec2(1e-4, -5e-5);
    const SwingTarget& now = foot.update(t, 1e-3, hold);
    top = std::max(top, now.p.z());
    speed = std::max(speed, std::abs(now.omega.z()));
    BOOST_CHECK(now.a.allFinite());
  }
  const SwingTarget& end = foot.target();
  CHECK_NEAR(end.p, Vec3(hold.p.x(), hold.p.y(), 0.03), 1e-12);
  CHECK_NEAR(end.v, Vec3::Zero(), 1e-9);
  CHECK_NEAR(end.R, rotation_z(-3.0), 1e-9);
  CHECK_NEAR(end.omega, Vec3::Zero(), 1e-9);
  CHECK_NEAR(top, 0.03 + 0.04, 1e-9);                           // over the higher end
  BOOST_CHECK_LT(speed, 1.5 * (2 * M_PI - 6.0) / 0.64 + 1e-3);  // the short way round
}

BOOST_AUTO_TEST_CASE(swing_foot_follows_one_cubic_while_the_foothold_stands) {
  SwingFoot foot;
  foot.begin(Vec3(0.1, 0.11, 0), Mat3::Identity(), 0.64, 0.0, 0.04);
  const Cubic x(0.1, 0.0, 0.3, 0.0, 0.64), up(0, 0, 0.04, 0, 0.32);
  for (int k = 0; k <= 320; ++k) {
    const double t = k * 1e-3;
    const SwingTarget& now = foot.update(t, 1e-3, {Vec2(0.3, 0.11), 0.0});
    CHECK_NEAR(now.p, Vec3(x.at(t).p, 0.11, up.at(t).p), 1e-11);
    CHECK_NEAR(now.v, Vec3(x.at(t).v, 0, up.at(t).v), 1e-9);
    if (k < 320) CHECK_NEAR(now.a, Vec3(x.at(t).a, 0, up.at(t).a), 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(swing_foot_lands_at_the_height_of_the_ground_where_it_is_known_and_of_the_stance_sole_elsewhere) {
  for (const double ground : {0.0, 0.02, kNaN}) {
    PointWalk walk(settings());
    for (Vec3& sole : walk.in.p_sole) sole.z() = -0.001;  // sunk into a soft contact
    walk.in.ground = ground;
    double landed = kNaN;
    while (walk.in.t < 0.9) {
      const GaitOutput& out = walk.step();
      if (out.phase.phase == Phase::kSingleSupport && out.phase.step == 0) landed = out.swing_target.p.z();
    }
    CHECK_NEAR(landed, std::isnan(ground) ? -0.001 : ground, 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(support_switches_once_in_each_double_support_to_the_foot_that_will_stand) {
  for (const std::string first : {"right", "left"}) {
    WalkSettings s = settings();
    s.first_swing = first;
    PointWalk walk(s);
    Side support = first == "right" ? kRight : kLeft;
    int switches = 0, step = 0;
    while (walk.in.t < 8.0) {
      const GaitOutput& out = walk.step();
      if (out.support != support) {
        ++switches;
        BOOST_CHECK(out.phase.phase == Phase::kDoubleSupport);
      }
      if (out.phase.phase == Phase::kSingleSupport) {
        BOOST_CHECK(out.support == other(out.swing));
        BOOST_CHECK(!out.standing[out.swing] && out.standing[out.support]);
        BOOST_CHECK(out.foothold.p.allFinite() && std::isnan(out.w_T));
        BOOST_CHECK_EQUAL(switches, out.phase.step + 1);
      } else {
        BOOST_CHECK(out.standing[kLeft] && out.standing[kRight]);
        BOOST_CHECK_EQUAL(std::isnan(out.w_T), switches > out.phase.step);  // eq. 18 until the switch
      }
      support = out.support;
      step = out.phase.step;
    }
    BOOST_CHECK_EQUAL(step, 9);
  }
}

BOOST_AUTO_TEST_CASE(first_switch_is_where_the_expected_velocity_18_is_zero) {
  PointWalk walk(settings("paper"));
  double last = 0.0, change = 0.0;
  while (true) {
    const GaitOutput& out = walk.step();
    if (std::isnan(out.w_T)) break;
    change = std::abs(out.w_T - last);
    last = out.w_T;
  }
  BOOST_CHECK_LE(std::abs(last), change);
  CHECK_NEAR(walk.in.t - walk.dt, 0.172, 2e-3);
}

BOOST_AUTO_TEST_CASE(lateral_feedback_settles_on_one_switch_time_in_mid_double_support) {
  PointWalk walk(settings());
  const std::vector<double> times = switch_times(walk, 20.0);
  BOOST_REQUIRE_GE(times.size(), 20U);
  for (std::size_t n = 5; n < times.size(); ++n) CHECK_NEAR(times[n], 0.08, 1.001e-3);
}

BOOST_AUTO_TEST_CASE(lateral_feedback_repairs_a_start_of_the_wrong_length) {
  WalkSettings s = settings();
  s.T_ds_first = 0.16;
  PointWalk walk(s);
  const std::vector<double> times = switch_times(walk, 20.0);
  BOOST_REQUIRE_GE(times.size(), 20U);
  CHECK_NEAR(times.front(), 0.0,
             1e-9);  // the double support ended before the switch was due: forced, single support begins with it
  for (std::size_t n = 10; n < times.size(); ++n) CHECK_NEAR(times[n], 0.08, 2e-3);
}

BOOST_AUTO_TEST_CASE(gait_walks_alike_in_every_direction) {
  PointWalk ahead(settings()), turned(settings(), 2.0);
  const Mat2 R = turned.R.topLeftCorner<2, 2>();
  while (ahead.in.t < 4.0) {
    const GaitOutput &a = ahead.step(), &b = turned.step();
    BOOST_REQUIRE(a.support == b.support);
    CHECK_NEAR(a.zmp_lateral, b.zmp_lateral, 1e-9);
    CHECK_NEAR(b.heading, 2.0, 1e-12);
    if (a.phase.phase == Phase::kSingleSupport) CHECK_NEAR(R * a.foothold.p, b.foothold.p, 1e-9);
  }
  CHECK_NEAR(R * ahead.in.com, turned.in.com, 1e-9);
}

BOOST_AUTO_TEST_CASE(feet_tied_to_the_com_keep_up_with_it_and_their_width) {
  PointWalk walk(settings());
  while (walk.in.t < 12.0) walk.step();
  const Vec2 mid = 0.5 * (walk.in.p_sole[kLeft] + walk.in.p_sole[kRight]).head<2>();
  BOOST_CHECK_LE(std::abs(walk.in.com.x() - mid.x()), 0.1);
  CHECK_NEAR(walk.in.p_sole[kLeft].y(), 0.11, 1e-9);
  CHECK_NEAR(walk.in.p_sole[kRight].y(), -0.11, 1e-9);
}
