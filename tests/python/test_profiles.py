"""Velocity profiles: what each constructor means, and which mistakes are named."""

import copy
import pickle

import numpy as np
import pytest
from zmpwalk import DimensionError, InputError, VelocityProfile


def forward(profile, *times):
    return [profile.velocity(t)[0] for t in times]


def test_paper_profile_is_that_of_section_iv():
    assert forward(VelocityProfile.paper(), 0.0, 0.79, 0.81, 1.7, 2.5, 100.0) == [
        0.063,
        0.063,
        0.156,
        0.219,
        0.25,
        0.25,
    ]


def test_constant_keeps_one_velocity_and_takes_one_or_three_numbers():
    assert VelocityProfile.constant(0.2).velocity(7.0).tolist() == [0.2, 0.0, 0.0]
    assert VelocityProfile.constant((0.1, -0.05, 0.3)).velocity(7.0).tolist() == [0.1, -0.05, 0.3]


def test_piecewise_holds_and_ramp_joins():
    steps = VelocityProfile.piecewise([(0, 0.1), (2, 0.3)])
    assert forward(steps, 1.999, 2.0) == [0.1, 0.3]
    assert forward(VelocityProfile.ramp(0.1, 0.3, 2.0), 1.0, 5.0) == pytest.approx([0.2, 0.3])


def test_displacement_is_the_integral_of_velocity():
    profile = VelocityProfile.paper()
    t = np.linspace(0.0, 4.0, 400001)
    midpoints = [profile.velocity(s)[0] for s in (t[1:] + t[:-1])[::100] / 2]
    assert profile.displacement(0.0, 4.0)[0] == pytest.approx(np.mean(midpoints) * 4.0, rel=1e-3)
    assert profile.displacement(0.0, 4.0)[0] == pytest.approx(0.8 * (0.063 + 0.156 + 0.219) + 1.6 * 0.25, abs=1e-12)


def test_from_function_passes_through_its_samples_and_ends_at_the_duration():
    profile = VelocityProfile.from_function(lambda t: (0.1 * t, 0.02, 0.0), duration=1.005, dt=0.01)
    assert profile.t[-1] == 1.005
    assert profile.velocity(0.355).tolist() == pytest.approx([0.0355, 0.02, 0.0])
    assert profile.velocity(9.0)[0] == pytest.approx(0.1005)


def test_csv_without_header_is_t_vx_vy_wz(tmp_path):
    file = tmp_path / "walk.csv"
    file.write_text("# a comment\n0, 0.1\n\n1.5, 0.2\n")
    assert VelocityProfile.from_csv(file) == VelocityProfile.piecewise([(0, 0.1), (1.5, 0.2)])


def test_csv_header_names_columns_in_any_order_and_case(tmp_path):
    file = tmp_path / "walk.csv"
    file.write_text("\ufeffwz,T,vx\n0.3,0,0.1\n0.4,1,0.2\n", encoding="utf-8")
    profile = VelocityProfile.from_csv(file, "linear")
    assert profile.velocity(0.5).tolist() == pytest.approx([0.15, 0.0, 0.35])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("t,vx\n0,0.1\n1,\n", ["line 3", "vx is empty"]),
        ("0,0.1\n1\n", ["line 2", "1 values", "2 columns"]),
        ("0,0.1\n1,fast\n", ["line 2", "'fast'", "must be a number"]),
        ("0,0.1\n1,nan\n", ["line 2", "nan", "must be finite"]),
        ("0,0.1\n1,inf\n", ["line 2", "inf", "must be finite"]),
        ("0,0.1\n1,0.2\n1,0.3\n", ["line 3", "t is 1 after 1", "must increase"]),
        ("0.5,0.1\n", ["line 1", "t is 0.5", "must be 0"]),
        ("t,speed\n0,0.1\n", ["line 1", "no column 'vx'"]),
        ("t,vx,height\n0,0.1,1\n", ["line 1", "'height'"]),
        ("0\n1\n", ["1 columns"]),
        ("\n\n", ["no rows"]),
    ],
)
def test_csv_mistakes_name_file_line_value_and_rule(tmp_path, text, words):
    file = tmp_path / "bad.csv"
    file.write_text(text)
    with pytest.raises(InputError) as caught:
        VelocityProfile.from_csv(file)
    message = str(caught.value)
    assert "bad.csv" in message
    assert "\n" not in message
    for word in words:
        assert word in message


