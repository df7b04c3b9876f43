#include <cmath>
#include <functional>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/plan.hpp"
#include "zmpwalk/gait/point_walk.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/rotation.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};  // the robot of the gains: period 0.8 s
const SoleSize kSole{0.25, 0.14};
const ZmpBounds kBounds{Vec2(-0.09, -0.0504), Vec2(0.09, 0.0504)};
const VelocityProfile kAhead({0.0}, {Vec3(0.2, 0, 0)});

WalkSettings settings(const std::string& law = "default") { return resolve(WalkSettings(law), kRobot); }

GaitInput stand(const Mat3& R) {
  GaitInput in;
  in.p_sole = {R * Vec3(0, 0.11, 0), R * Vec3(0, -0.11, 0)};
  in.R_sole = {R, R};
  return in;
}

/// A walk of a point mass, and what the tests ask of it. `yaw` turns the whole scene.
struct TestWalk : PointWalk {
  explicit TestWalk(const WalkSettings& s, double yaw = 0.0, const VelocityProfile& profile = kAhead)
      : PointWalk(s, profile, LinearInvertedPendulum(kRobot.com_height, kRobot.gravity), {kBounds, kBounds}, kSole,
                  stand(rotation_z(yaw))),
        R(rotation_z(yaw)) {}
  Vec2 middle() const { return 0.5 * (in.p_sole[kLeft] + in.p_sole[kRight]).head<2>(); }
  double x(const Vec2& p) const { return p.dot(ahead_of(gait.output().heading)); }  ///< along the walk
  double lead() const { return std::abs(x((in.p_sole[kLeft] - in.p_sole[kRight]).head<2>())); }
  double dcm() const { return x(in.com + pendulum.Tc() * in.dcom - gait.output().origin); }  ///< from the stance foot
  void run_until(double t) {
    while (in.t < t) step();
  }

  Mat3 R;
};

constexpr double kRounding = 1e-12;  // of dv_capture that came back to zero [m/s]

VelocityProfile steady(double v) { return VelocityProfile({0.0}, {Vec3(v, 0, 0)}); }

double period_of(const TestWalk& walk, double v) { return walk.gait.cadence().times(Vec3(v, 0, 0)).period(); }

/// Walks at `v` until 20 s, then for 10 steps more, which are as long as v asks for, at that speed, and need no capture.
void settles(double v, double lead_tolerance, double speed_tolerance) {
  TestWalk walk(settings(), 0.0, steady(v));
  const double L = std::abs(v) * period_of(walk, v);
  walk.run_until(20.0);
  double x_start = kNaN, t_start = kNaN, off = 0.0, capture = 0.0;
  bool standing = true;
  for (int n = 0; n <= 10;) {
    const GaitOutput& out = walk.step();
    const bool landed = out.phase.phase == Phase::kDoubleSupport && !standing;
    standing = out.phase.phase == Phase::kDoubleSupport;
    capture = std::max(capture, std::abs(out.dv_capture));
    if (!landed) continue;
    off = std::max(off, gap(walk.lead(), L));
    if (n == 0) {
      x_start = walk.x(walk.in.com);
      t_start = walk.in.t;
    } else if (n == 10) {
      CHECK_NEAR((walk.x(walk.in.com) - x_start) / (walk.in.t - t_start), v, speed_tolerance);
    }
    ++n;
  }
  BOOST_CHECK_LE(off, lead_tolerance);
  CHECK_NEAR(capture, 0.0, kRounding);
}

/// How far from the stance foot the DCM of a steady walk at `v` comes, before the next foot takes over [m].
double steady_dcm(const WalkSettings& s, const TestWalk& walk, double v) {
  const double T = period_of(walk, v), pace = walk.gait.cadence().pace(Vec3(v, 0, 0));
  const double reach = kBounds.upper.x() * std::pow(pace, s.zmp.sole_exponent) - s.com.lead;
  return s.com.lead + 0.5 * v * T + walk.pendulum.Tc() * ForwardOrbit(walk.pendulum, v, T, reach).end_velocity();
}

/// What a walk at some speed goes through when another is commanded at any of 8 instants of two steps.
struct Jump {
  double excess = 0.0;  ///< largest distance of the DCM from the stance foot beyond that of the faster steady walk [m]
  int captures = 0;     ///< of the 8 walks: those whose speed yields within a slow period
};

