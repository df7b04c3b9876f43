#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/footsteps.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};
constexpr double kPeriod = 0.8, kTc = 0.276, kDt = 1e-3;
const SoleSize kSole{0.25, 0.14};
const std::array<Foothold, 2> kStart{Foothold{Vec2(0, 0.11), 0.0}, Foothold{Vec2(0, -0.11), 0.0}};

WalkSettings settings(Footsteps kind, std::vector<double> lengths = {}) {
  WalkSettings s;
  s.steps.mode = kind;
  s.steps.lengths = std::move(lengths);
  return resolve(s, kRobot);
}

FootstepPlanner planner(const WalkSettings& s, const VelocityProfile& profile) {
  FootstepPlanner out(s, profile, kSole);
  out.reset(kStart, 0.0);
  return out;
}

/// One cycle of a single support, of which `share` has gone by and whose foothold may follow the COM.
Foothold follow(FootstepPlanner& feet, Side swing, double t_mid, double ahead_of_plan, double aside, double share) {
  const PathPoint planned = feet.planned(swing, feet.stance_at(t_mid, kPeriod));
  if (feet.follows(share)) feet.follow(feet.off_nominal(ahead_of_plan, aside, planned), planned);
  return feet.target();
}

Cadence cadence(const WalkSettings& s) {
  return {{s.gait.T_ds, s.gait.T_ss},
          s.gait.cadence_speed,
          s.gait.cadence_exponent,
          s.gait.cadence_double,
          {1.0, s.gait.cadence_sideways, 0.0}};
}

/// Largest difference between the speeds of the feet and of the plan in `duration` [s].
double mismatch(const WalkSettings& s, const VelocityProfile& profile, double duration) {
  return planner(s, profile).mismatch(duration, cadence(s));
}

const VelocityProfile paper = VelocityProfile::paper();
const VelocityProfile steady({0.0}, {Vec3(0.25, 0, 0)});

}  // namespace

BOOST_AUTO_TEST_CASE(list_of_steps_repeats_its_last_length) {
  const FootstepPlanner corrected = planner(settings(Footsteps::kPaper), paper),
                        printed = planner(settings(Footsteps::kPrinted), paper);
  const std::vector<double> lengths{0.1, 0.15, 0.2};
  for (int n = 0; n < 3; ++n) {
    BOOST_CHECK_EQUAL(corrected.lead(n, corrected.stance_at(0.0, kPeriod)), lengths[n]);
    BOOST_CHECK_EQUAL(printed.lead(n, printed.stance_at(0.0, kPeriod)), lengths[n]);
  }
  BOOST_CHECK_EQUAL(corrected.lead(50, corrected.stance_at(0.0, kPeriod)), 0.2);
  BOOST_CHECK_EQUAL(printed.lead(50, printed.stance_at(0.0, kPeriod)), 0.25);
}

BOOST_AUTO_TEST_CASE(without_a_list_a_step_is_half_of_what_the_plan_does_in_either_stance) {
  const FootstepPlanner feet = planner(settings(Footsteps::kTied), paper);
  CHECK_NEAR(feet.lead(7, feet.stance_at(1.2, kPeriod)),
             0.5 * (paper.displacement(0.4, 1.2) + paper.displacement(1.2, 2.0)).x(), 1e-15);
}

BOOST_AUTO_TEST_CASE(corrected_lengths_advance_at_the_planned_speed_and_printed_ones_do_not) {
  const double duration = 10 * kPeriod;
  CHECK_NEAR(mismatch(settings(Footsteps::kPaper), paper, duration), 0.0, 0.6e-3);  // the plan is rounded to mm/s
  CHECK_NEAR(mismatch(settings(Footsteps::kPrinted), paper, duration), 0.0625, 1e-12);
  CHECK_NEAR(mismatch(settings(Footsteps::kList, {0.2}), steady, duration), -0.125,
             1e-12);  // the first step starts from rest
  BOOST_CHECK_EQUAL(mismatch(settings(Footsteps::kTied), paper, duration), 0.0);
  BOOST_CHECK_EQUAL(mismatch(settings(Footsteps::kAbsolute), paper, duration), 0.0);
}

