#include <algorithm>
#include <cmath>
#include <vector>

#include "testing.hpp"
#include "zmpwalk/gait/swing_foot.hpp"
#include "zmpwalk/math/rotation.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

using Coordinates = Eigen::Matrix<double, 4, 1>;  // x, y, yaw, z

Coordinates positions(const SwingTarget& s) { return {s.p.x(), s.p.y(), yaw_of(s.R), s.p.z()}; }
Coordinates velocities(const SwingTarget& s) { return {s.v.x(), s.v.y(), s.omega.z(), s.v.z()}; }
Coordinates accelerations(const SwingTarget& s) { return {s.a.x(), s.a.y(), s.alpha.z(), s.a.z()}; }

/// An event in mid-swing: from `t` on the foot lands `left` later, or goes on down for so long.
struct Event {
  double t, left;
  bool sinks = false;
};

/// Largest differences of a swing from cycle to cycle: of the acceleration, and of what the velocity and the position gain beside what
/// the derivative has them gain.
struct Jumps {
  double a = 0.0, v = 0.0, p = 0.0;
  double top = 0.0, lowest = 1.0;
  SwingTarget end;
};

const Foothold kPlace{Vec2(0.3, 0.12), 0.2};
constexpr double kSwing = 0.64, kHeight = 0.04, kSpeed = 0.05;

/// Swings from (-0.1, 0.11, 0) to kPlace in cycles of `dt`, to land at `speed`, with events in order of time.
Jumps swing(const std::vector<Event>& events, double speed, double dt) {
  SwingFoot foot;
  foot.begin(Vec3(-0.1, 0.11, 0.0), Mat3::Identity(), kSwing, 0.0, kHeight, speed);
  Jumps out;
  SwingTarget before;
  std::size_t next = 0;
  for (int k = 0; k * dt < foot.duration() + 0.5 * dt; ++k) {
    const double t = k * dt;
    if (next < events.size() && t > events[next].t - 0.5 * dt) {
      events[next].sinks ? foot.sink(t, events[next].left) : foot.replan(t, events[next].left);
      ++next;
    }
    const SwingTarget now = foot.update(t, dt, kPlace);
    if (k > 0) {
      const Coordinates a = 0.5 * (accelerations(before) + accelerations(now)),
                        v = 0.5 * (velocities(before) + velocities(now));
      // At the last instant a spline has no acceleration any more.
      if (t < foot.duration() - 0.5 * dt) {
        out.a = std::max(out.a, gap(accelerations(now), accelerations(before)));
        out.v = std::max(out.v, gap(velocities(now) - velocities(before), dt * a));
      }
      out.p = std::max(out.p, gap(positions(now) - positions(before), dt * v));
    }
    out.top = std::max(out.top, now.p.z());
    out.lowest = std::min(out.lowest, now.p.z());
    before = now;
  }
  BOOST_CHECK_EQUAL(next, events.size());
  out.end = foot.target();
  return out;
}

/// Its acceleration does not jump: half as long a cycle halves all differences of it, and more those of velocity and position.
/// It lands at kPlace, at height `z_land`, at `speed`.
void is_smooth(const std::vector<Event>& events, double speed, double z_land, double end_speed) {
  const Jumps coarse = swing(events, speed, 2e-4), fine = swing(events, speed, 1e-4);
  BOOST_CHECK_LE(fine.a, 0.55 * coarse.a);
  BOOST_CHECK_LE(fine.v, 0.3 * coarse.v + 1e-12);
  BOOST_CHECK_LE(fine.p, 0.3 * coarse.p + 1e-14);
  CHECK_NEAR(fine.end.p, Vec3(kPlace.p.x(), kPlace.p.y(), z_land), 1e-9);
  CHECK_NEAR(fine.end.v, Vec3(0, 0, -end_speed), 1e-6);
  CHECK_NEAR(fine.end.R, rotation_z(kPlace.yaw), 1e-9);
  CHECK_NEAR(fine.end.omega, Vec3::Zero(), 1e-6);
}

}  // namespace

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
  BOOST_CHECK_LE(top, 0.03 + 0.04 + 1e-12);                     // over the higher end,
  BOOST_CHECK_GE(top, 0.03 + 0.04 - 1e-6);                      // which it passes between two cycles
  BOOST_CHECK_LT(speed, 1.5 * (2 * M_PI - 6.0) / 0.64 + 1e-3);  // the short way round
}

