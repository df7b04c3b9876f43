"""What the controller does not know, or not in time: options of the simulation, seeded, recorded, repeated."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, ModelError, Trace, Uncertainty, simulate

PROFILE = zmpwalk.VelocityProfile.ramp(0.0, 0.25, 1.25)


def walk(duration=1.0, **more):
    return simulate(profile=PROFILE, duration=duration, **more)


@pytest.fixture(scope="module")
def quiet():
    return walk()


def noise_of(trace, quiet):
    """What the first cycle measured, less the truth: the robot stands, and both walks start alike."""
    return trace.com[0] - quiet.com[0]


def test_knowing_everything_keeps_every_bit(quiet):
    assert walk(uncertainty=Uncertainty()) == quiet
    assert walk(uncertainty={"lag": 1e-12}) == quiet  # by the other way: numbers alone, and the torque through a drive


def test_another_model_that_is_the_same_keeps_every_bit(quiet):
    assert walk(simulated="mahru") == quiet


def test_equal_seeds_give_equal_noise_and_others_do_not():
    first, again, other = (walk(0.2, uncertainty={"noise": 1}, seed=seed) for seed in (3, 3, 4))
    assert first == again
    assert first != other


@pytest.mark.parametrize(
    "given",
    [
        {"noise": 1.0, "roll_bias": 0.01, "state_delay": 0.003, "torque_delay": 0.002, "lag": 0.004},
        {"mass": 1.1, "links": 0.1, "com": 0.01, "dry_friction": 1.0, "ground_friction": 0.5},
    ],
)
def test_a_rerun_repeats_it_bit_for_bit_from_a_file(given, tmp_path):
    trace = walk(uncertainty=given, seed=5, push=[(0.5, 0.1, None, (10, 5, 0))])
    again = Trace.load(trace.save(tmp_path / "walk.npz"))
    assert again.rerun() == trace
    assert {name: again.meta["uncertainty"][name] for name in given} == given


def test_measured_noise_has_the_deviations_it_says():
    """Encoders, by the feet that the controller believes in; speeds, by the COM's velocity of a robot that stands."""
    still, noisy = (simulate(profile=0.0, duration=3.0, uncertainty=u, seed=1) for u in (None, {"noise": 1.0}))
    settled = slice(500, None)
    assert noisy.dcom[settled].std(axis=0) == pytest.approx(0.03, rel=0.35)
    assert still.dcom[settled].std(axis=0).max() < 5e-3
    change = np.diff(noisy.dcom[settled, 0])
    assert np.corrcoef(change[1:], change[:-1])[0, 1] == pytest.approx(-0.5, abs=0.1)  # fresh in every cycle


def test_a_torque_delay_holds_the_state_of_so_many_steps_before(quiet):
    delayed = walk(0.05, uncertainty={"torque_delay": 0.004})
    np.testing.assert_array_equal(delayed.qpos[:2], quiet.qpos[:2])  # the first torque acts until the second is there
    assert not np.array_equal(delayed.qpos[5], quiet.qpos[5])


def test_a_delayed_state_is_that_of_so_many_steps_before():
    delayed = walk(0.3, uncertainty={"state_delay": 0.005})
    model, description = zmpwalk.load_robot("mahru")
    controller, data = zmpwalk.WalkingController(model, description), mujoco.MjData(model)
    for row in (40, 200):
        data.qpos[:], data.qvel[:] = delayed.qpos[row - 5], delayed.qvel[row - 5]
        controller.reset(data)
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(delayed.com[row], data.subtree_com[1], atol=1e-9)


def test_a_bias_tilts_what_is_measured_and_not_the_robot(quiet):
    biased = walk(0.002, uncertainty={"roll_bias": 0.1})
    np.testing.assert_array_equal(biased.qpos[0], quiet.qpos[0])
    height = quiet.com[0, 2] - quiet.qpos[0, 2]
    assert (biased.com - quiet.com[:2])[0, 1] == pytest.approx(-height * np.sin(0.1), abs=5e-3)


def test_masses_and_friction_change_only_the_simulated_robot():
    given = Uncertainty(mass=1.2, dry_friction=2.0, ground_friction=0.3, com=0.01)
    trace = walk(0.05, uncertainty=given)
    known, true = trace.model, trace.simulated_model
    np.testing.assert_allclose(true.body_mass[1:], 1.2 * known.body_mass[1:])
    np.testing.assert_allclose(true.dof_frictionloss[6:], known.dof_frictionloss[6:] + 2.0)
    np.testing.assert_allclose(true.geom_friction[:, 0], 0.3)
    assert 0.0 < np.abs(true.body_ipos - known.body_ipos).max() <= 0.01
    assert true.body_subtreemass[1] == pytest.approx(1.2 * known.body_subtreemass[1])
    forces = np.nansum(trace.contact_wrench[-1].reshape(2, 6)[:, 2])
    assert forces == pytest.approx(-1.2 * 9.81 * known.body_subtreemass[1], rel=0.1)


def test_links_are_changed_at_random_within_their_share():
    model, _ = zmpwalk.load_robot("mahru")
    changed = [Uncertainty(links=0.2).changed(model, 1, seed).body_mass[1:] / model.body_mass[1:] for seed in (0, 1)]
    assert all(0.8 <= share <= 1.2 for share in np.ravel(changed))
    assert not np.allclose(changed[0], changed[1])


def test_a_simulated_robot_that_does_not_fit_is_refused_by_content(mahru_edited):
    def rename(root):
        for joint in root.iter("joint"):
            if joint.get("name") == "l_elbow":
                joint.set("name", "left_elbow")
        for motor in root.iter("motor"):
            if motor.get("joint") == "l_elbow":
                motor.set("joint", "left_elbow")

    other = mujoco.MjModel.from_xml_string(mahru_edited.xml(rename))
    with pytest.raises(ModelError, match="l_elbow"):
        walk(0.1, simulated=other)
    waist_first = mujoco.MjModel.from_xml_string(mahru_edited.xml(mahru_edited.hang_pelvis_from_torso))
    assert waist_first.nv == zmpwalk.load_robot("mahru")[0].nv  # of equal size
    with pytest.raises(ModelError, match="order"):
        walk(0.1, simulated=waist_first)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"nose": 1}, "noise"),
        ({"noise": -1}, "at least 0"),
        ({"mass": 0}, "positive"),
        ({"lag": np.nan}, "finite"),
        ({"torque_delay": 2.0}, "at most 1 s"),
        ({"links": 1.0}, "less than all"),
        (3, "Uncertainty or a dict"),
    ],
)
def test_what_makes_no_sense_is_refused(given, words):
    with pytest.raises(InputError, match=words):
        walk(0.1, uncertainty=given)


def test_half_the_strength_is_half_way_to_knowing_everything():
    half = Uncertainty(noise=2.0, mass=1.2, links=0.2, ground_friction=0.2, lag=0.01).scaled(0.5)
    assert half == Uncertainty(noise=1.0, mass=1.1, links=0.1, ground_friction=0.6, lag=0.005)
    assert Uncertainty(noise=2.0, mass=0.8).scaled(0.0) == Uncertainty()