BOOST_AUTO_TEST_CASE(listed_lengths_are_compared_at_the_cadence_that_walks_them) {
  WalkSettings s = settings(Footsteps::kList, {1.0});
  const VelocityProfile fast({0.0}, {Vec3(0.6, 0, 0)});
  CHECK_NEAR(mismatch(s, fast, 4.0), 1.0 / kPeriod - 0.6, 1e-12);
  s.gait.cadence_exponent = 0.4;  // steps of 0.6 m/s then take (cadence_speed / 0.6)^0.4 of the slow ones
  const double period = kPeriod * std::pow(s.gait.cadence_speed / 0.6, 0.4);
  CHECK_NEAR(mismatch(s, fast, 4.0), 1.0 / period - 0.6, 1e-12);
  // Half of two leads is what the plan does in a period, from the first step on.
  const double twice = 2 * 0.6 * period;
  s.steps.lengths = {twice, 0.0, twice, 0.0, twice, 1.5 * twice};
  CHECK_NEAR(mismatch(s, fast, 5 * period), 0.0, 1e-12);
  CHECK_NEAR(mismatch(s, fast, 5.99 * period), 0.0, 1e-12);
  CHECK_NEAR(mismatch(s, fast, 6 * period), 1.5 * 0.6, 1e-12);
}

BOOST_AUTO_TEST_CASE(each_listed_step_takes_the_time_of_the_plan_ahead_of_it) {
  WalkSettings s = settings(Footsteps::kList, {0.0});
  s.gait.cadence_exponent = 0.4;
  const double fast = kPeriod * std::pow(s.gait.cadence_speed / 0.6, 0.4);
  const VelocityProfile faster({0.0, 2 * kPeriod}, {Vec3(0.2, 0, 0), Vec3(0.6, 0, 0)});
  const double slow_2 = 2 * 0.2 * kPeriod, fast_2 = 2 * 0.6 * fast;
  s.steps.lengths = {slow_2, 0.0, fast_2, 0.0, fast_2, 0.0, fast_2};
  CHECK_NEAR(mismatch(s, faster, 2 * kPeriod + 5 * fast), 0.0, 1e-12);
  CHECK_NEAR(mismatch(s, faster, 2 * kPeriod + 6 * fast), 0.6, 1e-12);  // the last length once more
}

BOOST_AUTO_TEST_CASE(a_listed_step_leads_the_measured_stance_foot_and_lands_beside_the_path) {
  FootstepPlanner feet = planner(settings(Footsteps::kPaper), paper);
  const Foothold to = feet.begin_step(1, kLeft, {Vec2(0.3, -0.1), 0.02}, feet.stance_at(1.0, kPeriod));
  // Leads are between the middles of the walk beside the feet: the stance foot's, half a width to its left.
  CHECK_NEAR(to.p, Vec2(0.3 - 0.11 * std::sin(0.02) + 0.15, 0.11), 1e-15);
  BOOST_CHECK_EQUAL(to.yaw, 0.0);  // the heading of the start
  CHECK_NEAR(feet.begin_step(2, kRight, {Vec2(0.45, 0.12), 0.0}, feet.stance_at(1.8, kPeriod)).p, Vec2(0.65, -0.11),
             1e-15);
}

BOOST_AUTO_TEST_CASE(footholds_turn_with_the_heading) {
  FootstepPlanner feet(settings(Footsteps::kPaper), paper, kSole);
  feet.reset({Foothold{Vec2(-0.11, 0), M_PI_2}, Foothold{Vec2(0.11, 0), M_PI_2}}, M_PI_2);
  const Foothold to = feet.begin_step(0, kRight, {Vec2(-0.11, 0), M_PI_2}, feet.stance_at(1.0, kPeriod));
  CHECK_NEAR(to.p, Vec2(-0.11 + 0.22, 0.1), 1e-15);
  BOOST_CHECK_EQUAL(to.yaw, M_PI_2);
}