BOOST_AUTO_TEST_CASE(swing_foot_goes_up_or_down_a_step_without_a_jump_of_its_acceleration_at_the_top) {
  for (const double z_land : {-0.03, 0.005, 0.03}) {
    SwingFoot foot;
    foot.begin(Vec3::Zero(), Mat3::Identity(), kSwing, z_land, kHeight);
    double before = kNaN;
    for (int k = 0; k < 640; ++k) {
      const SwingTarget& now = foot.update(k * 1e-3, 1e-3, kPlace);
      if (k > 0) BOOST_CHECK_LE(std::abs(now.a.z() - before), 0.04);  // a cubic's, in a millisecond
      before = now.a.z();
    }
  }
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

BOOST_AUTO_TEST_CASE(swing_foot_lands_sooner_or_later_without_a_jump_of_its_acceleration) {
  for (const double t : {0.05, 0.16, 0.3, 0.32, 0.4, 0.5})
    for (const double later : {-0.3 * kSwing, -0.06, 0.06, 0.3 * kSwing})
      for (const double speed : {0.0, kSpeed}) {
        const double left = kSwing + later - t;
        if (left < 0.1) continue;
        is_smooth({{t, left}}, speed, 0.0, speed);
        const Jumps jumps = swing({{t, left}}, speed, 1e-3);
        BOOST_CHECK_LE(jumps.top, 1.35 * kHeight);
        BOOST_CHECK_GE(jumps.lowest, -0.1 * kHeight);
      }
}

BOOST_AUTO_TEST_CASE(swing_foot_comes_down_onto_the_ground_at_the_speed_that_is_asked_for) {
  is_smooth({}, 0.0, 0.0, 0.0);
  is_smooth({}, kSpeed, 0.0, kSpeed);
  CHECK_NEAR(swing({}, 0.0, 1e-3).top, kHeight, 1e-12);
  CHECK_NEAR(swing({}, kSpeed, 1e-3).top, kHeight, 0.03 * kHeight);
}

BOOST_AUTO_TEST_CASE(swing_foot_that_meets_no_ground_goes_on_down_ever_slower_without_a_jump_of_its_acceleration) {
  const double time = 0.14, depth = 2.0 / 3.0 * kSpeed * time;
  is_smooth({{kSwing, time, true}}, kSpeed, -depth, 0.0);
  SwingFoot foot;
  foot.begin(Vec3(-0.1, 0.11, 0.0), Mat3::Identity(), kSwing, 0.0, kHeight, kSpeed);
  double aside = 0.0;
  for (int k = 0; k * 1e-3 < kSwing + time; ++k) {
    if (k == 640) foot.sink(0.64, time);
    const SwingTarget& now = foot.update(k * 1e-3, 1e-3, kPlace);
    if (k <= 640) continue;
    BOOST_CHECK_LE(now.v.z(), 1e-9);
    BOOST_CHECK_GE(now.v.z(), -1.3 * kSpeed);
    aside = std::max(aside, gap(now.p.head<2>(), kPlace.p));
  }
  BOOST_CHECK_LE(aside, 0.004);
}

BOOST_AUTO_TEST_CASE(swing_foot_stays_smooth_through_one_event_after_another) {
  const double depth = 2.0 / 3.0 * kSpeed * 0.14;
  is_smooth({{0.1, 0.4}, {0.2, 0.5}, {0.25, 0.35}, {0.45, 0.25}, {0.7, 0.14, true}}, kSpeed, -depth, 0.0);
  std::vector<Event> each;  // the time left changes in every tenth of a second
  for (int k = 1; k < 5; ++k) each.push_back({0.1 * k, 0.64 - 0.1 * k + (k % 2 ? 0.03 : -0.03)});
  is_smooth(each, 0.0, 0.0, 0.0);
}

BOOST_AUTO_TEST_CASE(swing_foot_that_is_planned_anew_for_the_same_landing_goes_on_as_it_did) {
  for (const double t : {0.1, 0.32, 0.5}) {
    SwingFoot kept, anew;
    for (SwingFoot* foot : {&kept, &anew}) foot->begin(Vec3(-0.1, 0.11, 0.0), Mat3::Identity(), kSwing, 0.0, kHeight);
    for (int k = 0; k < 640; ++k) {
      if (k == std::lround(1e3 * t)) anew.replan(k * 1e-3, kSwing - k * 1e-3);
      const SwingTarget a = kept.update(k * 1e-3, 1e-3, kPlace), b = anew.update(k * 1e-3, 1e-3, kPlace);
      CHECK_NEAR(a.p, b.p, 1e-12);
      CHECK_NEAR(a.v, b.v, 1e-10);
      if (k != std::lround(1e3 * t)) CHECK_NEAR(a.a, b.a, 1e-8);
    }
  }
}
