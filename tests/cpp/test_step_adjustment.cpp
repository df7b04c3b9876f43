#include <algorithm>
#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/step_adjustment.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const LinearInvertedPendulum pendulum(0.747, 9.81);
constexpr double kPeriod = 0.8, kWidth = 0.22, kLength = 0.2;
constexpr StepLimits kLimits{0.4, 0.4, 0.1, 1.2, 0.08};
const StepWeights kWeights;

/// A step in mid-swing to the left of the support foot, in a walk on its orbit. The ZMP may be anywhere in the sole, and rests in its middle.
struct Step {
  std::array<StepAxis, 2> axes;
  StepLimits limits = kLimits;

  Step() {
    const double to_end = pendulum.growth(kLimits.planned + kLimits.take_over).factor;
    const auto axis = [&](double end, double place, double half, double offset) {
      StepAxis a;
      a.xi = end / to_end;
      a.zmp_lower = -half;
      a.zmp_upper = half;
      a.place = place;
      a.foot = 0.5 * place;
      a.offset = offset;
      return a;
    };
    // Ahead: over each foot the DCM begins `start` ahead of it, and ends with the same lead over the next.
    const double start = kLength / pendulum.growth(kPeriod).excess, inset = pendulum.orbit_inset(kWidth, kPeriod);
    axes = {axis(kLength + start, kLength, 0.1, start), axis(kWidth - inset, kWidth, 0.05, -inset)};
    axes[0].foot_acceleration = 20.0;
    axes[0].place_lower = -0.45;
    axes[0].place_upper = 0.45;
    axes[1].foot_acceleration = 40.0;
    axes[1].place_lower = 0.16;
    axes[1].place_upper = 0.5;
  }
  /// The same step where the DCM has been pushed by `ahead` and `aside`, towards the swing foot [m].
  static Step pushed(double ahead, double aside) {
    Step out;
    out.axes[0].xi += ahead;
    out.axes[1].xi += aside;
    return out;
  }
  double cost(double time, const StepWeights& weights = kWeights) const {
    return StepAdjustment(weights).cost(pendulum, axes, limits, time);
  }
  double time(const StepWeights& weights = kWeights) const {
    return StepAdjustment(weights).time(pendulum, axes, limits);
  }
};

/// The push aside, from 0 to `most`, up to which the planned time costs no more than `cost` [m].
double push_that_costs(double most, double cost) {
  double low = 0.0, high = most;
  BOOST_REQUIRE_GT(Step::pushed(0.0, most).cost(kLimits.planned), cost);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (Step::pushed(0.0, middle).cost(kLimits.planned) > cost ? high : low) = middle;
  }
  return low;
}

/// Any step, in which the swing foot can come to some place that the leg can reach.
Step any(Numbers& numbers, double time) {
  Step out;
  out.limits.planned = numbers.uniform(-0.1, 0.6);
  for (StepAxis& a : out.axes) {
    a.xi = numbers.uniform(-0.2, 0.3);
    a.zmp_lower = numbers.uniform(-0.1, 0.0);
    a.zmp_upper = numbers.uniform(0.0, 0.1);
    a.place = numbers.uniform(-0.3, 0.3);
    a.drift = numbers.uniform(-0.5, 0.5);
    a.place_lower = numbers.uniform(-0.5, 0.0);
    a.place_upper = numbers.uniform(0.1, 0.5);
    a.foot_velocity = numbers.uniform(-0.5, 0.5);
    a.foot = numbers.uniform(a.place_lower, a.place_upper) - 0.5 * time * a.foot_velocity;
    a.foot_acceleration = numbers.uniform(1.0, 40.0);
    a.offset = numbers.uniform(-0.1, 0.1);
  }
  return out;
}

/// What a search over ZMP and foothold finds: the least gap between the DCM and its place over the landed foot, and how far the nearest foothold
/// with that gap is from the planned one. Places on the way to a planned place out of reach count as well.
struct Found {
  double gap, moved;
};