BOOST_AUTO_TEST_CASE(absolute_footholds_ignore_where_the_feet_came_to_stand) {
  for (const WalkSettings& s : {settings(Footsteps::kAbsolute), settings(Footsteps::kAbsolute, {0.1, 0.15, 0.2})}) {
    FootstepPlanner straight = planner(s, paper), slipped = planner(s, paper);
    Side swing = kRight;
    Foothold stance = kStart[kLeft];
    for (int n = 0; n < 10; ++n, swing = other(swing)) {
      const Foothold slid{stance.p + Vec2(0.01 * n, -0.02 * side_sign(swing)), 0.05};
      const Foothold a = straight.begin_step(n, swing, stance, straight.stance_at(0.9 + n * kPeriod, kPeriod));
      CHECK_NEAR(a.p, slipped.begin_step(n, swing, slid, slipped.stance_at(0.9 + n * kPeriod, kPeriod)).p, 0.0);
      CHECK_NEAR(a.p.y(), 0.11 * side_sign(swing), 1e-12);
      stance = a;
    }
  }
}

BOOST_AUTO_TEST_CASE(absolute_footholds_put_the_planned_com_between_the_feet_in_mid_double_support) {
  FootstepPlanner feet = planner(settings(Footsteps::kAbsolute), steady);
  Vec2 before = kStart[kLeft].p;
  Side swing = kRight;
  for (int n = 0; n < 10; ++n, swing = other(swing)) {
    const double t_mid = 0.9 + n * kPeriod;
    const Vec2 now = feet.begin_step(n, swing, kStart[other(swing)], feet.stance_at(t_mid, kPeriod)).p;
    if (n > 0) {
      CHECK_NEAR(0.5 * (before + now).x(), steady.displacement(0, t_mid).x(), 1e-12);
      // Ahead of one hip, behind the other; and how far the COM goes in half of the double support.
      const auto stretch = [&](double T_ds) {
        return feet.stretch(now, swing, before, feet.stance_at(t_mid, kPeriod), T_ds, 0.0);
      };
      CHECK_NEAR(stretch(0.0), 0.5 * 0.25 * kPeriod, 1e-12);
      CHECK_NEAR(stretch(0.16), 0.5 * 0.25 * (kPeriod + 0.16), 1e-12);
    }
    before = now;
  }
}

BOOST_AUTO_TEST_CASE(stretch_is_that_of_the_foot_that_is_farther_from_its_hip_as_double_support_begins_or_ends) {
  const VelocityProfile stand({0.0}, {Vec3::Zero()}), ahead({0.0}, {Vec3(0.25, 0, 0)});
  const auto foot = [](Side side, double x, double out) {
    return Foothold{Vec2(x, side_sign(side) * (0.11 + out)), 0.0};
  };
  const auto both = [](const FootstepPlanner& feet, const Foothold& left, const Foothold& right, double T_ds,
                       double sway, Side landed) {
    const PlannedStance at = feet.stance_at(0.0, kPeriod);
    return landed == kLeft ? feet.stretch(left.p, kLeft, right.p, at, T_ds, sway)
                           : feet.stretch(right.p, kRight, left.p, at, T_ds, sway);
  };
  for (const Side landed : kSides) {
    const FootstepPlanner still = planner(settings(Footsteps::kTied), stand),
                          moving = planner(settings(Footsteps::kTied), ahead);
    const Foothold left = foot(kLeft, 0, 0), right = foot(kRight, 0, 0);
    CHECK_NEAR(both(still, left, right, 0.16, 0.0, landed), 0.0, 1e-15);  // each below its hip
    // The COM comes from the foot that lifts and goes to the one that landed: away from the one, before it reached the other.
    CHECK_NEAR(both(still, left, right, 0.16, 0.5, landed), 0.08 * 0.5, 1e-15);
    CHECK_NEAR(both(still, foot(kLeft, 0, 0.03), right, 0.16, 0.5, landed), 0.03 + 0.08 * 0.5, 1e-15);
    CHECK_NEAR(both(still, left, foot(kRight, 0, 0.03), 0.16, 0.5, landed), 0.03 + 0.08 * 0.5, 1e-15);
    CHECK_NEAR(both(still, foot(kLeft, 0.1, 0), foot(kRight, -0.05, 0), 0.16, 0.0, landed), 0.1, 1e-15);
    CHECK_NEAR(both(still, foot(kLeft, 0.1, 0), foot(kRight, -0.15, 0), 0.16, 0.0, landed), 0.15, 1e-15);
    // Ahead it lands farther off, behind it lifts farther off; the other way round, the COM comes nearer.
    const double front = landed == kLeft ? 0.1 : -0.1;
    CHECK_NEAR(both(moving, foot(kLeft, front, 0), foot(kRight, -front, 0), 0.16, 0.0, landed), 0.1 + 0.08 * 0.25,
               1e-15);
    CHECK_NEAR(both(moving, foot(kLeft, -front, 0), foot(kRight, front, 0), 0.16, 0.0, landed), 0.1 - 0.08 * 0.25,
               1e-15);
  }
}

