#include "zmpwalk/gait/lateral_law.hpp"

namespace zmpwalk {
namespace {

// --- where the ZMP is

/// The constant ZMP that brings the DCM to where the symmetric orbit has it. It is zero on that orbit.
double to_the_orbit(const Sway& sway) { return sway.pendulum.reference_to_reach(sway.xi, sway.xi_end, sway.growth); }

/// (17): the COM sways about the middle of the sole.
double in_the_middle(const Sway&) { return 0.0; }

// --- when the support switches

/// The switch rule of the paper, w(T) = 0, taken in the nearer of the two cycles on either side of it.
///
/// Too early, the COM would turn back before the middle of the step: w(T) then points away from the foot to come. Always the later cycle
/// would be half a cycle late on average.
bool at_zero_velocity(const SwayToCome& sway) { return sway.side * (sway.next + sway.later) >= 0.0; }

}  // namespace

const std::vector<LateralLaw>& LateralLaw::all() {
  static const std::vector<LateralLaw> laws{
      {"orbit", "shifts it so that the sway repeats", to_the_orbit, at_zero_velocity},
      {"paper", "leaves it in the middle, so that an error at the start never decays", in_the_middle, at_zero_velocity},
  };
  return laws;
}

const Choices<LateralLawName>& choices(LateralLawName) {
  static const Choices<LateralLawName> names = choices_of<LateralLawName>(LateralLaw::all());
  return names;
}

}  // namespace zmpwalk