def test_csv_that_is_missing_or_not_text_is_named(tmp_path):
    with pytest.raises(InputError, match=r"nowhere\.csv: no such file"):
        VelocityProfile.from_csv(tmp_path / "nowhere.csv")
    (tmp_path / "picture.csv").write_bytes(b"\x89PNG\xff\x00")
    with pytest.raises(InputError, match=r"picture\.csv: not a CSV"):
        VelocityProfile.from_csv(tmp_path / "picture.csv")


def test_spec_reads_what_the_command_line_takes(tmp_path):
    (tmp_path / "walk.csv").write_text("0,0.1\n")
    assert VelocityProfile.from_spec("paper") == VelocityProfile.paper()
    assert VelocityProfile.from_spec("0.2") == VelocityProfile.constant(0.2)
    assert VelocityProfile.from_spec("0:0.063, 0.8:0.156") == VelocityProfile.piecewise([(0, 0.063), (0.8, 0.156)])
    assert VelocityProfile.from_spec("0:0.1/0.02/0.3") == VelocityProfile.constant((0.1, 0.02, 0.3))
    assert VelocityProfile.from_spec("0.1/0.02/0.3") == VelocityProfile.constant((0.1, 0.02, 0.3))
    assert VelocityProfile.from_spec(str(tmp_path / "walk.csv")) == VelocityProfile.constant(0.1)
    (tmp_path / "ramp.csv").write_text("t,vx,wz\n0,0,0\n2,0.2,0.1\n")
    ramp = VelocityProfile.from_spec(f"{tmp_path / 'ramp.csv'}:linear")
    assert ramp.velocity(1.0) == pytest.approx((0.1, 0.0, 0.05))
    assert VelocityProfile.from_spec(f"{tmp_path / 'ramp.csv'}:hold").velocity(1.0) == pytest.approx((0, 0, 0))


@pytest.mark.parametrize(
    "spec", ["", "fast", "0:", "0.1,0.2", "0:0.1/0.2", "0:0.1,0:0.2", "1:0.1", "0:nan", "no.csv", ":linear"]
)
def test_spec_mistakes_are_one_clear_line(spec):
    with pytest.raises(InputError) as caught:
        VelocityProfile.from_spec(spec)
    assert "\n" not in str(caught.value)
    assert spec in str(caught.value)


@pytest.mark.parametrize(
    "make",
    [
        lambda: VelocityProfile.constant(float("nan")),
        lambda: VelocityProfile.constant(float("inf")),
        lambda: VelocityProfile.constant("fast"),
        lambda: VelocityProfile.piecewise([]),
        lambda: VelocityProfile.piecewise([(0, 0.1), (1, 0.2), (0.5, 0.3)]),
        lambda: VelocityProfile.piecewise([(0.1, 0.1)]),
        lambda: VelocityProfile.ramp(0.1, 0.2, 0.0),
        lambda: VelocityProfile.ramp(0.1, 0.2, float("nan")),
        lambda: VelocityProfile.from_function(lambda t: 1 / (t - 1) if t != 1 else float("inf"), 2.0),
        lambda: VelocityProfile.from_function(lambda t: 0.1, 2.0, dt=-1),
        lambda: VelocityProfile([0.0], [[0.1, 0, 0]], "cubic"),
        lambda: VelocityProfile.from_dict({"t": [0]}),
    ],
)
def test_values_that_cannot_be_raise_input_error(make):
    with pytest.raises(InputError):
        make()


@pytest.mark.parametrize("v", [(0.1, 0.2), (1, 2, 3, 4), [[0.1, 0.2, 0.3]]])
def test_velocity_of_another_shape_raises_dimension_error(v):
    with pytest.raises(DimensionError, match="vx or"):
        VelocityProfile.constant(v)


def test_profile_survives_dict_pickle_and_copy():
    profile = VelocityProfile.ramp((0.1, 0.0, 0.2), 0.3, 2.0)
    for other in (
        VelocityProfile.from_dict(profile.to_dict()),
        pickle.loads(pickle.dumps(profile)),
        copy.deepcopy(profile),
    ):
        assert type(other) is VelocityProfile
        assert other == profile
    assert profile != VelocityProfile.ramp((0.1, 0.0, 0.2), 0.3, 2.5)


def test_repr_tells_times_and_speeds():
    assert "0.8: 0.156" in repr(VelocityProfile.paper())
    assert len(repr(VelocityProfile.from_function(lambda t: 0.1, 100.0))) < 200