BOOST_AUTO_TEST_CASE(walking_sideways_the_narrower_step_keeps_the_step_width) {
  const VelocityProfile aside({0.0}, {Vec3(0, 0.15, 0)});
  FootstepPlanner feet = planner(settings(Footsteps::kAbsolute), aside);
  double before = kNaN;
  Side swing = kLeft;
  for (int n = 0; n < 8; ++n, swing = other(swing)) {
    const double y =
        feet.begin_step(n, swing, {Vec2(0, before), 0.0}, feet.stance_at(0.9 + n * kPeriod, kPeriod)).p.y();
    if (n > 0) CHECK_NEAR(side_sign(swing) * (y - before), swing == kRight ? 0.22 : 0.22 + 2 * 0.15 * kPeriod, 1e-12);
    before = y;
  }
}

BOOST_AUTO_TEST_CASE(turning_on_the_spot_feet_go_round_its_centre_with_the_heading_half_a_period_later) {
  const VelocityProfile turn({0.0}, {Vec3(0, 0, 0.5)});
  FootstepPlanner feet = planner(settings(Footsteps::kAbsolute), turn);
  Foothold stance = kStart[kLeft];
  Side swing = kRight;
  for (int n = 0; n < 20; ++n, swing = other(swing)) {
    const double t_mid = n * kPeriod;
    const Foothold to = feet.begin_step(n, swing, stance, feet.stance_at(t_mid, kPeriod));
    CHECK_NEAR(to.yaw, 0.5 * (t_mid + 0.5 * kPeriod), 1e-12);
    CHECK_NEAR(to.p, 0.11 * side_sign(swing) * left_of(to.yaw), 1e-12);
    stance = to;
  }
}

BOOST_AUTO_TEST_CASE(soles_keep_clear_of_each_other_whatever_the_turn) {
  Numbers numbers(3);
  WalkSettings s = settings(Footsteps::kTied);
  s.control.dt = 1.0;  // the low-pass takes a cycle
  int moved = 0;
  for (int n = 0; n < 2000; ++n) {
    const VelocityProfile any({0.0}, {Vec3(numbers.vector(3, 0.6))});
    FootstepPlanner feet = planner(s, any);
    const Side swing = n % 2 ? kLeft : kRight;
    const Foothold stance{kStart[other(swing)].p + numbers.vector(2, 0.05), numbers.uniform(-0.3, 0.3)};
    feet.begin_step(0, swing, stance, feet.stance_at(0.9, kPeriod));
    for (const Foothold& to :
         {feet.target(), follow(feet, swing, 0.9, numbers.uniform(-1, 1), numbers.uniform(-1, 1), 0.3)}) {
      double least = 1.0;  // of the sole's corners, seen from the stance sole's edge
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
          const Vec2 corner = to.p + x * kSole.length * ahead_of(to.yaw) + y * kSole.width * left_of(to.yaw);
          least = std::min(least, side_sign(swing) * (corner - stance.p).dot(left_of(stance.yaw)) - 0.5 * kSole.width);
        }
      BOOST_CHECK_GE(least, s.steps.clearance - 1e-9);
      moved += least < s.steps.clearance + 1e-9;
    }
  }
  BOOST_CHECK_GT(moved, 100);
}

