#include <Eigen/Geometry>
#include <cmath>

#include "robots.hpp"
#include "zmpwalk/control/wrench_distribution.hpp"
#include "zmpwalk/zmp/contact.hpp"
#include "zmpwalk/zmp/estimate.hpp"
#include "zmpwalk/zmp/plane.hpp"
#include "zmpwalk/zmp/reference_iteration.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

constexpr double kTilt = 10.0 * M_PI / 180.0;  // the steepest ground that is asked for
constexpr double kLength = 0.25, kWidth = 0.14;

/// Rotation by `angle` about the horizontal axis in direction `azimuth`.
Mat3 tilt(double angle, double azimuth) {
  return Eigen::AngleAxisd(angle, Vec3(std::cos(azimuth), std::sin(azimuth), 0.0)).toRotationMatrix();
}
Mat3 random_tilt(Numbers& numbers) { return tilt(numbers.uniform(0.0, kTilt), numbers.uniform(-M_PI, M_PI)); }

Plane random_plane(Numbers& numbers) {
  return Plane::through(numbers.vector(3, 0.3), random_tilt(numbers) * Vec3::UnitZ());
}

/// A foot that stands flat with its sole's centre at `c` on ground of tilt `R`.
Contact foot_on(const Mat3& R, const Vec3& c) {
  return {c, R, true, Plane::through(c, R.col(2)), kLength, kWidth, 1.0};
}

/// Two feet, 0.22 m apart, up to `ahead` along x and 5 cm along z, each on its own slope of up to 10 deg.
std::array<Contact, 2> random_feet(Numbers& numbers, double ahead = 0.2) {
  const Vec3 half(0.5 * numbers.uniform(-ahead, ahead), 0.11, numbers.uniform(-0.025, 0.025));
  const Mat3 R_left = random_tilt(numbers), R_right = random_tilt(numbers);
  return {foot_on(R_left, half), foot_on(R_right, -half)};
}

/// Robot on ground: weight, and what accelerating the COM by up to 1 m/s^2 adds.
Vec3 random_load(Numbers& numbers) { return Vec3(0, 0, -600) + numbers.vector(3, 60); }

/// The humanoid at a random instant on random ground, with both routes to its ZMP.
struct Instant {
  Instant(Standing standing, unsigned seed, bool textbook = false)
      : robot(mahru(), describe(mahru())),
        data(make_data(mahru())),
        stance(stance_of(standing)),
        controller(robot.nv(), robot.leg_joints(), options(textbook)),
        estimator(robot.nv()) {
    randomize(robot, data.get(), seed);
    robot.read(data.get());
    Numbers numbers(seed);
    for (const Side side : kSides) {  // slopes under both feet, up to 5 cm apart in height
      Vec3 p = dyn().sole[side].p_WF;
      p.z() = numbers.uniform(-0.025, 0.025);
      stance.ground[side] = Plane::through(p, random_tilt(numbers) * Vec3::UnitZ());
    }
    controller.prepare(dyn(), stance, random_tasks(robot.joints(), seed));
    const ContactRows rows = contact_rows(dyn(), stance);
    estimator.update(dyn().A, dyn().b, dyn().g, rows.J, rows.drift, controller.feet(), stance.support);
  }
  static WholeBodyOptions options(bool textbook) {
    WholeBodyOptions out;
    out.textbook = textbook;
    return out;
  }
  const Dynamics& dyn() const { return robot.dynamics(); }
  WholeBodyResult solve(const Vec2& f_xy) const {
    WholeBodyResult out = controller.result();
    controller.solve(f_xy, out);
    return out;
  }

  Robot robot;
  MjDataPtr data;
  Stance stance;
  WholeBodyController controller;
  ZmpEstimator estimator;
};

