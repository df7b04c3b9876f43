"""Terrains: the ground is where it says, the robot walks on it, and a trace remembers it."""

import math

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, ModelError, Patch, Terrain

GEOM = mujoco.mjtObj.mjOBJ_GEOM
WORDS = ["flat", "soft:0.02", "slope:5", "slope:-5,45", "slope:10,90", "blocks:2,3", "plates:3", "step:-2,1.3"]
WORDS += ["stairs:12x28", "waves:3"]


def top(model, x, y):
    """Height at which a ray from above meets the scene without the robot."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    robot = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, "pelvis")
    geom = np.zeros(1, np.int32)
    start = np.array([x, y, 30.0])
    for _ in range(100):
        way = mujoco.mj_ray(model, data, start, np.array([0.0, 0.0, -1.0]), None, 1, robot, geom)
        if geom[0] < 0 or model.geom_bodyid[geom[0]] == 0:
            break
        start[2] -= way + 1e-9
    return start[2] - way


@pytest.mark.parametrize("text", WORDS)
def test_the_ground_is_where_the_terrain_says(text):
    terrain = Terrain.of(text)
    model = terrain.model("mahru")
    rng = np.random.default_rng(1)
    for x, y in zip(rng.uniform(1.6, 7.0, 20), rng.uniform(-0.7, 0.7, 20)):
        rise = max((abs(r) for p in terrain.patches for r in p.rise), default=0.0)
        near = [terrain.height(x + dx, y + dy) for dx in (-0.01, 0, 0.01) for dy in (-0.01, 0, 0.01)]
        if max(near) - min(near) > 0.03 * rise + 1e-9:
            continue  # at an edge
        assert top(model, x, y) == pytest.approx(terrain.height(x, y), abs=1e-4 + 5e-3 * rise**2)


@pytest.mark.parametrize("text", WORDS)
def test_the_robot_starts_on_the_floor(text):
    terrain = Terrain.of(text)
    assert {terrain.height(x, y) for x in (-0.5, 0.0, 0.4) for y in (-0.3, 0.0, 0.3)} == {0.0}
    assert zmpwalk.simulate(profile=0.0, duration=0.05, terrain=text).meta["fell"] is False


def test_a_slope_rises_towards_its_azimuth():
    rise = math.tan(math.radians(5))
    for azimuth in range(0, 360, 45):
        terrain, far = Terrain.slope(5, azimuth), np.array([4.0, 0.7])
        toward = np.array([math.cos(math.radians(azimuth)), math.sin(math.radians(azimuth))])
        for d in (np.array([0.1, 0.0]), np.array([0.0, 0.1])):
            assert terrain.height(*(far + d)) - terrain.height(*far) == pytest.approx(rise * toward @ d, abs=1e-12)
    assert Terrain.slope(5, 90).height(6.0, 0.0) == pytest.approx(0.0, abs=1e-12)  # it leans about the line walked


def test_blocks_are_seeded_and_within_their_height():
    heights = [p.height for p in Terrain.blocks(2, 3).patches]
    assert (
        heights == [p.height for p in Terrain.blocks(2, 3).patches] != [p.height for p in Terrain.blocks(2, 4).patches]
    )
    assert min(heights) >= 0.0 and 0.019 < max(heights) <= 0.02


def test_stairs_go_up_and_down_again():
    terrain = Terrain.stairs(12, 28)
    assert terrain.height(0.5 + 9 * 0.28 + 0.1, 0.0) == pytest.approx(1.2)
    assert terrain.height(0.5 + 9 * 0.28 + 1.0 + 0.1, 0.0) == pytest.approx(1.08)
    assert terrain.height(12.0, 0.0) == 0.0


def test_the_ground_touches_as_the_floor_does():
    flat, soft = (Terrain.of(text).model("mahru") for text in ("flat", "soft:0.03"))
    own, _ = zmpwalk.load_robot("mahru")
    floor, box = mujoco.mj_name2id(own, GEOM, "floor"), mujoco.mj_name2id(flat, GEOM, "terrain_0")
    for name in ("geom_friction", "geom_solref", "geom_solimp", "geom_contype", "geom_conaffinity"):
        assert np.array_equal(getattr(flat, name)[box], getattr(own, name)[floor])
    assert soft.geom_solref[box, 0] == 0.03
    assert flat.opt.timestep == own.opt.timestep and np.array_equal(flat.body_mass, own.body_mass)


def test_a_patch_has_the_axes_of_its_plane():
    patch = Patch((0.0, 1.0), (0.0, 1.0), 0.1, (0.2, -0.3))
    assert patch.axes.T @ patch.axes == pytest.approx(np.eye(3))
    along, _, normal = patch.axes.T
    assert along[2] / along[0] == pytest.approx(0.2) and normal @ [0.0, 1.0, -0.3] == pytest.approx(0.0)


def test_a_flat_terrain_is_walked_as_the_floor_is():
    on_floor = zmpwalk.simulate(profile=0.25, duration=3.0)
    on_box = zmpwalk.simulate(profile=0.25, duration=3.0, terrain="flat")
    assert np.abs(on_floor.com - on_box.com).max() < 1e-3
    assert on_floor.meta["terrain"] is None and on_box.meta["terrain"] == "flat"


def test_a_trace_remembers_its_terrain_and_walks_on_it_again(tmp_path):
    trace = zmpwalk.simulate(profile=0.25, duration=1.5, terrain="step:-1,0.6")
    again = zmpwalk.Trace.load(trace.save(tmp_path / "walk.npz")).rerun()
    assert again.meta["terrain"] == "step:-1,0.6"
    assert np.array_equal(again.com, trace.com)


def test_a_trace_keeps_a_ground_that_has_no_words(tmp_path):
    mine = Terrain("mine", [Patch((-3.0, 0.6), (-5.0, 5.0)), Patch((0.6, 9.0), (-5.0, 5.0), -0.01)])
    trace = zmpwalk.simulate(profile=0.25, duration=1.5, terrain=mine)
    loaded = zmpwalk.Trace.load(trace.save(tmp_path / "walk.npz"))
    assert loaded.meta["terrain"] == "mine" and np.array_equal(loaded.rerun().com, trace.com)
    # Another MuJoCo compiles it from the files that the trace keeps.
    for name in ("geom_pos", "geom_size", "geom_friction", "body_mass"):
        assert np.array_equal(getattr(loaded._source.compiled(), name), getattr(trace.model, name))


def test_a_trace_keeps_the_ground_under_another_robot_than_the_known_one():
    trace = zmpwalk.simulate(profile=0.25, duration=1.0, terrain="step:-1,0.6", simulated="mahru")
    assert np.array_equal(trace.rerun().com, trace.com)
    assert trace._simulated_source.compiled().ngeom == trace.simulated_model.ngeom == trace.model.ngeom


def test_a_batch_walks_each_on_its_own_ground():
    walks = zmpwalk.simulate_batch(
        [{"duration": 0.1, "profile": 0.0, "terrain": t} for t in (None, "flat", "blocks:1")]
    )
    assert [walk.meta["terrain"] for walk in walks] == [None, "flat", "blocks:1,0"]
    assert len({walk.model.ngeom for walk in walks}) == 2 + (walks[0].model.ngeom != walks[1].model.ngeom)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("hill", "unknown"),
        ("slope", "slope:DEG"),
        ("slope:steep", "slope:DEG"),
        ("slope:70", "less than 60"),
        ("blocks:2,x", "blocks:CM"),
        ("blocks:2,-1", "seeded"),
        ("stairs:12", "stairs:RISExTREAD"),
        ("waves:nan", "waves"),
    ],
)
def test_a_terrain_that_is_none_is_refused(text, says):
    with pytest.raises(InputError, match=says):
        Terrain.of(text)


def test_a_robot_without_a_file_or_floor_has_no_terrain(tmp_path):
    with pytest.raises(InputError, match="not a model"):
        zmpwalk.simulate(zmpwalk.load_robot("mahru"), terrain="flat")
    with pytest.raises(InputError, match="brings its own"):
        zmpwalk.simulate(terrain="flat", source="<mujoco/>")
    bare = tmp_path / "bare.xml"
    bare.write_text("<mujoco><worldbody><body/></worldbody></mujoco>")
    with pytest.raises(ModelError, match="no floor"):
        Terrain.flat().model(bare)
