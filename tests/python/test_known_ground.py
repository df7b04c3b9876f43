"""Ground that the controller is told of: stairs and slopes are walked, and the feet are set where there is room."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import KnownGround, Patch, Terrain

TREAD = 0.28


def walk(terrain, duration, profile=0.25, **more):
    return zmpwalk.simulate(duration=duration, terrain=terrain, profile=profile, known=True, **more)


def shifted(terrain, by):
    """The same ground, by so much further ahead."""
    ground = Terrain.of(terrain)
    return Terrain(ground.text, [p._replace(x=(p.x[0] + by, p.x[1] + by)) for p in ground.patches])


@pytest.mark.parametrize("start", [0.0, 0.1, 0.2])
def test_stairs_are_walked_up_and_down(start):
    trace = walk(shifted("stairs:12x28", start), 21.0)
    assert not trace.meta["fell"]
    assert trace.com[:, 2].max() > trace.com[0, 2] + 1.15  # it was on the landing
    assert trace.com[-1, 0] > 6.4 + start and trace.ground[-1] == pytest.approx(0.0, abs=0.07)


def test_soles_stand_wholly_on_a_tread():
    trace = walk("stairs:12x28", 9.0)
    half = 0.5 * trace.description.left.length
    edges = 0.5 + TREAD * np.arange(10)
    stands = trace.phase == 0
    for foot in (trace.foot_left[stands, 0], trace.foot_right[stands, 0]):
        away = np.abs(foot[:, None] - edges[None])
        assert away.min() > half - 1e-3


@pytest.mark.parametrize("azimuth", [0, 45, 90, 180])
def test_known_slopes_of_fifteen_degrees_are_walked(azimuth):
    trace = walk(f"slope:15,{azimuth}", 8.0)
    assert not trace.meta["fell"] and trace.com[-1, 0] > 1.6
    assert not trace.uneven.any()  # it is as was told


def test_flat_ground_that_is_known_is_walked_as_any_flat_ground():
    told, plain = walk("flat", 4.0), zmpwalk.simulate(duration=4.0, terrain="flat", profile=0.25)
    np.testing.assert_allclose(told.com, plain.com, atol=1e-6)


def test_it_stands_before_ground_that_has_no_place_for_a_foot():
    ground = [Patch((-3.0, 1.0), (-5.0, 5.0))]
    trace = zmpwalk.simulate(duration=12.0, profile=0.25, ground=ground)
    assert not trace.meta["fell"]
    assert max(trace.foot_left[:, 0].max(), trace.foot_right[:, 0].max()) < 1.0 - 0.5 * trace.description.left.length


def test_a_trace_keeps_what_was_known(tmp_path):
    trace = walk("stairs:5x30", 2.0)
    assert trace.rerun().identical(trace)


def test_ground_is_given_as_patches_a_function_a_grid_and_words():
    slope = lambda x, y: 0.1 * x - 0.05 * y  # noqa: E731
    by_function = KnownGround.of_function(slope, x=(-1, 2), y=(-1, 1), spacing=0.1)
    by_patch = KnownGround.of([Patch((-1, 2), (-1, 1), slope(0.5, 0.0), (0.1, -0.05))])
    for ground in (by_function, by_patch):
        assert ground.known
        assert ground.height([0.33, 0.41]) == pytest.approx(slope(0.33, 0.41), abs=1e-12)
        np.testing.assert_allclose(ground.rise([0.33, 0.41]), (0.1, -0.05), atol=1e-12)
        assert np.isnan(ground.height([3.0, 0.0]))
        again = KnownGround.from_dict(KnownGround.to_dict(ground))
        assert again.height([0.2, 0.2]) == ground.height([0.2, 0.2])
    stairs = KnownGround.of("stairs:12x28")
    assert stairs.height([0.6, 0.0]) == pytest.approx(0.12) and stairs.height([0.9, 0.0]) == pytest.approx(0.24)
    assert not zmpwalk.KnownGround().known


def test_ground_is_read_from_an_hfield():
    model = mujoco.MjModel.from_xml_string(
        """<mujoco><asset><hfield name="h" nrow="3" ncol="5" size="2 1 0.4 0.1"/>
        </asset><worldbody><geom name="hills" type="hfield" hfield="h" pos="1 0 0.2"/></worldbody></mujoco>"""
    )
    model.hfield_data[7] = 1.0
    ground = KnownGround.of("hills", model)
    assert ground.height([1.0, 0.0]) == pytest.approx(0.6) and ground.height([-1.0, 1.0]) == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("ground", "says"),
    [
        ([Patch((1, 1), (0, 1))], "no area"),
        ([Patch((0, 1), (0, 1), float("nan"))], "not finite"),
        (3.0, "is no ground"),
        ("hills", "unknown"),
    ],
)
def test_what_is_no_ground_is_refused(ground, says):
    with pytest.raises(zmpwalk.InputError, match=says):
        KnownGround.of(ground)


def test_known_needs_a_terrain():
    with pytest.raises(zmpwalk.InputError, match="give a terrain"):
        zmpwalk.simulate(duration=1.0, known=True)
    with pytest.raises(zmpwalk.InputError, match="does not stand on the ground"):
        zmpwalk.simulate(duration=1.0, ground=[Patch((5, 6), (0, 1))])


def test_a_patch_of_ice_under_one_foot_is_felt_and_walked():
    far, icy = (-20.0, 20.0), (0.5, 1.0)
    ground = [
        Patch((-3.0, 0.5), far),
        Patch((1.0, 40.0), far),
        Patch(icy, (0.0, 20.0), friction=0.1),
        Patch(icy, (-20.0, 0.0)),
    ]
    walk = {"profile": 0.15, "duration": 9.0, "terrain": Terrain("ice", ground)}
    trace = zmpwalk.simulate(**walk, settings={"feel_slip": True})
    assert not trace.meta["fell"] and trace.com[-1, 0] > 1.0
    assert trace.friction.min() < 0.12 and trace.friction[0] == 1.0  # it is found, not known
    assert trace.rerun().com[-1, 0] == trace.com[-1, 0]
    numb = zmpwalk.simulate(**walk)
    assert numb.meta["fell"] and (numb.friction == 1.0).all()


def test_a_sole_that_its_swing_leg_turns_does_not_slip(test_robots):
    profile = zmpwalk.VelocityProfile.ramp(0.0, 0.5, 2.0)
    trace = zmpwalk.simulate(
        test_robots / "unitree_g1" / "robot.json", profile=profile, duration=6.0, settings={"feel_slip": True}
    )
    assert not trace.meta["fell"] and (trace.friction == trace.friction[0]).all()