template <class Check>
void on_random_ground(Check&& check) {
  for (const Standing standing : kStandings)
    for (unsigned seed = 0; seed < 20; ++seed) check(Instant(standing, seed), Vec2(Numbers(seed).vector(2, 3.0)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(about_the_zmp_a_wrench_has_a_moment_along_the_normal_only) {
  Numbers numbers(1);
  for (int i = 0; i < 100; ++i) {
    const Plane plane = random_plane(numbers);
    const Vec3 F = random_load(numbers), M = numbers.vector(3, 50), s = numbers.vector(3, 0.5);
    const Vec3 P = zmp_on_plane(F, M, s, plane);
    BOOST_CHECK_SMALL(plane.distance(P), 1e-14);
    CHECK_NEAR(plane.normal.cross(Vec3(M - (P - s).cross(F))), Vec3::Zero(), 1e-12);
    // Wherever the moment is taken, and whichever sign the wrench has.
    const Vec3 other = numbers.vector(3, 0.5);
    CHECK_NEAR(zmp_on_plane(F, M - (other - s).cross(F), other, plane), P, 1e-13);
    CHECK_NEAR(zmp_on_plane(-F, -M, s, plane), P, 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(zmp_on_a_slope_by_hand) {
  // A weight straight below the point (0.03, -0.02): its line of action meets z = 0.1 + 0.2 x there.
  const Vec3 F(0, 0, -100), X(0.03, -0.02, 0.5);
  const Plane slope = Plane::through(Vec3(0, 0, 0.1), Vec3(-0.2, 0, 1).normalized());
  CHECK_NEAR(zmp_on_plane(F, X.cross(F), Vec3::Zero(), slope), Vec3(0.03, -0.02, 0.106), 1e-15);
  CHECK_NEAR(slope.height({0.03, -0.02}), 0.106, 1e-15);
}

BOOST_AUTO_TEST_CASE(zmp_turns_and_moves_with_everything) {
  Numbers numbers(2);
  for (int i = 0; i < 50; ++i) {
    const Vec3 F = random_load(numbers), M = numbers.vector(3, 50), s = numbers.vector(3, 0.5),
               move = numbers.vector(3, 1);
    const Mat3 R = random_tilt(numbers);
    Vec3 flat = s;
    flat.head<2>() += zmp_of_wrench(F, M);  // on the level plane through s, as printed
    const Plane plane = Plane::through(R * s + move, R.col(2));
    CHECK_NEAR(zmp_on_plane(R * F, R * M, R * s + move, plane), Vec3(R * flat + move), 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(on_a_level_plane_through_the_point_the_zmp_has_the_bits_of_the_printed_ratios) {
  Numbers numbers(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 F = random_load(numbers), M = numbers.vector(3, 50), s = numbers.vector(3, 5);
    const Vec3 P = zmp_on_plane(F, M, s, Plane::through(s));
    CHECK_NEAR(P, Vec3(s.x() - M.y() / F.z(), s.y() + M.x() / F.z(), s.z()), 0.0);
    CHECK_NEAR(zmp_of_wrench(F, M), Vec2(-M.y() / F.z(), M.x() / F.z()), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(feet_on_one_plane_have_its_normal_exactly_however_deep_they_sink) {
  Numbers numbers(4);
  for (int i = 0; i < 100; ++i) {
    std::array<Contact, 2> feet = random_feet(numbers);
    const Plane ground = i % 2 ? random_plane(numbers) : Plane{Vec3::UnitZ(), numbers.uniform(-1, 1)};
    for (Contact& foot : feet) foot.ground = ground;
    for (const Side support : kSides) {
      const Plane plane = common_plane(feet, support);
      BOOST_CHECK(plane == Plane::through(feet[support].p_WF, ground.normal));
      if (i % 2 == 0) BOOST_CHECK_EQUAL(plane.offset, feet[support].p_WF.z());
    }
  }
}

BOOST_AUTO_TEST_CASE(common_plane_contains_both_soles_and_leans_as_the_grounds_do_on_average) {
  Numbers numbers(5);
  for (int i = 0; i < 100; ++i) {
    const std::array<Contact, 2> feet = random_feet(numbers);
    const Plane plane = common_plane(feet, kLeft);
    BOOST_CHECK_SMALL(plane.normal.norm() - 1.0, 1e-15);
    BOOST_CHECK_SMALL(plane.distance(feet[kLeft].p_WF), 1e-15);
    BOOST_CHECK_SMALL(plane.distance(feet[kRight].p_WF), 1e-15);
    // Across the line between the feet the lean is the mean of both.
    const Vec3 u = feet[kLeft].p_WF - feet[kRight].p_WF,
               mean = 0.5 * (feet[kLeft].ground.normal + feet[kRight].ground.normal);
    BOOST_CHECK_SMALL(u.cross(plane.normal).dot(mean) / u.norm(), 1e-15);
    BOOST_CHECK_GT(plane.normal.dot(mean), 0.9);
    // Which foot supports moves the plane along itself only; nor does it matter which foot is called left.
    CHECK_NEAR(common_plane(feet, kRight).normal, plane.normal, 1e-15);
    CHECK_NEAR(common_plane({feet[kRight], feet[kLeft]}, kRight).normal, plane.normal, 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(common_plane_of_level_grounds_at_two_heights_goes_up_with_the_step) {
  const std::array<Contact, 2> feet{foot_on(Mat3::Identity(), Vec3(0, 0.1, 0.05)),
                                    foot_on(Mat3::Identity(), Vec3(0, -0.1, 0))};
  CHECK_NEAR(common_plane(feet, kLeft).normal, Vec3(0, -0.05, 0.2).normalized(), 1e-15);
}

BOOST_AUTO_TEST_CASE(on_one_foot_the_zmp_is_taken_on_its_ground) {
  Numbers numbers(6);
  std::array<Contact, 2> feet = random_feet(numbers);
  feet[kLeft].standing = false;
  BOOST_CHECK(common_plane(feet, kRight) == Plane::through(feet[kRight].p_WF, feet[kRight].ground.normal));
}

BOOST_AUTO_TEST_CASE(common_plane_is_continuous_in_the_tilt_of_either_ground) {
  for (const double azimuth : {0.0, 0.7, 1.6, -2.5})
    for (const double start : {-kTilt, -1e-5, 0.0, 1e-9, kTilt}) {
      const Vec3 left(0.05, 0.11, 0.05), right(-0.05, -0.11, 0);
      const auto normal = [&](double angle) {
        return common_plane({foot_on(tilt(angle, azimuth), left), foot_on(tilt(0.05, 1.0), right)}, kLeft).normal;
      };
      CHECK_NEAR(normal(start + 1e-6), normal(start), 1e-6);
      // From one common plane, where the branch is, too.
      const auto from_level = [&](double angle) {
        const Mat3 R = tilt(angle, azimuth);
        Contact tilted = foot_on(R, Vec3(0.05, 0.11, 0)), level = foot_on(Mat3::Identity(), Vec3(-0.05, -0.11, 0));
        return common_plane({tilted, level}, kLeft).normal;
      };
      CHECK_NEAR(from_level(1e-9), Vec3::UnitZ(), 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(feet_one_above_the_other_still_have_a_plane) {
  const std::array<Contact, 2> feet{foot_on(Mat3::Identity(), Vec3(0, 0, 0.3)),
                                    foot_on(Mat3::Identity(), Vec3(0, 0, 0))};
  BOOST_CHECK(common_plane(feet, kRight) == Plane{});
}

BOOST_AUTO_TEST_CASE(points_of_a_tilted_sole_go_to_the_world_and_back) {
  Numbers numbers(7);
  for (int i = 0; i < 50; ++i) {
    const Contact foot = foot_on(random_tilt(numbers) * tilt(0.0, 0.0), numbers.vector(3, 1));
    const Vec2 p_F = numbers.vector(2, 0.1);
    CHECK_NEAR(foot.to_sole(foot.to_world(p_F)), p_F, 1e-15);
    // The world point at that x and y on the sole's plane is the sole's point.
    const Vec2 xy = foot.to_world(p_F);
    const Vec3 p(xy.x(), xy.y(), foot.ground.height(xy));
    CHECK_NEAR((foot.R_WF.transpose() * (p - foot.p_WF)).eval(), Vec3(p_F.x(), p_F.y(), 0), 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(centre_of_pressure_is_where_a_push_through_the_sole_acts) {
  Numbers numbers(8);
  for (int i = 0; i < 50; ++i) {
    const Contact foot = foot_on(random_tilt(numbers), numbers.vector(3, 1));
    const Vec2 p_F(numbers.uniform(-0.15, 0.15), numbers.uniform(-0.1, 0.1));
    const Vec3 F = random_load(numbers), arm = foot.R_WF.leftCols<2>() * p_F;
    Vec6 f;
    f << F, arm.cross(F) + numbers.uniform(-5, 5) * foot.R_WF.col(2);
    CHECK_NEAR(foot.cop(f), p_F, 1e-15);
    BOOST_CHECK_EQUAL(foot.can_carry(f), std::abs(p_F.x()) <= 0.125 && std::abs(p_F.y()) <= 0.07);
    BOOST_CHECK(!foot.can_carry(-f));  // no sole pulls
    Contact slippery = foot, unknown = foot;
    slippery.friction = 0.0;
    unknown.friction = kNaN;
    BOOST_CHECK(!slippery.can_carry(f) && !unknown.can_carry(f));
  }
}

BOOST_AUTO_TEST_CASE(wrench_on_tilted_soles_adds_up_and_stays_on_each_sole_while_the_zmp_is_between_them) {
  Numbers numbers(9);
  for (int i = 0; i < 500; ++i) {
    // Where one foot is ahead, carrying alone moves its load by some of that way: then the feet are abreast.
    const double alone = i % 2 ? 0.05 : 0.0;
    const std::array<Contact, 2> feet = random_feet(numbers, alone > 0.0 ? 0.0 : 0.2);
    const Plane plane = common_plane(feet, kLeft);
    // A ZMP between the feet: up to 0.8 of the half length ahead of or behind their line.
    const Vec3 F = random_load(numbers), across = plane.normal.cross(Vec3::UnitY()).normalized();
    const double a = numbers.uniform(0, 1), ahead = numbers.uniform(-0.8, 0.8) * 0.5 * kLength;
    const Vec3 P = a * feet[kLeft].p_WF + (1 - a) * feet[kRight].p_WF + ahead * across;
    const Vec3 M_P = numbers.uniform(-5, 5) * plane.normal;
    const std::array<Vec3, 2> c{feet[kLeft].p_WF, feet[kRight].p_WF};
    const Vec12 f = distribute_wrench(F, M_P, P, c, Vec3::UnitY(), alone);
    const Wrench total = total_wrench(f, c, P);
    CHECK_NEAR(total.F, F, 1e-11);
    CHECK_NEAR(total.M, M_P, 1e-11);
    CHECK_NEAR(zmp_on_plane(total.F, total.M, P, plane), P, 1e-13);
    for (const Side side : kSides) {
      const Vec6 f_i = f.segment<6>(6 * side);
      if (f_i.norm() < 1e-9) continue;  // the other foot has it all
      const Vec2 cop = feet[side].cop(f_i);
      BOOST_CHECK_LE(std::abs(cop.x()), 0.5 * kLength);
      BOOST_CHECK_LE(std::abs(cop.y()), 0.5 * kWidth);
      BOOST_CHECK(feet[side].can_carry(f_i));
    }
  }
}

BOOST_AUTO_TEST_CASE(three_routes_lead_to_one_zmp_on_tilted_ground) {
  for (const bool textbook : {false, true})
    for (const Standing standing : kStandings)
      for (unsigned seed = 0; seed < 10; ++seed) {
        const Instant at(standing, seed, textbook);
        const Vec2 f_xy = Numbers(seed).vector(2, 3.0);
        const WholeBodyResult out = at.solve(f_xy);
        const ZmpEstimate estimate = at.estimator.estimate(out.tau);
        BOOST_CHECK(at.estimator.zmp_plane() == at.controller.zmp_plane());
        const Vec3& s = at.dyn().sole[at.stance.support].p_WF;
        const Wrench total = total_wrench(out.f_c, {at.dyn().sole[kLeft].p_WF, at.dyn().sole[kRight].p_WF}, s);
        CHECK_NEAR(at.controller.zmp(f_xy), zmp_on_plane(total.F, total.M, s, at.controller.zmp_plane()).head<2>(),
                   1e-9);
        CHECK_NEAR(at.controller.zmp(f_xy), estimate.zmp, 1e-9);
        BOOST_CHECK_GT(at.controller.zmp_plane().normal.head<2>().norm(), 1e-3);
      }
}

BOOST_AUTO_TEST_CASE(on_tilted_ground_the_load_changes_with_the_acceleration_and_the_slope_is_the_derivative_there) {
  on_random_ground([](const Instant& at, const Vec2& f_xy) {
    constexpr double h = 1e-4;
    const Mat2 slope = at.controller.zmp_slope(at.controller.zmp(f_xy), f_xy);
    for (int k = 0; k < 2; ++k) {
      const Vec2 step = h * Vec2::Unit(k);
      const Vec2 difference = (at.controller.zmp(f_xy + step) - at.controller.zmp(f_xy - step)) / (2 * h);
      CHECK_NEAR(slope.col(k), difference, 1e-9);
    }
    CHECK_NEAR(at.controller.zmp_slope(at.controller.zmp(Vec2::Zero()), Vec2::Zero()), at.controller.zmp_slope(), 0.0);
    // The chord, by which the closed form is exact.
    const Vec2 wanted = at.controller.zmp(f_xy), start(-f_xy.y(), f_xy.x());
    CHECK_NEAR(at.controller.zmp_slope(wanted, start) * (f_xy - start), wanted - at.controller.zmp(start), 1e-12);
  });
}

BOOST_AUTO_TEST_CASE(closed_form_lands_in_two_passes_on_tilted_ground_along_one_axis_or_both) {
  on_random_ground([](const Instant& at, const Vec2& f_xy) {
    const double df_dr = -10.0;  // about -g / z_c
    for (const Vec2& axes : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
      const Vec2 wanted = at.controller.zmp(f_xy), kept(0.4, -0.3);
      const auto acceleration = [&](const Vec2& r) -> Vec2 {
        return df_dr * axes.cwiseProduct(r - at.dyn().com.head<2>()) + (Vec2::Ones() - axes).cwiseProduct(kept);
      };
      const auto estimate = [&](const Vec2& r) { return at.controller.zmp(acceleration(r)); };
      const Mat2 slope = df_dr * at.controller.zmp_slope(wanted, acceleration(wanted));
      const ReferenceResult found = solve_reference(estimate, wanted, Vec2::Zero(), axes, slope, 1e-10);
      BOOST_CHECK(found.converged);
      CHECK_NEAR(axes.cwiseProduct(found.zmp_est), axes.cwiseProduct(wanted), 1e-12);
    }
  });
}

BOOST_AUTO_TEST_CASE(level_ground_at_any_height_gives_the_bits_of_the_default) {
  for (const Standing standing : kStandings) {
    const Instant tilted(standing, 3);
    WholeBodyController controller(tilted.robot.nv(), tilted.robot.leg_joints());
    const TaskAccelerations f = random_tasks(tilted.robot.joints(), 3);
    const Stance stance = stance_of(standing);
    Stance raised = stance;
    raised.ground.fill({Vec3::UnitZ(), 0.37});
    WholeBodyResult one = controller.result(), two = one;
    const Vec2 f_xy(0.7, -0.2);
    controller.prepare(tilted.dyn(), stance, f);
    const Vec2 zmp = controller.zmp(f_xy), printed = controller.zmp(Vec2::Zero()) + controller.zmp_slope() * f_xy;
    CHECK_NEAR(zmp, printed, 0.0);
    controller.solve(f_xy, one);
    controller.prepare(tilted.dyn(), raised, f);
    controller.solve(f_xy, two);
    CHECK_NEAR(controller.zmp(f_xy), zmp, 0.0);
    CHECK_NEAR(one.tau, two.tau, 0.0);
    CHECK_NEAR(controller.zmp_slope(Vec2(0.3, 0.1), f_xy), controller.zmp_slope(), 0.0);
  }
}