Jump jump(const WalkSettings& s, double v, double dv) {
  Jump out;
  const double slow = s.gait.T_ds + s.gait.T_ss;
  for (int k = 0; k < 8; ++k) {
    TestWalk walk(s, 0.0, steady(v));
    walk.run_until(6.0 + 0.25 * k * period_of(walk, v));
    walk.gait.command({v + dv, 0, 0});
    const double t = walk.in.t, most = steady_dcm(s, walk, std::max(std::abs(v), std::abs(v + dv)));
    bool yields = false;
    while (walk.in.t < t + 5.0 && out.excess < 1.0) {  // who is a metre off has fallen
      const GaitOutput& now = walk.step();
      if (now.at_rest) continue;
      out.excess = std::max(out.excess, std::abs(walk.dcm()) - most);
      yields |= walk.in.t < t + slow && std::abs(now.dv_capture) > kRounding;
    }
    out.captures += yields;
  }
  return out;
}

/// What happens to one step in mid-swing, or to one double support.
struct Event {
  const char* what;
  std::function<void(TestWalk&)> happens;  ///< before each cycle of a walk
};

/// In step 7, single or double support takes `duration` of what was planned from half of that on.
void retime(TestWalk& walk, Phase phase, const std::function<double(double)>& duration) {
  const GaitOutput& out = walk.gait.output();
  const StepTimes times = walk.gait.cadence().times(out.v_plan);
  const double planned = phase == Phase::kSingleSupport ? times.T_ss : times.T_ds,
               since = out.phase.time - 0.5 * planned;
  if (out.phase.step == 7 && out.phase.phase == phase && since >= 0.0 && since < walk.dt - 1e-9)
    walk.gait.retime(std::max(duration(planned) - out.phase.time, 1e-4));
}

/// Contact of a swing foot that lands `later` than planned in step 7, and off the ground as planned in all others.
void feel(TestWalk& walk, double later) {
  const GaitOutput& out = walk.gait.output();
  walk.in.contact.setOnes();
  if (out.phase.phase != Phase::kSingleSupport) return;
  const double planned = walk.gait.cadence().times(out.v_plan).T_ss;  // of these slow steps
  const double lands = planned + (out.phase.step == 7 ? later : 0.0);
  if (out.phase.time > 0.02 && out.phase.time + walk.dt < lands - 1e-9) walk.in.contact[out.swing] = 0.0;
}

/// Acceleration of the swing foot from cycle to cycle, and whether velocity and position go along with it.
struct Smoothness {
  double a = 0.0, v = 0.0, p = 0.0;
  void add(const GaitOutput& out, double dt) {
    const SwingTarget& now = out.swing_target;
    if (out.phase.phase == Phase::kSingleSupport && swinging) {
      a = std::max({a, gap(now.a, before.a), gap(now.alpha, before.alpha)});
      v = std::max(v, gap(now.v - before.v, 0.5 * dt * (now.a + before.a)));
      p = std::max(p, gap(now.p - before.p, 0.5 * dt * (now.v + before.v)));
    }
    swinging = out.phase.phase == Phase::kSingleSupport;
    before = now;
  }
  bool swinging = false;
  SwingTarget before;
};