BOOST_AUTO_TEST_CASE(tied_foothold_goes_where_the_com_will_be_half_a_step_behind_less_its_lead) {
  const WalkSettings s = settings(Footsteps::kTied);
  FootstepPlanner feet = planner(s, steady);
  feet.advance(4.6, Vec2(0.55, 0));
  feet.begin_step(3, kRight, {Vec2(0.5, 0.11), 0.0}, feet.stance_at(5.0, kPeriod));
  // By hand: COM at 0.55 m, 0.4 s before the middle of the next double support, where its DCM will be 0.006 m ahead of the plan.
  const double wanted = 0.55 + 0.25 * 0.4 + 0.006 + 0.5 * 0.2 - s.com.lead;
  Foothold to;
  for (int k = 0; k < 2000; ++k) to = follow(feet, kRight, 5.0, 0.006, -0.01, 0.3);
  BOOST_REQUIRE_LT(std::abs(wanted - 0.7), s.steps.shift);
  CHECK_NEAR(to.p, Vec2(wanted, -0.12), 1e-9);
}

BOOST_AUTO_TEST_CASE(tied_foothold_is_low_passed_and_frozen) {
  const WalkSettings s = settings(Footsteps::kTied);
  FootstepPlanner feet = planner(s, steady);
  feet.advance(4.6, Vec2(0.55, 0));
  const Foothold nominal = feet.begin_step(3, kRight, {Vec2(0.5, 0.11), 0.0}, feet.stance_at(5.0, kPeriod));
  Side swing = kRight;
  const PathPoint planned = feet.planned(kRight, feet.stance_at(5.0, kPeriod));
  const double off = feet.off_nominal(0.4, 0.0, planned).x();
  CHECK_NEAR(off, 0.4 + (planned.p - nominal.p).dot(planned.ahead), 1e-12);
  const auto update = [&](double share, double aside) { return follow(feet, swing, 5.0, 0.4, aside, share).p; };
  CHECK_NEAR(update(0.1, 0.0).x() - nominal.p.x(), off * (1 - std::exp(-kDt / s.steps.filter_time)), 1e-12);
  for (int k = 0; k < 2000; ++k) update(0.1, -0.4);
  CHECK_NEAR(update(0.1, -0.4) - nominal.p, Vec2(off, -0.4), 1e-9);
  for (int k = 0; k < 2000; ++k) update(0.1, 0.4);
  CHECK_NEAR(update(0.1, 0.4).y(), std::min(-0.11 + 0.4, 0.11 - kSole.width - s.steps.clearance), 1e-9);
  swing = kLeft;
  feet.begin_step(4, kLeft, {Vec2(0.7, -0.11), 0.0}, feet.stance_at(5.8, kPeriod));
  const Vec2 frozen = feet.target().p;
  CHECK_NEAR(update(s.steps.freeze + 0.01, 0.0), frozen, 0.0);
  BOOST_CHECK_GE(gap(update(s.steps.freeze, 0.0), frozen), 1e-4);
}

