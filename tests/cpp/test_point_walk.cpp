#include <algorithm>
#include <cmath>

#include "testing.hpp"
#include "zmpwalk/gait/point_walk.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const RobotScale kRobot{0.747, 9.81, 0.001, 0.22};
const LinearInvertedPendulum pendulum(kRobot.com_height, kRobot.gravity);
const ZmpBounds kBounds{Vec2(-0.09, -0.0504), Vec2(0.09, 0.0504)};

/// The same as `roll_out`, in many steps of (16).
PendulumState rolled(const VelocityProfile& plan, double t, double time, PendulumState s, const ForwardStance& stance) {
  constexpr int kSteps = 4000;
  const double dt = time / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const double x = s.x - stance.orbit_middle, faster = plan.velocity(t + k * dt).x() - plan.velocity(t).x();
    const double v_want = stance.orbit.velocity(x) + faster + stance.catch_up + stance.dv_capture;
    const double a = stance.orbit.acceleration(x) + (v_want - s.v) / stance.tracker_time;
    s = pendulum.step(dt, s, std::clamp(pendulum.reference_for(s.x, a), stance.lower, stance.upper));
  }
  return s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(rolling_out_in_few_pieces_is_the_pendulum_under_the_tracker_within_the_bounds) {
  const WalkSettings s = resolve(WalkSettings(), kRobot);
  for (const VelocityProfile& plan :
       {VelocityProfile({0.0}, {Vec3(0.25, 0, 0)}), VelocityProfile({0.0, 0.3}, {Vec3(0.25, 0, 0), Vec3(0.3, 0, 0)}),
        VelocityProfile({0.0, 1.0}, {Vec3(0.2, 0, 0), Vec3(0.4, 0, 0)}, Interpolation::kLinear)}) {
    const double v = plan.velocity(0.1).x();
    const ForwardStance stance{ForwardOrbit(pendulum, v, 0.8, 0.08), 0.01, s.tracking.time, 0.01, -0.02, -0.09, 0.09};
    for (const PendulumState& start :
         {PendulumState{-0.05, v}, PendulumState{0.0, 0.7 * v}, PendulumState{-0.1, 1.4 * v}})
      for (const double time : {0.05, 0.3, 0.6}) {
        const PendulumState few = roll_out(pendulum, plan, plan.at(0.1), plan.at(0.1 + time), time, start, stance);
        const PendulumState many = rolled(plan, 0.1, time, start, stance);
        CHECK_NEAR(few.x, many.x, 2e-3);
        CHECK_NEAR(few.v, many.v, 1e-2);
      }
  }
}

BOOST_AUTO_TEST_CASE(from_a_stand_the_com_goes_as_far_as_a_slow_plan_and_runs_away_from_a_fast_one) {
  const WalkSettings s = resolve(WalkSettings(), kRobot);
  const VelocityProfile plan({0.0}, {Vec3(0.25, 0, 0)});
  const double planned = 0.25 * (s.gait.T_ds_first + s.gait.T_ss + s.gait.T_ds);
  const auto far = [&](double scale) { return start_excursion(s, plan, pendulum, kBounds, 0.0, scale); };
  for (const double scale : {0.0, 0.25, 0.5}) CHECK_NEAR(far(scale), scale * planned, 0.05 * planned);
  BOOST_CHECK_GT(far(2.0),
                 1.5 * 2.0 * planned);  // the first stance foot cannot hold the ZMP as far ahead as it would take
}

BOOST_AUTO_TEST_CASE(feet_that_are_at_once_where_they_land_walk_the_same_walk) {
  const WalkSettings s = resolve(WalkSettings(), kRobot);
  GaitInput stand;
  stand.p_sole = {Vec3(0, 0.11, 0), Vec3(0, -0.11, 0)};
  const VelocityProfile plan({0.0, 3.0}, {Vec3(0.2, 0, 0), Vec3(0.1, 0.05, 0.2)});
  PointWalk swing(s, plan, pendulum, {kBounds, kBounds}, {0.25, 0.14}, stand);
  PointWalk at_once(s, plan, pendulum, {kBounds, kBounds}, {0.25, 0.14}, stand);
  for (int k = 0; k < 8000; ++k) {
    swing.step();
    at_once.step(PointWalk::Feet::kAtOnce);
    CHECK_NEAR(swing.in.com, at_once.in.com, 1e-4);
  }
}
