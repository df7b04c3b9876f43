#include "zmpwalk/gait/lateral_law.hpp"

#include <cctype>
#include <set>

#include "testing.hpp"
#include "zmpwalk/gait/lateral_motion.hpp"
#include "zmpwalk/gait/tracker_law.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const LinearInvertedPendulum kPendulum(0.747, 9.81);
const WalkSettings kSettings;

/// A sway to the left of the right foot, with some time to go.
Sway sway(const PendulumState& now, double xi_end, double time) {
  return {kSettings, kPendulum, kRight, now, kPendulum.dcm(now), xi_end, time, kPendulum.growth(time)};
}

LateralLawName lateral(const char* name) { return chosen<LateralLawName>("zmp.lateral_law", name); }

/// After the switch, when the law is asked.
LateralMotion after_switch(const char* law, double most) {
  LateralMotion motion(lateral(law), most);
  motion.reset(kLeft);
  motion.end_double_support();
  return motion;
}

/// Names are words of their own, which the setting takes and gives back; each says in half a sentence what it does.
template <class Law, class Name>
void is_a_table_of_laws() {
  std::set<std::string> names;
  for (const Law& law : Law::all()) {
    BOOST_CHECK_MESSAGE(names.insert(law.name).second, law.name);
    BOOST_CHECK_EQUAL(&Law::of(chosen<Name>("law", law.name)), &law);
    BOOST_CHECK_EQUAL(to_string(chosen<Name>("law", law.name)), law.name);
    const std::string meaning = law.meaning;
    BOOST_CHECK_MESSAGE(meaning.size() > 10 && std::islower(meaning.front()) && meaning.back() != '.', law.name);
  }
  BOOST_CHECK_EQUAL(choices(Name{}).size(), Law::all().size());
  BOOST_CHECK_EQUAL(&Law::of(Name{}), &Law::all().front());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_law_is_a_row_of_its_table_and_its_name_is_a_value_of_the_setting) {
  is_a_table_of_laws<LateralLaw, LateralLawName>();
  is_a_table_of_laws<TrackerLaw, TrackerLawName>();
  BOOST_CHECK_EQUAL(to_string(WalkSettings().zmp.lateral_law), "orbit");
  BOOST_CHECK_EQUAL(to_string(WalkSettings("paper").zmp.lateral_law), "paper");
  BOOST_CHECK_EQUAL(to_string(WalkSettings().tracking.law), "smooth");
  BOOST_CHECK_EQUAL(to_string(WalkSettings("paper").tracking.law), "bang_bang");
}

BOOST_AUTO_TEST_CASE(an_unknown_law_is_answered_with_all_that_there_are_and_the_nearest) {
  CHECK_THROWS(lateral("orbt"), InputError, "zmp.lateral_law = 'orbt' is unknown; there are: orbit, paper");
  CHECK_THROWS(lateral("orbt"), InputError, "; did you mean 'orbit'?");
  CHECK_THROWS(chosen<TrackerLawName>("tracking.law", "bangbang"), InputError, "; did you mean 'bang_bang'?");
  try {
    lateral("pid");
    BOOST_ERROR("there is no law 'pid'");
  } catch (const InputError& error) {
    BOOST_CHECK(std::string(error.what()).find("did you mean") == std::string::npos);  // none is near
  }
}

BOOST_AUTO_TEST_CASE(the_orbit_law_brings_the_dcm_to_the_orbit_and_the_paper_law_leaves_the_zmp_in_the_middle) {
  Numbers numbers(1);
  const LateralMotion orbit = after_switch("orbit", 10.0), paper = after_switch("paper", 10.0);
  for (int i = 0; i < 20; ++i) {
    const Sway at = sway({numbers.uniform(-0.05, 0.1), numbers.uniform(-0.2, 0.2)}, numbers.uniform(0.0, 0.2), 0.4);
    const double r = orbit.reference(at);
    CHECK_NEAR(kPendulum.dcm(kPendulum.step(at.time, at.now, r)), at.xi_end, 1e-12);
    CHECK_NEAR(orbit.miss(at), 0.0, 1e-15);
    BOOST_CHECK_EQUAL(paper.reference(at), 0.0);
    BOOST_CHECK_EQUAL(paper.miss(at), 0.0);
  }
}

BOOST_AUTO_TEST_CASE(what_a_lateral_law_asks_for_is_bounded_and_the_miss_says_where_the_dcm_then_ends) {
  Numbers numbers(2);
  const double most = 0.01;
  const LateralMotion motion = after_switch("orbit", most);
  int bounded = 0;
  for (int i = 0; i < 50; ++i) {
    const Sway at = sway({numbers.uniform(-0.05, 0.1), numbers.uniform(-0.2, 0.2)}, numbers.uniform(0.0, 0.2), 0.4);
    const double r = motion.reference(at), end = kPendulum.dcm(kPendulum.step(at.time, at.now, r));
    BOOST_CHECK_LE(std::abs(r), most);
    CHECK_NEAR(motion.miss(at), end - at.xi_end, 1e-12);
    bounded += std::abs(r) == most;
  }
  BOOST_CHECK_GT(bounded, 10);
}

BOOST_AUTO_TEST_CASE(no_lateral_law_is_asked_before_the_switch_or_when_no_time_is_left) {
  LateralMotion motion(lateral("orbit"), 10.0);
  motion.reset(kLeft);
  const Sway off = sway({0.05, 0.1}, 0.0, 0.4);
  BOOST_CHECK_EQUAL(motion.reference(off), 0.0);
  BOOST_CHECK_EQUAL(motion.miss(off), 0.0);
  motion.end_double_support();
  BOOST_CHECK_NE(motion.reference(off), 0.0);
  const Sway late = sway({0.05, 0.1}, 0.0, 0.0);
  BOOST_CHECK_EQUAL(motion.reference(late), 0.0);
  BOOST_CHECK_EQUAL(motion.miss(late), 0.0);
}

BOOST_AUTO_TEST_CASE(every_lateral_law_switches_where_the_double_support_ends_whatever_it_says) {
  for (const LateralLaw& law : LateralLaw::all()) {
    LateralMotion motion(lateral(law.name), 0.03);
    motion.reset(kRight);
    // At rest over the right foot, the left one far away: no time to switch by (18).
    const double dt = 1e-3;
    const auto check = [&](double left) {
      motion.check_switch(kPendulum, {0.0, 0.0}, 0.0, 0.3, 0.5, 0.0, dt, left);
      motion.begin_cycle(false);
    };
    check(0.1);
    BOOST_CHECK_MESSAGE(motion.awaits_switch() || law.switches != LateralLaw::all().front().switches, law.name);
    check(dt);
    BOOST_CHECK_MESSAGE(!motion.awaits_switch() && motion.support() == kLeft, law.name);
  }
}