Found search(const StepAxis& a, const StepLimits& limits, double time) {
  constexpr int kZmps = 40, kPlaces = 4000;
  const double planned = a.place + a.drift * (time - limits.planned), to_end = time + limits.take_over;
  double first = planned, last = planned;
  for (int i = 0; i <= kPlaces; ++i) {
    const double place = a.place_lower + (a.place_upper - a.place_lower) * i / kPlaces;
    // The foot that goes on for half the time at its velocity comes to rest with an acceleration of +-6 / time^2 for each metre beside that.
    if (std::abs(place - a.foot - 0.5 * time * a.foot_velocity) * 6.0 > a.foot_acceleration * time * time) continue;
    first = std::min(first, place);
    last = std::max(last, place);
  }
  Found out{1e9, 1e9};
  for (int i = 0; i <= kPlaces; ++i) {
    const double place = first + (last - first) * i / kPlaces;
    // The DCM is linear in the ZMP: between two ZMPs that leave it on either side, one leaves no gap.
    double gap = 1e9, before = 0.0;
    for (int k = 0; k <= kZmps; ++k) {
      const double r = a.zmp_lower + (a.zmp_upper - a.zmp_lower) * k / kZmps;
      const double off = r + (a.xi - r) * std::exp(to_end / pendulum.Tc()) - place - a.offset;
      gap = std::min(gap, k > 0 && before * off < 0.0 ? 0.0 : std::abs(off));
      before = off;
    }
    const double moved = std::abs(place - planned);
    if (gap < out.gap - 1e-9 || (gap < out.gap + 1e-9 && moved < out.moved)) out = {gap, moved};
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_step_of_a_walk_on_its_orbit_costs_nothing_at_its_planned_time_and_keeps_it) {
  const Step step;
  CHECK_NEAR(step.cost(kLimits.planned), 0.0, 1e-15);
  BOOST_CHECK_EQUAL(step.time(), kLimits.planned);
  for (const double other : {-0.1, 0.1}) {
    BOOST_CHECK_GE(step.cost(kLimits.planned + other), 0.999 * kWeights.time * other * other);
    Step decided = step;  // another time that was decided on before gives way to the planned one
    decided.limits.current += other;
    BOOST_CHECK_EQUAL(decided.time(), kLimits.planned);
  }
}

BOOST_AUTO_TEST_CASE(a_walk_that_goes_on_keeps_its_planned_place_at_any_planned_time) {
  Step step;
  step.axes[0].drift = 0.3;
  for (const double later : {-0.2, 0.2}) {
    // A place that drifts and a plan that comes later are the same step.
    Step shifted = step;
    shifted.limits.planned += later;
    shifted.axes[0].place += 0.3 * later;
    for (const double time : {0.2, 0.4, 0.7})
      CHECK_NEAR(shifted.cost(time, {0.04, 0.0, 1e-4}), step.cost(time, {0.04, 0.0, 1e-4}), 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(the_planned_time_stays_as_long_as_it_costs_no_more_than_the_band) {
  for (const double band : {1e-5, 1e-4, 1e-3}) {
    const StepWeights weights{kWeights.place, kWeights.time, band};
    for (const double most : {-0.2, 0.2}) {
      const double edge = push_that_costs(most, band);
      BOOST_CHECK_GT(std::abs(edge), 0.01);
      for (const double share : {0.0, 0.5, 0.999})
        BOOST_CHECK_EQUAL(Step::pushed(0.0, share * edge).time(weights), kLimits.planned);
    }
    // Far beyond it another time is taken, which costs less by the band at least.
    const Step far = Step::pushed(0.0, 0.08);
    const double time = far.time(weights);
    BOOST_CHECK_NE(time, kLimits.planned);
    BOOST_CHECK_LT(far.cost(time, weights), far.cost(kLimits.planned, weights) - band);
  }
}

BOOST_AUTO_TEST_CASE(a_dcm_pushed_towards_the_swing_foot_makes_the_step_shorter_the_more_the_further) {
  double before = kLimits.planned;
  // Up to where the foot would have to be swifter than it can.
  for (int k = 0; k <= 20; ++k) {
    const double time = Step::pushed(0.0, 0.005 * k).time();
    BOOST_CHECK_LE(time, before);
    BOOST_CHECK_GE(time, kLimits.least);
    before = time;
  }
  BOOST_CHECK_LT(before, 0.5 * kLimits.planned);
  BOOST_CHECK_LT(Step::pushed(0.0, 0.06).time(), kLimits.planned - 0.03);
  const double ahead = Step::pushed(0.12, 0.0).time();
  BOOST_CHECK_LT(ahead, kLimits.planned - 0.03);
  BOOST_CHECK_GE(ahead, kLimits.least);
}

BOOST_AUTO_TEST_CASE(a_dcm_pushed_outwards_but_within_the_sole_makes_the_step_longer_up_to_the_latest_landing) {
  const double xi = Step().axes[1].xi;
  double before = kLimits.planned;
  for (const double there : {-0.03, -0.04, -0.045}) {
    const double time = Step::pushed(0.0, there - xi).time();
    BOOST_CHECK_GT(time, kLimits.planned + 0.05);
    BOOST_CHECK_GE(time, before - 0.05);
    BOOST_CHECK_LE(time, kLimits.most);
    before = time;
  }
  Step soon = Step::pushed(0.0, -0.045 - xi);
  soon.limits.most = 0.45;
  CHECK_NEAR(soon.time(), 0.45, 1e-12);
}

BOOST_AUTO_TEST_CASE(the_gap_and_the_foothold_are_those_of_a_search_over_zmp_and_foothold) {
  Numbers numbers(7);
  int gaps = 0, moves = 0;
  for (int n = 0; n < 200; ++n) {
    const double time = numbers.uniform(0.1, 0.7);
    const Step step = any(numbers, time);
    double gap = 0.0, moved = 0.0;
    for (const StepAxis& a : step.axes) {
      const Found found = search(a, step.limits, time);
      gaps += found.gap > 0.01;
      moves += found.moved > 0.01;
      gap += found.gap * found.gap;
      moved += found.moved * found.moved;
    }
    const double cost = step.cost(time, {0.0, 0.0, 0.0});
    CHECK_NEAR(std::sqrt(cost), std::sqrt(gap), 1e-3);
    CHECK_NEAR(std::sqrt(step.cost(time, {1.0, 0.0, 0.0}) - cost), std::sqrt(moved), 2e-3);
  }
  BOOST_CHECK_GT(gaps, 50);
  BOOST_CHECK_GT(moves, 50);
}

BOOST_AUTO_TEST_CASE(
    the_time_that_is_chosen_lies_within_its_limits_and_costs_no_more_than_the_one_before_or_as_planned) {
  Numbers numbers(8);
  int changed = 0;
  for (int n = 0; n < 2000; ++n) {
    Step step = any(numbers, 0.4);
    step.limits.least = numbers.uniform(0.05, 0.3);
    step.limits.most = numbers.uniform(0.3, 1.2);
    step.limits.current = numbers.uniform(step.limits.least, step.limits.most);
    const double time = step.time(), planned = std::max(step.limits.planned, step.limits.least);
    BOOST_CHECK_GE(time, step.limits.least);
    BOOST_CHECK_LE(time, std::max(step.limits.most, planned));
    BOOST_CHECK_LE(step.cost(time), step.cost(step.limits.current) + kWeights.band);
    changed += time != planned && time != step.limits.current;
    // No landing in between is better by more than what the times in between two candidates differ by.
    if (time != step.limits.current && time != planned)
      BOOST_CHECK_LE(step.cost(time), step.cost(step.limits.current) - kWeights.band);
  }
  BOOST_CHECK_GT(changed, 500);
}

BOOST_AUTO_TEST_CASE(more_room_for_zmp_or_foothold_or_a_swifter_foot_never_costs_more) {
  Numbers numbers(9);
  int cheaper = 0;
  const StepWeights gaps{0.0, 0.0, 0.0};
  for (int n = 0; n < 1000; ++n) {
    const double time = numbers.uniform(0.05, 0.7);
    const Step step = any(numbers, time);
    for (int what = 0; what < 3; ++what) {
      Step wider = step;
      for (StepAxis& a : wider.axes) {
        const double more = numbers.uniform(0.0, 0.05);
        if (what == 0) {
          a.zmp_lower -= more;
          a.zmp_upper += more;
        } else if (what == 1) {
          a.place_lower -= more;
          a.place_upper += more;
        } else {
          a.foot_acceleration *= 1.0 + 20.0 * more;
        }
      }
      BOOST_CHECK_LE(wider.cost(time, gaps), step.cost(time, gaps) + 1e-15);
      if (what == 0) BOOST_CHECK_LE(wider.cost(time), step.cost(time) + 1e-15);
      cheaper += wider.cost(time, gaps) < step.cost(time, gaps) - 1e-6;
    }
  }
  BOOST_CHECK_GT(cheaper, 500);
}

BOOST_AUTO_TEST_CASE(a_step_and_its_mirror_image_cost_the_same) {
  Numbers numbers(10);
  for (int n = 0; n < 200; ++n) {
    const Step step = any(numbers, 0.3);
    Step mirrored = step;
    for (StepAxis& a : mirrored.axes)
      a = {-a.xi,   -a.zmp_upper,     -a.zmp_lower,        -a.place, -a.drift, -a.place_upper, -a.place_lower,
           -a.foot, -a.foot_velocity, a.foot_acceleration, -a.offset};
    std::swap(mirrored.axes[0], mirrored.axes[1]);
    for (const double time : {0.05, 0.3, 0.8}) CHECK_NEAR(mirrored.cost(time), step.cost(time), 1e-14);
    BOOST_CHECK_EQUAL(mirrored.time(), step.time());
  }
}

BOOST_AUTO_TEST_CASE(a_landing_at_once_has_a_cost_and_a_foot_without_time_stays_where_it_is) {
  Step step = Step::pushed(0.1, 0.2);
  for (StepAxis& a : step.axes) a.foot_velocity = 0.3;
  for (const double time : {0.1, 1e-3, 1e-6, 1e-12, 1e-300, 0.0}) BOOST_CHECK(std::isfinite(step.cost(time)));
  CHECK_NEAR(step.cost(1e-9), step.cost(0.0), 1e-8);
  step.limits = {-0.2, 1e-9, 1e-9, 1e-9, 0.08};
  BOOST_CHECK_EQUAL(step.time(), 1e-9);
  step.limits.most = 0.0;  // before the earliest
  BOOST_CHECK_EQUAL(step.time(), 1e-9);
}
