"""The default walk on ground that it is not told of: it feels it, and walks on."""

import numpy as np
import pytest
import zmpwalk


def walk(terrain, duration=12.0, **more):
    return zmpwalk.simulate(duration=duration, terrain=terrain, **{"profile": 0.25, **more})


@pytest.mark.parametrize("azimuth", range(0, 360, 45))
def test_slopes_of_five_degrees_are_walked(azimuth):
    trace = walk(f"slope:5,{azimuth}", 10.0)
    assert not trace.meta["fell"] and trace.com[-1, 0] > 1.5


@pytest.mark.parametrize("at", np.arange(1.0, 1.41, 0.05).round(2))
@pytest.mark.parametrize("cm", [2.0, -2.0])
def test_a_step_is_walked_wherever_it_meets_the_foot(cm, at):
    trace = walk(f"step:{cm},{at}", 8.0)
    assert not trace.meta["fell"]
    assert trace.ground[-1] == pytest.approx(0.01 * cm, abs=1e-3)  # the walk has found its height


@pytest.mark.parametrize("terrain", ["blocks:2,0", "blocks:2,1", "plates:3,0"])
def test_blocks_and_tilted_plates_are_walked(terrain):
    trace = walk(terrain)
    assert not trace.meta["fell"] and trace.com[-1, 0] > 2.0


@pytest.mark.parametrize("azimuth", [0, 90, 225])
def test_the_robot_stands_on_a_slope(azimuth):
    assert not walk(f"slope:10,{azimuth}", 4.0, profile=0.0).meta["fell"]


def test_blocks_that_are_slippery_are_walked():
    assert not walk("blocks:1,0", uncertainty={"ground_friction": 0.3}).meta["fell"]


def test_an_edge_that_turns_the_sole_before_the_other_foot_lands_foresees_no_fall():
    trace = walk("step:-2,1.52", 9.0)
    assert not trace.meta["fell"] and trace.meta["alarm_time"] is None


@pytest.mark.parametrize("terrain", ["soft:0.02", "waves:2"])
def test_soft_and_wavy_ground_is_walked(terrain):
    assert not walk(terrain).meta["fell"]


def test_the_com_follows_the_ground():
    up, flat = walk("step:2,1.05", 9.0), walk("flat", 9.0)
    assert up.com[-800:, 2].mean() - flat.com[-800:, 2].mean() == pytest.approx(0.02, abs=1e-3)


def test_flat_ground_is_not_felt_to_be_uneven():
    assert not walk("flat").uneven.any()
    assert not zmpwalk.simulate(profile=0.25, duration=6.0).uneven.any()


def test_ground_that_stays_level_counts_as_even_again():
    trace = walk("step:-1,1.2", 16.0)
    assert trace.uneven.any() and not trace.uneven[-1000:].any()


def test_by_time_alone_the_same_slope_is_not_walked():
    assert walk("slope:5", settings={"touch_down": "time"}).meta["fell"]


@pytest.mark.parametrize(("robot", "speed"), [("robotis_op3", 0.086), ("unitree_g1", 0.141)])
def test_strangers_walk_a_slope_and_blocks_that_their_feet_find(robot, speed, test_robots):
    path = test_robots / robot / "robot.json"
    blocks = {"robotis_op3": "blocks:0.5,0", "unitree_g1": "blocks:1.3,0"}[robot]  # 2 % of the COM's height
    profile = zmpwalk.VelocityProfile.ramp(0.0, speed, 2.0)
    runs = [
        {"robot": path, "profile": profile, "duration": 12.0, "terrain": terrain}
        for terrain in ("slope:3,0", "slope:3,180", blocks)
    ]
    traces = zmpwalk.simulate_batch(runs)
    assert [trace.meta["terrain"] for trace in traces if trace.meta["fell"]] == []
    assert all(trace.uneven.any() for trace in traces)
