"""The walk as a Gymnasium environment: it keeps Gymnasium's rules, and its numbers are those of the walk."""

import ctypes
import gc
import math
import os
import resource
import threading
import warnings

import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError

gymnasium = pytest.importorskip("gymnasium", minversion="1.0")
gym = pytest.importorskip("zmpwalk.gym")


@pytest.fixture(scope="module", params=["velocity", "torque"])
def env(request):
    env = gymnasium.make(gym.ID, action=request.param, duration=1.0, velocity=0.2)
    yield env
    env.close()


def test_it_passes_gymnasiums_checker(env):
    from gymnasium.utils.env_checker import check_env

    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", ".*Box observation space.*infinity.*")  # joint speeds have no largest value
        check_env(env.unwrapped, skip_render_check=True)


def test_an_episode_is_cut_off_after_its_duration(env):
    env.reset(seed=1)
    period = env.unwrapped.period
    action = np.zeros(env.action_space.shape, np.float32)
    for k in range(round(1.0 / period)):
        observation, reward, terminated, truncated, _ = env.step(action)
        assert observation in env.observation_space
        assert np.isfinite(observation).all()
        assert 0.0 <= reward <= 1.0
        assert (terminated, truncated) == (False, k == round(1.0 / period) - 1)


def test_equal_seeds_give_equal_episodes():
    def episode(seed):
        env = gym.Walk(pushes=(0.3, 0.1), duration=1.0)
        first, _ = env.reset(seed=seed)
        return np.array([first, *(env.step(env.velocity / env.reach)[0] for _ in range(10))])

    assert np.array_equal(episode(3), episode(3))
    assert not np.array_equal(episode(3), episode(4))


def test_a_velocity_action_is_the_command_of_the_walk():
    env = gym.Walk(velocity=0.25, duration=3.0)
    env.reset(seed=0)
    action = np.array([0.25, 0.0, 0.0]) / env.reach
    for _ in range(20):
        observation, *_ = env.step(action)
    trace = zmpwalk.simulate(profile=0.0, duration=2.001, command=lambda t, out: 0.25)
    assert np.array_equal(env._row["qpos"], trace.qpos[-1])
    assert observation[3:6] == pytest.approx([0.25, 0, 0])
    assert observation[6:9] == pytest.approx([0.25, 0, 0], abs=1e-6)  # planned by now
    assert observation[9:12] == pytest.approx([0, 0, -1], abs=0.02)  # it is upright


def test_no_torque_besides_is_the_walk_that_the_controller_walks_alone():
    env = gym.Walk(action="torque", velocity=0.2, duration=1.0)
    env.reset()
    for _ in range(50):
        env.step(np.zeros(25))
    trace = zmpwalk.simulate(profile=0.0, duration=1.001, command=lambda t, out: 0.2)
    assert np.array_equal(env._row["qpos"], trace.qpos[-1])


def test_a_torque_action_moves_the_robot():
    quiet, moved = gym.Walk(action="torque", velocity=0.0), gym.Walk(action="torque", velocity=0.0)
    for env, size in ((quiet, 0.0), (moved, 1.0)):
        env.reset(seed=0)
        for _ in range(10):
            observation, *_ = env.step(size * np.ones(25))
    elbow = 29 + quiet.controller.joint_names.index("l_elbow")
    assert quiet.reset(seed=0)[0][elbow] == pytest.approx(0.0, abs=1e-3)
    assert abs(observation[elbow]) > 1e-3


def test_a_fall_ends_the_episode():
    env = gym.Walk(velocity=0.0, pushes=(0.01, 3.0), duration=10.0)
    env.reset(seed=0)
    for _ in range(100):
        _, reward, terminated, truncated, info = env.step(np.zeros(3))
        if terminated:
            break
    assert terminated and not truncated
    assert reward == 0.0
    assert info["fall_cause"]


def test_the_reward_falls_with_the_distance_from_the_point():
    env = gym.Walk(velocity=0.25, duration=5.0)
    env.reset(seed=0)
    rewards = [env.step(np.zeros(3))[1] for _ in range(20)]  # it stands while the point goes on
    assert (np.diff(rewards) <= 0).all()
    assert rewards[-1] == pytest.approx(math.exp(-((2.0 * 0.25 / 0.2) ** 2)), rel=0.05)


def test_a_point_that_turns_goes_on_a_circle():
    pose = np.zeros(3)
    for _ in range(100):
        pose = gym.moved(pose, np.array([0.3, 0.0, 0.1]), math.pi / 0.1 / 100)
    assert pose == pytest.approx([0.0, 2 * 0.3 / 0.1, math.pi])


def test_walks_side_by_side_are_those_one_by_one():
    options = {"duration": 0.5, "pushes": (0.2, 0.1)}
    envs = gymnasium.make_vec(gym.ID, num_envs=3, **options)
    action = np.full((3, 3), 0.3, np.float32)
    together, _ = envs.reset(seed=5)
    alone = [gym.Walk(**options) for _ in range(3)]
    assert np.array_equal(together, [env.reset(seed=5 + i)[0] for i, env in enumerate(alone)])
    for k in range(5):
        together, rewards, fell, cut, _ = envs.step(action)
        one_by_one = [env.step(action[i]) for i, env in enumerate(alone)]
        assert np.array_equal(together, [found[0] for found in one_by_one])
        assert rewards.tolist() == [found[1] for found in one_by_one]
        assert cut.all() == (k == 4) and not fell.any()
    _, rewards, fell, cut, _ = envs.step(action)  # begins anew
    assert not rewards.any() and not fell.any() and not cut.any()
    envs.close()


def test_many_episodes_keep_no_memory():
    env = gym.Walk(duration=0.1)
    for i in range(150):
        if i == 50:
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        env.reset(seed=i)
        env.step(np.zeros(3))
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4096  # kB


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"action": "force"}, "action is 'force'; it must be velocity or torque"),
        ({"pushes": (0.0, 1.0)}, "seconds between them"),
        ({"render_mode": "human"}, "must be 'rgb_array' or None"),
    ],
)
def test_arguments_that_make_no_sense_are_refused(wrong, words):
    with pytest.raises(InputError, match=words):
        gym.Walk(**wrong)


def in_use():
    """Bytes that the C library has given out, to Python and to the extension alike."""

    class Given(ctypes.Structure):  # struct mallinfo2 of glibc
        _fields_ = [
            (name, ctypes.c_size_t)
            for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "a", "b", "uordblks", "c", "d")
        ]

    gc.collect()
    ask = ctypes.CDLL(None).mallinfo2
    ask.restype = Given
    given = ask()
    return given.uordblks + given.hblkhd


@pytest.mark.skipif(not os.environ.get("ZMPWALK_BIG"), reason="ZMPWALK_BIG is not set: 1000 episodes take minutes")
def test_a_thousand_episodes_keep_no_memory_and_no_thread():
    threads, env = threading.active_count(), gymnasium.make(gym.ID, duration=2.0, pushes=(1.0, 0.2))
    for i in range(1000):
        if i == 100:
            before = in_use()
        env.reset(seed=i)
        done = False
        while not done:
            *_, fell, cut, _ = env.step(env.action_space.sample())
            done = fell or cut
    assert in_use() - before < 100_000  # one column of one episode is as large
    env.close()
    assert threading.active_count() == threads