/// When support switched, in each double support [s since it began].
std::vector<double> switch_times(TestWalk& walk, double duration) {
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

BOOST_AUTO_TEST_CASE(swing_foot_lands_at_the_height_of_the_ground_where_it_is_known_and_of_the_stance_sole_elsewhere) {
  for (const double ground : {0.0, 0.02, kNaN}) {
    TestWalk walk(settings());
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
  for (const Side first : kSides) {
    WalkSettings s = settings();
    s.gait.first_swing = first;
    TestWalk walk(s);
    Side support = first;
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
  TestWalk walk(settings("paper"));
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
  TestWalk walk(settings());
  const std::vector<double> times = switch_times(walk, 20.0);
  BOOST_REQUIRE_GE(times.size(), 20U);
  for (std::size_t n = 5; n < times.size(); ++n) CHECK_NEAR(times[n], 0.08, 1.001e-3);
}

BOOST_AUTO_TEST_CASE(lateral_feedback_repairs_a_start_of_the_wrong_length) {
  WalkSettings s = settings();
  s.gait.T_ds_first = 0.16;
  TestWalk walk(s);
  const std::vector<double> times = switch_times(walk, 20.0);
  BOOST_REQUIRE_GE(times.size(), 20U);
  CHECK_NEAR(times.front(), 0.0,
             1e-9);  // the double support ended before the switch was due: forced, single support begins with it
  for (std::size_t n = 10; n < times.size(); ++n) CHECK_NEAR(times[n], 0.08, 2e-3);
}

BOOST_AUTO_TEST_CASE(gait_walks_alike_in_every_direction) {
  TestWalk ahead(settings()), turned(settings(), 2.0);
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
  TestWalk walk(settings());
  while (walk.in.t < 12.0) walk.step();
  const Vec2 mid = 0.5 * (walk.in.p_sole[kLeft] + walk.in.p_sole[kRight]).head<2>();
  BOOST_CHECK_LE(std::abs(walk.in.com.x() - mid.x()), 0.1);
  CHECK_NEAR(walk.in.p_sole[kLeft].y(), 0.11, 1e-9);
  CHECK_NEAR(walk.in.p_sole[kRight].y(), -0.11, 1e-9);
}

BOOST_AUTO_TEST_CASE(walks_everywhere_stops_with_feet_side_by_side_and_starts_again) {
  for (const Vec3& v : {Vec3(0.2, 0, 0), Vec3(0.5, 0, 0), Vec3(-0.2, 0, 0), Vec3(0, 0.15, 0), Vec3(0, -0.15, 0),
                        Vec3(0, 0, 0.5), Vec3(0.3, 0.1, -0.4)}) {
    const WalkSettings s = settings();
    TestWalk walk(s, 0.7, VelocityProfile({0.0, 6.0, 14.0}, {v, Vec3::Zero(), v}));
    double stood = kNaN;
    Vec2 rest = Vec2::Zero();
    while (walk.in.t < 20.0) {
      const GaitOutput& out = walk.step();
      const double t = walk.in.t;
      BOOST_REQUIRE_LT((walk.in.com - walk.middle()).norm(), 0.4);  // neither fallen nor left behind
      if (t > 1.0 && t < 6.0) BOOST_CHECK(!out.at_rest);
      if (out.at_rest && std::isnan(stood)) stood = t;
      if (t < 12.0) rest = walk.in.com;
      if (t > 12.0 && t < 13.5) {
        BOOST_CHECK(out.at_rest && out.standing[kLeft] && out.standing[kRight]);
        BOOST_CHECK_LT((walk.in.com - rest).norm(), 1e-3);
        BOOST_CHECK_LT((walk.zmp - walk.middle()).norm(), 1e-3);
      }
      if (t > 15.0) BOOST_CHECK(!out.at_rest);
      if (t < 13.0 || t > 13.0 + walk.dt) continue;
      const Vec3 across = walk.in.R_sole[kRight].transpose() * (walk.in.p_sole[kLeft] - walk.in.p_sole[kRight]);
      CHECK_NEAR(across.head<2>(), Vec2(0, s.steps.width), 1e-3);
      CHECK_NEAR(walk.in.R_sole[kLeft], walk.in.R_sole[kRight], 1e-3);
      // The commands lead there, but for the last step and the lead of the COM over its feet.
      const Vec3 travel = walk.gait.plan().travel(0.0, 13.0);
      CHECK_NEAR(walk.in.com, (walk.R * Vec3(travel.x(), travel.y(), 0)).head<2>(),
                 s.gait.closing_distance + s.com.lead);
      CHECK_NEAR(out.heading, 0.7 + travel.z(), 1e-9);
    }
    BOOST_CHECK_LT(stood, 6.0 + 4.0 * (s.gait.T_ss + s.gait.T_ds));
  }
}

BOOST_AUTO_TEST_CASE(a_zero_profile_stands_or_steps_on_the_spot_as_asked) {
  const VelocityProfile zero({0.0}, {Vec3::Zero()});
  WalkSettings s = settings();
  TestWalk standing(s, 0.0, zero);
  standing.in.com = {0.01, -0.02};
  while (standing.in.t < 4.0) BOOST_REQUIRE(standing.step().at_rest);
  BOOST_CHECK_LT(standing.in.com.norm(), 1e-4);
  s.gait.stand = false;
  TestWalk marching(s, 0.0, zero);
  while (marching.in.t < 4.0) BOOST_REQUIRE(!marching.step().at_rest);
  BOOST_CHECK_EQUAL(marching.gait.schedule().at(4.0).step, 4);
}

BOOST_AUTO_TEST_CASE(a_command_leads_from_the_next_cycle_on_until_reset) {
  const WalkSettings s = settings();
  TestWalk walk(s, 0.0, VelocityProfile({0.0}, {Vec3::Zero()}));
  while (walk.in.t < 1.0) walk.step();
  walk.gait.command({0.5, 0, 0});
  CHECK_NEAR(walk.step().v_plan, Vec3(s.rate.forward_jump, 0, 0), 1e-12);
  BOOST_CHECK(!walk.step().at_rest);
  while (walk.in.t < 6.0) walk.step();
  CHECK_NEAR(walk.step().v_plan, Vec3(0.5, 0, 0), 0.0);
  walk.gait.command(Vec3::Zero());
  while (walk.in.t < 12.0) walk.step();
  BOOST_CHECK(walk.step().at_rest);
  walk.gait.command({0.2, 0, 0});
  walk.in.t = 0.0;
  walk.gait.reset(walk.in, walk.pendulum);
  BOOST_CHECK(walk.step().at_rest);  // neither the command in force nor the one on its way
}

BOOST_AUTO_TEST_CASE(a_slow_walk_settles_on_steps_of_the_planned_length_and_speed_without_capture) {
  for (const double v : {-0.2, 0.1, 0.2, 0.3}) settles(v, 1e-4, 1e-4);
}

BOOST_AUTO_TEST_CASE(a_fast_walk_settles_on_steps_of_the_planned_length_and_speed_without_capture) {
  for (const double v : {0.6, 1.0}) settles(v, 2e-3, 2e-3);
}

BOOST_AUTO_TEST_CASE(walking_back_on_long_steps_settles_on_the_planned_length_and_speed_without_capture) {
  settles(-0.3, 2e-3, 2e-3);
}

BOOST_AUTO_TEST_CASE(a_command_at_any_instant_leaves_the_dcm_where_the_next_step_catches_it) {
  const WalkSettings s = settings();
  for (const double v : {0.3, 0.6, 1.0})
    for (const double dv : {-0.3, 0.3}) BOOST_CHECK_LE(jump(s, v, dv).excess, 1.5 * s.steps.capture_distance);
}

BOOST_AUTO_TEST_CASE(speed_yields_after_some_jumps_of_the_command_and_never_without_one) {
  const WalkSettings s = settings();
  BOOST_CHECK_EQUAL(jump(s, 0.3, 0.0).captures, 0);
  for (const double dv : {-0.3, 0.3}) BOOST_CHECK_GT(jump(s, 0.3, dv).captures, 0);
}

BOOST_AUTO_TEST_CASE(speed_yields_where_the_com_is_shifted_and_leaves_the_next_step_less_to_catch) {
  struct Missed {
    double dcm = 0.0, against = 0.0, along = 0.0;
  };
  // What the DCM misses as the next foot lands, after a shift of the COM as the last one lifted, and how speed yielded then.
  const auto missed = [](double shift, double capture_speed) {
    WalkSettings s = settings();
    s.steps.capture_speed = capture_speed;
    s.steps.timing = false;  // it would catch the DCM by the time of the step
    TestWalk walk(s, 0.0, steady(0.3));
    walk.run_until(10.0);
    Missed out;
    const auto until = [&](Phase phase) {
      out.against = out.along = 0.0;
      while (walk.step().phase.phase != phase) {
        const double dv = walk.gait.output().dv_capture;
        double& way = dv * shift > 0.0 ? out.along : out.against;
        way = std::max(way, std::abs(dv));
      }
      return walk.dcm();
    };
    until(Phase::kDoubleSupport);
    until(Phase::kSingleSupport);
    const double as_planned = until(Phase::kDoubleSupport);
    until(Phase::kSingleSupport);
    walk.in.com.x() += shift;
    out.dcm = std::abs(until(Phase::kDoubleSupport) - as_planned);
    return out;
  };
  const double yields = settings().steps.capture_speed;
  const Missed ahead = missed(0.08, yields), behind = missed(-0.05, yields), near = missed(0.01, yields);
  BOOST_CHECK_LT(ahead.dcm, 0.5 * missed(0.08, 0.0).dcm);
  CHECK_NEAR(behind.dcm, missed(-0.05, 0.0).dcm, 1e-9);  // the ZMP is at the heel already: there is nothing to gain
  for (const Missed& far : {ahead, behind}) {
    BOOST_CHECK_GT(far.against, 0.01);
    CHECK_NEAR(far.along, 0.0, kRounding);
  }
  CHECK_NEAR(near.against + near.along, 0.0, kRounding);  // within capture_reach: the next foot takes it all
}

BOOST_AUTO_TEST_CASE(speed_yields_by_no_more_than_capture_speed) {
  const WalkSettings s = settings();
  TestWalk walk(s, 0.0, steady(0.6));
  walk.run_until(8.0);
  walk.gait.command({0.3, 0, 0});
  double most = 0.0;
  while (walk.in.t < 12.0) {
    const GaitOutput& out = walk.step();
    most = std::max(most, std::abs(out.dv_capture));
  }
  BOOST_CHECK_GT(most, kRounding);
  BOOST_CHECK_LE(most, s.steps.capture_speed);
}

BOOST_AUTO_TEST_CASE(orbit_does_not_jump_ahead_from_cycle_to_cycle) {
  // One orbit ends and the next begins with nothing; the support switches within a cycle or two of that.
  for (const double v : {-0.5, 0.3, 0.6, 1.0}) {
    TestWalk walk(settings(), 0.0, steady(v));
    walk.run_until(8.0);
    double before = kNaN, most = 0.0;
    while (walk.in.t < 12.0) {
      const GaitOutput& out = walk.step();
      const double range = std::abs(out.orbit.end_velocity() - out.orbit.velocity(0.0));
      if (!std::isnan(before)) BOOST_CHECK_LE(std::abs(out.orbit_ahead - before), 2 * range * walk.dt);
      before = out.orbit_ahead;
      most = std::max(most, std::abs(before));
    }
    BOOST_CHECK_GT(most, 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(stretch_goes_on_where_the_foot_lands_and_is_half_a_step_and_what_the_com_moves) {
  const double v = 0.2;
  TestWalk walk(settings(), 0.0, steady(v));
  const StepTimes times = walk.gait.cadence().times(Vec3(v, 0, 0));
  const double L = v * times.period(), half = 0.5 * times.T_ds, Tc = walk.pendulum.Tc();
  // Ahead at v, and from foot to foot, (L, 0.22) apart, at the speed of the orbit between them.
  const Vec2 over(L, 0.22), moves = half * (Vec2(v, 0) + over * 0.5 / Tc * std::tanh(0.5 * times.period() / Tc));
  const double expected = (Vec2(0.5 * L, 0) + moves).norm();
  walk.run_until(12.0);
  double before = kNaN;
  int landings = 0;
  Phase phase = Phase::kDoubleSupport;
  while (walk.in.t < 18.0) {
    const GaitOutput& out = walk.step();
    if (out.phase.phase == Phase::kDoubleSupport) {
      CHECK_NEAR(out.stretch, expected, 2e-4);
      if (phase == Phase::kSingleSupport) {
        CHECK_NEAR(out.stretch, before, 1e-5);
        ++landings;
      }
    }
    phase = out.phase.phase;
    before = out.stretch;
  }
  BOOST_CHECK_GE(landings, 7);
}

BOOST_AUTO_TEST_CASE(a_plan_is_the_walk_of_a_point_mass_that_does_as_it_is_told) {
  for (const VelocityProfile& profile :
       {steady(0.2), steady(0.3), VelocityProfile({0.0, 4.0}, {Vec3(0.1, 0, 0), Vec3(0.25, 0.05, 0.1)})}) {
    TestWalk walk(settings(), 0.0, profile);
    const WalkPlan plan = plan_walk(settings(), profile, walk.pendulum, {kBounds, kBounds}, kSole, walk.in, 12.0);
    std::size_t landed = 0;
    bool standing = true;
    for (std::size_t k = 0; k < plan.t.size(); ++k) {
      CHECK_NEAR(walk.in.com, plan.com[k], 1e-5);
      const GaitOutput& out = walk.step();
      const bool stands = out.phase.phase == Phase::kDoubleSupport;
      if (stands && !standing) {
        const WalkPlan::Step& step = plan.steps.at(landed++);
        CHECK_NEAR(walk.in.p_sole[step.foot].head<2>(), step.place.p, 1e-4);
      }
      standing = stands;
    }
    BOOST_CHECK_EQUAL(landed, plan.steps.size());
  }
}

BOOST_AUTO_TEST_CASE(
    a_step_that_lands_early_or_late_or_takes_another_time_leaves_the_swing_foot_smooth_and_the_walk_going) {
  const auto retimed = [](Phase phase, const std::function<double(double)>& duration) {
    return [=](TestWalk& walk) { retime(walk, phase, duration); };
  };
  const auto times = [](double factor) { return [factor](double T) { return factor * T; }; };
  const auto plus = [](double later) { return [later](double T) { return T + later; }; };
  const Phase single = Phase::kSingleSupport, both = Phase::kDoubleSupport;
  const std::vector<Event> events{
      {"nothing", [](TestWalk&) {}},
      {"nothing, by contact", [](TestWalk& walk) { feel(walk, 0.0); }},
      {"single support - 30 %", retimed(single, times(0.7))},
      {"single support + 30 %", retimed(single, times(1.3))},
      {"single support - 60 ms", retimed(single, plus(-0.06))},
      {"single support + 60 ms", retimed(single, plus(0.06))},
      {"double support - 30 %", retimed(both, times(0.7))},
      {"double support + 30 %", retimed(both, times(1.3))},
      {"double support that ends at once", retimed(both, times(0.5))},
      {"contact 60 ms early", [](TestWalk& walk) { feel(walk, -0.06); }},
      {"contact 60 ms late", [](TestWalk& walk) { feel(walk, 0.06); }},
  };
  /// How smoothly the swing foot moves in cycles of `dt`, until 12 s.
  const auto smoothness = [&](const Event& event, double v, double dt) {
    WalkSettings s = settings();
    s.gait.stand = false;
    s.gait.touch_down = TouchDown::kContact;
    s.gait.touch_down_time = 0.14;
    s.control.dt = dt;
    TestWalk walk(s, 0.4, steady(v));
    Smoothness smooth;
    int switches = 0, steps = 0;
    Side support = walk.gait.output().support;
    while (walk.in.t < 12.0) {
      event.happens(walk);
      const GaitOutput& out = walk.step();
      smooth.add(out, dt);
      switches += out.support != support;
      support = out.support;
      steps = out.phase.step;
      BOOST_REQUIRE_LT((walk.in.com - walk.middle()).norm(), 0.3);
      if (out.phase.phase == Phase::kDoubleSupport) continue;
      BOOST_REQUIRE_EQUAL(switches, steps + 1);  // each double support has had its switch
      BOOST_REQUIRE(out.support == other(out.swing));
    }
    BOOST_CHECK_GE(steps, 14);
    return smooth;
  };
  for (const Event& event : events)
    for (const double v : {0.2, 0.0}) BOOST_TEST_CONTEXT(event.what << " at " << v << " m/s") {
        const Smoothness coarse = smoothness(event, v, 1e-3), fine = smoothness(event, v, 5e-4);
        BOOST_CHECK_LE(fine.a, 0.6 * coarse.a + 1e-3);  // half as long a cycle, half the difference: no jump
        BOOST_CHECK_LE(fine.v, 0.6 * coarse.v + 1e-6);
        BOOST_CHECK_LE(fine.p, 0.6 * coarse.p + 1e-9);
      }
}

BOOST_AUTO_TEST_CASE(a_contact_ends_a_step_only_after_the_foot_was_in_the_air_and_late_in_its_swing) {
  WalkSettings s = settings();
  s.gait.touch_down = TouchDown::kContact;
  s.gait.touch_down_time = 0.14;
  /// Length of the first single support [s] of a foot that is off the ground where `flies` says so; NaN: not known.
  const auto length = [&](const std::function<double(double)>& contact, bool felt_before = true) {
    TestWalk walk(s);
    Phase phase = Phase::kDoubleSupport;
    for (double lifted = kNaN;;) {
      const GaitOutput& before = walk.gait.output();
      walk.in.contact.setConstant(felt_before ? 1.0 : 0.0);
      if (phase == Phase::kSingleSupport) walk.in.contact[before.swing] = contact(before.phase.time + walk.dt);
      const GaitOutput& now = walk.step();
      if (now.phase.phase == Phase::kSingleSupport && phase == Phase::kDoubleSupport) lifted = walk.in.t;
      if (now.phase.phase == Phase::kDoubleSupport && phase == Phase::kSingleSupport) return walk.in.t - lifted;
      phase = now.phase.phase;
    }
  };
  const auto from_to = [](double off, double on) { return [=](double t) { return t >= off && t < on ? 0.0 : 1.0; }; };
  const double T = s.gait.T_ss, cycle = 1.001e-3;
  CHECK_NEAR(length([](double) { return kNaN; }), T, cycle);                  // not known: by time
  CHECK_NEAR(length(from_to(0.03, 0.5)), 0.5, cycle);                         // early
  CHECK_NEAR(length(from_to(0.03, T + 0.06)), T + 0.06, cycle);               // late
  CHECK_NEAR(length(from_to(0.03, 9.0)), T + s.gait.touch_down_time, cycle);  // nowhere: by time at last
  CHECK_NEAR(length(from_to(9.0, 9.0)), T, cycle);                            // never off the ground
  CHECK_NEAR(length([&](double t) { return t < 0.03 || (t > 0.2 && t < 0.21) || t > T ? 1.0 : 0.0; }), T,
             cycle);                                       // scuffs
  CHECK_NEAR(length(from_to(0.0, 9.0), false), T, cycle);  // a foot that was never felt ends its step by time
  s.gait.touch_down_share = 0.8;
  CHECK_NEAR(length(from_to(0.03, 0.3)), 0.8 * T, cycle);
  s.gait.touch_down = TouchDown::kTime;
  CHECK_NEAR(length(from_to(0.03, 0.3)), T, cycle);
}

BOOST_AUTO_TEST_CASE(
    a_landing_before_its_time_leaves_the_next_lift_off_at_its_time_and_one_after_it_the_double_support_at_its_length) {
  for (const double later : {-0.06, 0.06}) {
    WalkSettings s = settings();
    s.gait.touch_down = TouchDown::kContact;
    s.gait.touch_down_time = 0.14;
    TestWalk as_planned(s), disturbed(s);
    const auto until_step_8_lifts = [&](TestWalk& walk, double of_step_7) {
      double landed = kNaN;
      while (walk.gait.output().phase.step < 8 || walk.gait.output().phase.phase == Phase::kDoubleSupport) {
        feel(walk, of_step_7);
        const Phase before = walk.gait.output().phase.phase;
        if (walk.step().phase.phase == Phase::kDoubleSupport && before == Phase::kSingleSupport) landed = walk.in.t;
      }
      return std::pair(landed, walk.in.t);
    };
    const auto [landed, lifts] = until_step_8_lifts(as_planned, 0.0);
    const auto [landed_2, lifts_2] = until_step_8_lifts(disturbed, later);
    CHECK_NEAR(landed_2 - landed, later, 1.001e-3);
    CHECK_NEAR(lifts_2 - lifts, later < 0.0 ? 0.0 : later, 1.001e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_time_for_the_phase_under_way_is_positive_and_a_stand_takes_none) {
  TestWalk walk(settings(), 0.0, VelocityProfile({0.0, 1.0}, {Vec3::Zero(), Vec3(0.2, 0, 0)}));
  for (const double wrong : {0.0, -0.1, kNaN}) CHECK_THROWS(walk.gait.retime(wrong), InputError, "remaining = ");
  while (walk.in.t < 0.5) BOOST_REQUIRE(walk.step().at_rest);
  walk.gait.retime(0.01);
  while (walk.in.t < 0.8) BOOST_CHECK(walk.step().at_rest);
  while (walk.step().phase.phase == Phase::kDoubleSupport) continue;
  walk.gait.retime(0.2);
  const double since = walk.gait.output().phase.time;
  CHECK_NEAR(walk.step().phase.duration, since + 0.2, 1e-9);
}
