"""Pictures off screen, in both MuJoCo versions; skipped where there is no OpenGL at all."""

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import Error, InputError, render


@pytest.fixture(scope="module")
def standing():
    model, description = zmpwalk.load_robot("mahru")
    data = mujoco.MjData(model)
    description.place(model, data)
    try:
        render.picture(model, data, 32, 24)
    except Error as error:
        pytest.skip(str(error))
    return model, data


def test_picture_shows_the_robot_upright(standing):
    model, data = standing
    image = render.picture(model, data, 160, 120)
    assert image.shape == (120, 160, 3)
    assert image.dtype == np.uint8
    without = mujoco.MjData(model)
    without.qpos[:] = data.qpos
    without.qpos[0] += 100.0
    mujoco.mj_forward(model, without)
    view = {"lookat": data.subtree_com[1], "distance": 2.6}
    changed = render.picture(model, data, 160, 120, view) != render.picture(model, without, 160, 120, view)
    rows, columns = np.nonzero(changed.any(axis=-1))
    assert 60 < np.ptp(rows) < 119  # it fills the picture's height, and stays inside
    assert np.ptp(columns) < np.ptp(rows)  # taller than wide, shadow and all
    assert abs(columns.mean() - 80) < 15


def test_picture_does_not_change_the_model(standing):
    model, data = standing
    before = model.vis.global_.offwidth, model.vis.global_.offheight, data.qpos.copy()
    assert render.picture(model, data, 2000, 30).shape == (30, 2000, 3)
    assert before[:2] == (model.vis.global_.offwidth, model.vis.global_.offheight)
    assert np.array_equal(before[2], data.qpos)


def test_camera_by_name_and_by_angles(standing):
    model, data = standing
    named, angled = (render.picture(model, data, 80, 60, camera) for camera in ("side", {"azimuth": 0}))
    assert (named != angled).any()
    with pytest.raises(InputError, match=r"no camera 'front'; the model has .*side"):
        render.picture(model, data, 80, 60, "front")
    with pytest.raises(InputError, match="no 'zoom'"):
        render.picture(model, data, 80, 60, {"zoom": 2})
    with pytest.raises(InputError, match="0 x 60"):
        render.picture(model, data, 0, 60)


def test_snapshot_shows_the_instant_with_its_zmp(standing, walked):
    images = [render.snapshot(walked, t, 320, 240, show_zmp=False) for t in (0.0, 0.5)]
    assert (images[0] != images[1]).any()
    marked = render.snapshot(walked, 0.5, 320, 240)
    red = (marked[..., 0] > 1.5 * marked[..., 2]) & (images[1] != marked).any(axis=-1)
    assert red.sum() > 5
    with pytest.raises(InputError, match="t is 2 s"):
        render.snapshot(walked, 2.0)


def test_video_is_written_whole_or_not_at_all(standing, walked, tmp_path, monkeypatch):
    pytest.importorskip("imageio")
    path = render.video(walked, tmp_path / "walk.gif", fps=5, width=64, height=48)
    assert path.read_bytes().startswith(b"GIF")

    def broken(*arguments, **options):
        raise RuntimeError("broken")

    monkeypatch.setattr(render.OffScreen, "draw", broken)
    with pytest.raises(RuntimeError, match="broken"):
        render.video(walked, tmp_path / "other.gif", width=64, height=48)
    assert [file.name for file in tmp_path.iterdir()] == ["walk.gif"]


def test_no_backend_says_what_was_tried_and_what_to_install(standing, monkeypatch):
    monkeypatch.delenv("MUJOCO_GL", raising=False)
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setattr(render.ctypes.util, "find_library", lambda name: None)
    with pytest.raises(Error, match=r"egl: no libEGL; osmesa: no libOSMesa\): install"):
        render.picture(*standing)


def test_caption_tells_the_walked_velocity_and_leaves_the_rest_of_the_picture(standing, made_up_trace, made_up_columns):
    words = render._caption(made_up_trace, 7999)
    assert words["made-up"] == "8.00 s"
    assert words["asked"] == "forward +0.25 m/s   left +0.00 m/s   turning +0.00 rad/s"
    walked = float(words["walks"].split()[1])
    assert walked == pytest.approx(0.25, abs=0.03)
    assert render._caption(made_up_trace, 0)["walks"].startswith("forward +0.00")
    model, data = standing
    with render.OffScreen(model, 320, 240) as screen:
        plain, captioned = (screen.draw(data, words=words) for words in (None, {"mahru": "1.00 s"}))
    rows, columns = np.nonzero((plain != captioned).any(axis=-1))
    assert len(rows) and rows.max() < 60 and columns.max() < 200


def test_film_s_camera_goes_with_the_walk_and_not_with_its_sway(made_up_trace):
    path = render._smooth_path(made_up_trace)
    com = made_up_trace.com
    assert path.shape == com.shape
    assert np.ptp(path[2000:-2000, 1]) < 0.2 * np.ptp(com[2000:-2000, 1])
    assert path[2000:-2000, 0] == pytest.approx(com[2000:-2000, 0], abs=0.02)


def test_film_shows_an_arrow_while_a_push_acts_and_a_quarter_of_a_second_at_least(standing, walked):
    model, data = standing
    pushed = zmpwalk.Trace(dict(walked), {**walked.meta, "push": [[0.2, 0.08, "torso", [0.0, 200.0, 0.0]]]})
    shown = [len(render._arrows(model, data, pushed, t)) for t in (0.1, 0.2, 0.44, 0.46)]
    assert shown == [0, 1, 1, 0]
    (arrow,) = render._arrows(model, data, pushed, 0.3)
    torso = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, "torso")
    assert arrow["to"] == pytest.approx(data.xipos[torso])
    assert arrow["along"][1] > 0.1
    assert arrow["along"][[0, 2]] == pytest.approx([0, 0])
    with render.OffScreen(model, 160, 120) as screen:
        with_arrow, without = (screen.draw(data, arrows=arrows) for arrows in ([arrow], []))
    assert (with_arrow != without).any()