BOOST_AUTO_TEST_CASE(tied_foothold_stays_within_reach_of_the_leg_and_of_the_time_left_but_goes_where_the_plan_goes) {
  WalkSettings s = settings(Footsteps::kTied);
  for (const double most : {0.1, 0.3}) {  // the plan asks for more than the first
    s.steps.ahead_most = most;
    FootstepPlanner feet = planner(s, steady);
    feet.advance(4.6, Vec2(0.55, 0));
    const Vec2 stance(0.5, 0.11);
    const Foothold nominal = feet.begin_step(3, kRight, {stance, 0.0}, feet.stance_at(5.0, kPeriod));
    const double lead = nominal.p.x() - stance.x();
    BOOST_REQUIRE_GT(lead, 0.1);
    BOOST_REQUIRE_LT(lead, 0.3);
    const auto after = [&](double ahead, double way) {
      const PathPoint plan = feet.planned(kRight, feet.stance_at(5.0, kPeriod));
      const LandingRoom room{nominal.p, Vec2::Constant(way)};
      for (int k = 0; k < 2000; ++k) feet.follow(feet.off_nominal(ahead, 0.0, plan), plan, &room, &room);
      return feet.target().p.x() - stance.x();
    };
    const double longest = std::max(most, 1.15 * lead);  // where the plan goes that far, a little further
    CHECK_NEAR(after(2.0, 0.01), std::min(lead + 0.01, longest), 1e-9);
    CHECK_NEAR(after(2.0, 10.0), longest, 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(listed_and_absolute_footholds_do_not_follow_the_com) {
  for (const Footsteps kind : {Footsteps::kPaper, Footsteps::kPrinted, Footsteps::kAbsolute}) {
    FootstepPlanner feet = planner(settings(kind), paper);
    feet.advance(0.5, Vec2(2, 0));
    const Foothold nominal = feet.begin_step(0, kRight, kStart[kLeft], feet.stance_at(0.9, kPeriod));
    CHECK_NEAR(follow(feet, kRight, 0.9, 1.0, 1.0, 0.2).p, nominal.p, 0.0);
  }
}

BOOST_AUTO_TEST_CASE(last_step_goes_beside_the_stance_foot_where_the_com_comes_to_rest_near_it) {
  const VelocityProfile stand({0.0}, {Vec3::Zero()});
  const WalkSettings s = settings(Footsteps::kTied);
  const auto closes = [&](const Foothold& stance, double xi) {
    FootstepPlanner feet = planner(s, stand);
    feet.begin_step(3, kRight, stance, feet.stance_at(0.4, kPeriod));
    feet.close(kRight, stance, xi);
    if (feet.closing()) {
      CHECK_NEAR(feet.target().p, stance.p - 0.22 * left_of(stance.yaw), 1e-12);
      BOOST_CHECK_EQUAL(feet.target().yaw, stance.yaw);
      CHECK_NEAR(follow(feet, kRight, 0.4, 1.0, 1.0, 0.1).p, feet.target().p, 0.0);
    }
    return feet.closing();
  };
  const double reach = s.gait.closing_distance, turn = s.gait.closing_turn;
  const auto aside = [](double y) { return Foothold{Vec2(0.3, 0.11 + y), 0.0}; };
  BOOST_CHECK(closes(aside(0), 0.99 * reach) && closes(aside(0), -0.99 * reach) && !closes(aside(0), 1.01 * reach));
  BOOST_CHECK(closes(aside(-0.99 * reach), 0.0) && !closes(aside(-1.01 * reach), 0.0));
  BOOST_CHECK(!closes(aside(0.8 * reach), 0.8 * reach));
  BOOST_CHECK(closes({Vec2(0, 0.11), 0.99 * turn}, 0.0) && !closes({Vec2(0, 0.11), 1.01 * turn}, 0.0));
}

BOOST_AUTO_TEST_CASE(settings_come_from_the_robot_where_they_are_not_set) {
  const WalkSettings s = settings(Footsteps::kTied);
  CHECK_NEAR(s.gait.T_ss + s.gait.T_ds, 0.8, 1e-12);
  CHECK_NEAR(s.gait.T_ds, 0.16, 1e-12);
  CHECK_NEAR(s.gait.T_ds_first, 0.1806, 1e-3);
  BOOST_CHECK_EQUAL(s.control.dt, 0.001);
  BOOST_CHECK_EQUAL(s.steps.width, 0.22);
  CHECK_NEAR(s.steps.capture_distance, 0.07 * 0.747, 1e-12);
  CHECK_NEAR(s.steps.capture_speed, 0.2 * std::sqrt(9.81 * 0.747), 1e-12);
  // A robot four times as tall walks half as fast in time: periods double, k_p goes with 1/4, k_d with 1/2.
  const WalkSettings tall = resolve(WalkSettings(), {4 * 0.747, 9.81, 0.001, 0.9});
  CHECK_NEAR(tall.gait.T_ss, 2 * s.gait.T_ss, 1e-12);
  CHECK_NEAR(tall.com.kp_x, s.com.kp_x / 4, 1e-9);
  CHECK_NEAR(tall.swing.kd, s.swing.kd / 2, 1e-9);
}

BOOST_AUTO_TEST_CASE(steps_come_faster_in_a_faster_walk_unless_a_list_sets_their_lengths) {
  BOOST_CHECK(std::isnan(WalkSettings().gait.cadence_exponent));
  BOOST_CHECK_EQUAL(settings(Footsteps::kTied).gait.cadence_exponent, 0.4);
  BOOST_CHECK_EQUAL(settings(Footsteps::kTied, {0.2}).gait.cadence_exponent, 0.4);  // tied: nobody reads the list
  BOOST_CHECK_EQUAL(settings(Footsteps::kAbsolute).gait.cadence_exponent, 0.4);
  BOOST_CHECK_EQUAL(settings(Footsteps::kAbsolute, {0.2}).gait.cadence_exponent, 0.0);
  for (const Footsteps kind : {Footsteps::kPaper, Footsteps::kPrinted, Footsteps::kList})
    BOOST_CHECK_EQUAL(settings(kind, {0.2}).gait.cadence_exponent, 0.0);
  for (const Footsteps kind : {Footsteps::kTied, Footsteps::kList}) {
    WalkSettings own;
    own.steps.mode = kind;
    own.steps.lengths = {0.2};
    own.gait.cadence_exponent = 0.25;
    BOOST_CHECK_EQUAL(resolve(own, kRobot).gait.cadence_exponent, 0.25);
  }
}

BOOST_AUTO_TEST_CASE(step_height_is_what_the_knee_can_lift_against_its_rotor_and_damping) {
  CHECK_NEAR(settings(Footsteps::kTied).swing.height, 0.0535 * 0.747, 1e-12);
  // A lift h takes 10 rad/m * (0.1 kg m^2 * 6 h / (0.32 s)^2 + 0.5 N m s * 1.5 h / 0.32 s) of the knee.
  RobotScale heavy = kRobot;
  heavy.knee_per_lift = 10.0;
  heavy.knee_armature = 0.1;
  heavy.knee_damping = 0.5;
  heavy.knee_torque = 2.0;
  const double torque_per_lift = 10.0 * (0.1 * 6.0 / (0.32 * 0.32) + 0.5 * 1.5 / 0.32),
               lift = resolve(WalkSettings(), heavy).swing.height;
  BOOST_CHECK_LT(lift, 0.0535 * 0.747);
  BOOST_CHECK_LE(lift * torque_per_lift, 0.8 * heavy.knee_torque);  // leaves the knee torque to swing the leg with
  heavy.knee_torque = 4.0;
  CHECK_NEAR(resolve(WalkSettings(), heavy).swing.height, 2 * lift, 1e-12);
}

BOOST_AUTO_TEST_CASE(a_faster_walk_lifts_the_foot_less_where_the_forward_swing_takes_the_knees_torque) {
  RobotScale heavy = kRobot;
  heavy.hip_to_ankle = 0.65;
  heavy.knee_per_lift = 5.0;
  heavy.knee_armature = 0.7;
  heavy.knee_torque = 10.0;
  const WalkSettings slow = resolve(WalkSettings(), heavy), fast = resolve(WalkSettings(), heavy, 0.25);
  BOOST_CHECK_LT(fast.swing.height, slow.swing.height);
  // At lift-off the hip is v (T + T_ds) / 2 = 0.12 m ahead of the ankle and the foot starts with 6 (2 v T) / T_ss^2 = 5.859 m/s^2.
  CHECK_NEAR(knee_share(heavy, fast, 0.0, 0.25), 5.0 * 0.7 * 0.12 / 0.65 * 5.859375 / 10.0, 1e-9);
  CHECK_NEAR(knee_share(heavy, fast, fast.swing.height, 0.25), knee_share(heavy, slow, slow.swing.height, 0.0), 1e-12);
  heavy.knee_torque = 0.1;  // too weak for any: a least step is left
  CHECK_NEAR(resolve(WalkSettings(), heavy, 0.25).swing.height, 0.01 * heavy.com_height, 1e-12);
}

BOOST_AUTO_TEST_CASE(choices_have_names_and_unknown_names_are_refused_with_those_that_exist) {
  for (const std::string name : {"tied", "absolute", "paper", "printed", "list"})
    BOOST_CHECK_EQUAL(to_string(chosen<Footsteps>("footsteps", name)), name);
  CHECK_THROWS(chosen<Footsteps>("footsteps", "tide"), InputError,
               "footsteps = 'tide' is unknown; there are: tied, absolute, paper, printed, list");
  CHECK_THROWS(chosen<Iteration>("iteration", ""), InputError, "there are: closed_form, loop");
  CHECK_THROWS(WalkSettings("papyrus"), InputError, "law = 'papyrus' is unknown; there are: default, paper");
}
