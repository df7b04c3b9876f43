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
  double rate = 1.0;  ///< of the foot's own time at the landing
  SwingTarget end;
};

const Foothold kPlace{Vec2(0.3, 0.12), 0.2};
constexpr double kSwing = 0.64, kHeight = 0.04, kSpeed = 0.05;

/// Swings from (-0.1, 0.11, 0) to kPlace in cycles of `dt`, to land at `speed`, with events in order of time.
Jumps swing(const std::vector<Event>& events, double speed, double dt) {
  SwingFoot foot;
  foot.begin(Vec3(-0.1, 0.11, 0.0), Mat3::Identity(), kSwing, 0.0, kHeight, speed);
  OwnTime own(kSwing);
  Jumps out;
  SwingTarget before;
  std::size_t next = 0;
  for (int k = 0; k * dt < foot.duration() + 0.5 * dt; ++k) {
    const double t = k * dt;
    if (next < events.size() && t > events[next].t - 0.5 * dt) {
      if (events[next].sinks) {
        foot.sink(t, events[next].left);
      } else {
        foot.replan(t, events[next].left);
        own.retime(t, events[next].left);
      }
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
  out.rate = own.at(own.landing()).v;
  out.end = foot.target();
  return out;
}

/// Its acceleration does not jump: half as long a cycle halves all differences of it. Velocity and position are its integrals: beside what it has
/// them gain in a cycle there is no more than where it changes as fast as it ever does.
/// It lands at kPlace, at `speed` times the rate of its own time, and is at rest where the last event lets it sink: 2/3 of the way that the speed
/// at the landing would take it.
void is_smooth(const std::vector<Event>& events, double speed) {
  constexpr double kFine = 1e-4;
  const Jumps coarse = swing(events, speed, 2.0 * kFine), fine = swing(events, speed, kFine);
  BOOST_CHECK_LE(fine.a, 0.55 * coarse.a);
  BOOST_CHECK_LE(fine.v, 0.25 * kFine * fine.a + 1e-12);
  BOOST_CHECK_LE(fine.p, 0.25 * kFine * kFine * fine.a + 1e-14);
  const bool sinks = !events.empty() && events.back().sinks;
  const double landing_speed = fine.rate * speed;
  CHECK_NEAR(fine.end.p,
             Vec3(kPlace.p.x(), kPlace.p.y(), sinks ? -2.0 / 3.0 * landing_speed * events.back().left : 0.0), 1e-9);
  CHECK_NEAR(fine.end.v, Vec3(0, 0, sinks ? 0.0 : -landing_speed), 1e-6);
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
        is_smooth({{t, left}}, speed);
        const Jumps jumps = swing({{t, left}}, speed, 1e-3);
        BOOST_CHECK_LE(jumps.top, 1.35 * kHeight);
        BOOST_CHECK_GE(jumps.lowest, -0.1 * kHeight);
      }
}

BOOST_AUTO_TEST_CASE(swing_foot_comes_down_onto_the_ground_at_the_speed_that_is_asked_for) {
  is_smooth({}, 0.0);
  is_smooth({}, kSpeed);
  CHECK_NEAR(swing({}, 0.0, 1e-3).top, kHeight, 1e-12);
  CHECK_NEAR(swing({}, kSpeed, 1e-3).top, kHeight, 0.03 * kHeight);
}

BOOST_AUTO_TEST_CASE(swing_foot_that_meets_no_ground_goes_on_down_ever_slower_without_a_jump_of_its_acceleration) {
  const double time = 0.14;
  is_smooth({{kSwing, time, true}}, kSpeed);
  is_smooth({{0.2, 0.3}, {0.5, time, true}}, kSpeed);
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
  is_smooth({{0.1, 0.4}, {0.2, 0.5}, {0.25, 0.35}, {0.45, 0.25}, {0.7, 0.14, true}}, kSpeed);
  std::vector<Event> each;  // the time left changes in every tenth of a second
  for (int k = 1; k < 5; ++k) each.push_back({0.1 * k, 0.64 - 0.1 * k + (k % 2 ? 0.03 : -0.03)});
  is_smooth(each, 0.0);
  is_smooth(each, kSpeed);
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

BOOST_AUTO_TEST_CASE(swing_foot_whose_time_changes_in_every_cycle_stays_smooth_and_low_and_lands) {
  // The landing wanders by +-20 ms about its time, as far as it is not decided yet.
  const auto landing = [](double t) { return kSwing + 0.02 * std::sin(9.0 * t + 1.0) * std::sin(41.0 * t); };
  for (const double speed : {0.0, kSpeed}) {
    const auto wander = [&](double dt, double each) {
      std::vector<Event> events;
      for (int k = 1; k * each < kSwing - 0.1; ++k) events.push_back({k * each, landing(k * each) - k * each});
      events.push_back({kSwing - 0.1, 0.1});  // at the end of a cycle
      return swing(events, speed, dt);
    };
    const Jumps coarse = wander(1e-3, 1e-3), fine = wander(5e-4, 5e-4);
    BOOST_CHECK_LE(fine.a, 0.55 * coarse.a);
    BOOST_CHECK_LE(coarse.v, 0.25 * 1e-3 * coarse.a);
    BOOST_CHECK_LE(coarse.p, 0.25 * 1e-6 * coarse.a);
    BOOST_CHECK_LE(coarse.top, 1.2 * kHeight);
    BOOST_CHECK_GE(coarse.lowest, -1e-12);
  }
  Numbers numbers(4);
  for (int n = 0; n < 20; ++n) {
    SwingFoot foot;
    OwnTime own(kSwing);
    foot.begin(Vec3(-0.1, 0.11, 0.0), Mat3::Identity(), kSwing, 0.0, kHeight, kSpeed);
    double later = 0.0, top = 0.0, lowest = 1.0, a = 0.0;
    SwingTarget before, now;
    int k = 0;
    for (; k * 1e-3 < foot.duration(); ++k) {
      const double t = k * 1e-3;
      later = std::clamp(later + numbers.uniform(-4e-3, 4e-3), -0.02, 0.02);
      if (k > 0 && kSwing + later - t > 0.1) {
        foot.replan(t, kSwing + later - t);
        own.retime(t, kSwing + later - t);
      }
      now = foot.update(t, 1e-3, kPlace);
      if (k > 0) a = std::max(a, gap(accelerations(now), accelerations(before)));
      top = std::max(top, now.p.z());
      lowest = std::min(lowest, now.p.z());
      before = now;
    }
    BOOST_CHECK_LE(a, 0.5);  // in a millisecond; of some 10 m/s^2
    BOOST_CHECK_LE(top, 1.2 * kHeight);
    BOOST_CHECK_GE(lowest, -1e-12);
    now = foot.update(foot.duration(), 1e-3, kPlace);
    CHECK_NEAR(now.p, Vec3(kPlace.p.x(), kPlace.p.y(), 0.0), 1e-9);
    CHECK_NEAR(now.v.z(), -kSpeed * own.at(foot.duration()).v, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(own_time_goes_on_without_a_jump_never_back_and_ends_at_the_landing) {
  Numbers numbers(5);
  constexpr double kTiny = 1e-9;
  for (int n = 0; n < 500; ++n) {
    OwnTime own(kSwing);
    BOOST_CHECK_EQUAL(own.landing(), kSwing);
    double t = 0.0;
    const int events = 1 + n % 5;
    for (int i = 0; i < events; ++i) {
      t += numbers.uniform(0.0, 0.5) * (own.landing() - t);
      const Motion1 before = own.at(t);
      const double left = std::max(0.1, (own.landing() - t) * numbers.uniform(0.6, 1.6));
      own.retime(t, left);
      const Motion1 after = own.at(t), soon = own.at(t + kTiny);
      CHECK_NEAR(after.p, before.p, 1e-14);
      CHECK_NEAR(after.v, before.v, 1e-14);
      CHECK_NEAR(after.a, before.a, 1e-12);
      CHECK_NEAR(soon.v, before.v, 1e-6);
      CHECK_NEAR(soon.a, before.a, 1e-4);
      CHECK_NEAR(own.landing(), t + left, 1e-14);
      CHECK_NEAR(own.at(own.landing()).p, kSwing, 1e-14);
      // From there to the landing: the rate is what the time gains, its change what the rate gains.
      constexpr int kPieces = 2000;
      const double h = left / kPieces;
      Motion1 last = after;
      double a = 0.0, v = 0.0, p = 0.0;
      for (int k = 1; k <= kPieces; ++k) {
        const Motion1 now = own.at(t + k * h);
        BOOST_CHECK_GT(now.p, last.p);
        a = std::max(a, gap(now.a, last.a));
        v = std::max(v, gap(now.v - last.v, 0.5 * h * (now.a + last.a)));
        p = std::max(p, gap(now.p - last.p, 0.5 * h * (now.v + last.v)));
        last = now;
      }
      BOOST_CHECK_LE(a, 0.5);
      BOOST_CHECK_LE(v, 0.25 * h * a + 1e-15);
      BOOST_CHECK_LE(p, 0.25 * h * h * a + 1e-15);
      CHECK_NEAR(last.a, 0.0, 1e-12);
    }
  }
}
