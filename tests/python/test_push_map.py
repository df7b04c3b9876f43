"""The bundled robot's whole push map against what it has borne before; `make check-all` asks for it by ZMPWALK_BIG."""

import os

import numpy as np
import pytest
import zmpwalk

# Impulses that the robot bears at 0.25 m/s in directions 0, 45, ..., 315 degrees, worst phase [N s/kg].
BORNE = {
    "single": [0.36, 0.31, 0.24, 0.33, 0.48, 0.38, 0.36, 0.44],
    "double": [0.48, 0.50, 0.68, 0.66, 0.44, 0.31, 0.23, 0.31],
}


@pytest.fixture(scope="module")
def found():
    if not os.environ.get("ZMPWALK_BIG"):
        pytest.skip("ZMPWALK_BIG is not set: a whole push map takes minutes")
    return zmpwalk.push_map(velocity=0.25, directions=8, phases=8, stances=["left"])


@pytest.mark.parametrize("support", BORNE)
def test_the_robot_bears_what_it_has_borne_before(found, support):
    assert np.all(found.by_direction(support) > np.array(BORNE[support]))


def test_nothing_is_borne_beyond_what_feet_trunk_and_arms_could_catch(found):
    """Where the feet may cross and the whole sole is used, and trunk and arms give 0.1 N s/kg besides."""
    walk = zmpwalk.PendulumWalk.of("mahru", 0.25, crossing=True, sole_share=1.0)
    limit = zmpwalk.pendulum_limit(walk, 8, 8)
    single = [found.support(phase) == "single" for phase in found.phases]
    assert np.all(found.felling[0][single] < limit[single] + 0.1 + 0.05)
