# ruff: noqa: E501, RUF012  (corpora and tokens in one line)
"""Feeds every door of zmpwalk hostile inputs: `python benchmarks/fuzz.py`, or `make fuzz`.

A door is a file or a call through which something comes in. Each has a small corpus of its own, which is changed by a
grammar: numbers become huge, negative, not-a-number or words, keys and elements go, come twice or change places, types
change, bytes flip. An input is

- accepted: then what came of it is finite, in range and goes through a round trip, and a share of them walks 0.1 s;
- or refused, with one line that zmpwalk wrote.

Everything else is a finding, with an id such as `npz:17`: a crash, a hang over 2 s, a traceback, more than 1 GB, a
wrong result. `--only npz:17` with the same seed tries that one alone and shows it.

Inputs are tried in processes forked for it, each of which goes on until it dies.
"""

from __future__ import annotations

import argparse
import contextlib
import copy
import io
import json
import math
import os
import random
import re
import resource
import select
import shutil
import signal
import struct
import sys
import tempfile
import time
import traceback
import warnings
import zipfile
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import zmpwalk
from zmpwalk import (
    JointMotion,
    State,
    Terrain,
    Trace,
    Uncertainty,
    VelocityProfile,
    WalkingController,
    WalkSettings,
    cli,
)
from zmpwalk.disturbances import pushes_of
from zmpwalk.profiles import profile_of
from zmpwalk.robots import description_from_dict, description_to_dict, examine, read_description, robot_file
from zmpwalk.settings import load_settings, settings_toml
from zmpwalk.simulation import run

HANGS = 2.0  # of processor time in one input [s]
DEAF = 40.0  # of wall time in one input, on a busy machine [s]
MEMORY = 1_000_000_000  # that an input may take beyond what there is [bytes]
LONGEST_LINE = 2000  # of a refusal [characters]
WALKS = 0.05  # share of the accepted inputs that walk
BATCH = 500  # inputs in a process


class Wrong(AssertionError):
    """An input was accepted, and what came of it is wrong."""


def require(good: Any, what: str) -> None:
    if not good:
        raise Wrong(what)


# --- generators

NUMBERS: list[Any] = [
    0, -0.0, 1, -1, 2, 1e-300, 1e-12, 1e9, -1e9, 1e13, 1e155, 1e300, 1e308, -1e308, math.nan, math.inf, -math.inf,
    10**25, 2**31, -(2**31) - 1, 2**63, 0.1, 0.5, 5, 100, 1e4, 5e-324,
]  # fmt: skip
WORDS = ["", " ", "nan", "inf", "-inf", "1e400", "true", "null", "0x10", "1,5", "1_000", "٣", "é", "\u200b", "a" * 300,
         "../../x", "/dev/zero", "l_knee", "root", "left", "0/0", "--help", "%s%n", "\x00", "\n", ";", ":", "'", '"', "[", "{"]  # fmt: skip


def odd_number(chance: random.Random, like: float = 1.0) -> Any:
    kind = chance.random()
    if kind < 0.4:
        return chance.choice(NUMBERS)
    if kind < 0.8:
        return like * chance.choice([-1, 0.5, 0.9, 1.1, 2, 10, 1000, 1e-3, chance.uniform(-3, 3)])
    return chance.gauss(0, 10.0 ** chance.randint(-3, 3))


def odd_value(chance: random.Random, like: Any = None) -> Any:
    """Something in place of a value: seldom of another kind."""
    if isinstance(like, (int, float)) and not isinstance(like, bool) and abs(like) < 1e300 and chance.random() < 0.75:
        return odd_number(chance, float(like))
    if isinstance(like, str) and chance.random() < 0.5:
        return odd_text(chance, like)
    return chance.choice(
        [
            None, True, False, "", chance.choice(WORDS), odd_number(chance), [], {}, [odd_number(chance)] * 3,
            {"a": odd_number(chance)}, [[]], 10**400,
        ]
    )  # fmt: skip


def odd_text(chance: random.Random, text: str, tokens: list[str] | None = None) -> str:
    """A text of which parts went, came twice, changed places or became other tokens."""
    for _ in range(chance.choice([1, 1, 1, 2, 5])):
        if not text:
            return chance.choice(WORDS)
        i, j = sorted(chance.randrange(len(text) + 1) for _ in range(2))
        j = min(j, i + chance.choice([1, 3, 20]))
        kind = chance.random()
        if kind < 0.2:
            text = text[:i] + text[j:]
        elif kind < 0.35:
            text = text[:j] + text[i:j] + text[j:]
        elif kind < 0.5:
            text = text[:i] + chance.choice(tokens or WORDS) + text[j:]
        else:  # one of its numbers
            found = list(re.finditer(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?", text))
            if not found:
                continue
            spot = chance.choice(found)
            other = odd_number(chance, min(float(spot.group()), 1e300))
            text = (
                text[: spot.start()]
                + (f"{other!r}" if chance.random() < 0.9 else chance.choice(WORDS))
                + text[spot.end() :]
            )
    return text


def odd_tree(chance: random.Random, plain: Any) -> Any:
    """A tree of dictionaries and lists in which some places have changed."""
    plain = copy.deepcopy(plain)
    for _ in range(chance.choice([1, 1, 1, 2, 3, 8])):
        places: list[tuple[Any, Any]] = []

        def look(node: Any, places: list[tuple[Any, Any]] = places) -> None:
            for key in list(node) if isinstance(node, dict) else range(len(node)):
                places.append((node, key))
                if isinstance(node[key], (dict, list)):
                    look(node[key])

        look(plain)
        if not places:
            return plain
        node, key = chance.choice(places)
        kind = chance.random()
        if kind < 0.15:
            del node[key]
        elif kind < 0.25 and isinstance(node, dict):
            node[chance.choice([*WORDS, *node])] = node[key]
        elif kind < 0.35:
            other, there = chance.choice(places)
            if not (
                isinstance(node[key], (dict, list))
                or isinstance(other.get(there) if isinstance(other, dict) else None, (dict, list))
            ):
                with contextlib.suppress(IndexError, KeyError):
                    node[key], other[there] = other[there], node[key]
        else:
            node[key] = odd_value(chance, node[key])
    return plain


def odd_bytes(chance: random.Random, raw: bytes) -> bytes:
    out = bytearray(raw)
    for _ in range(chance.choice([1, 2, 10])):
        if not out:
            break
        i = chance.randrange(len(out))
        kind = chance.random()
        if kind < 0.5:
            out[i] = chance.randrange(256)
        elif kind < 0.7:
            del out[i : i + chance.choice([1, 8, 1000])]
        elif kind < 0.9:
            out[i:i] = bytes(chance.randrange(256) for _ in range(chance.choice([1, 4, 8])))
        else:
            del out[i:]
    return bytes(out)


def as_bytes(chance: random.Random, text: str, spoiled: float = 0.0) -> bytes:
    """The text as a file holds it, `spoiled` that often by odd bytes."""
    raw = text.encode("utf-8", "surrogatepass")
    return odd_bytes(chance, raw) if chance.random() < spoiled else raw


# --- what inputs are made from, and are tried on

MODEL: Any
DESCRIPTION: Any
TRACE: Path  # a short walk
PLACE: Path  # where inputs are written


def prepare(place: Path) -> None:
    global MODEL, DESCRIPTION, TRACE, PLACE
    PLACE = place
    MODEL, DESCRIPTION = zmpwalk.load_robot("mahru")
    TRACE = zmpwalk.simulate(profile=0.1, duration=0.03).save(place / "trace.npz")


def walk(controller: WalkingController) -> None:
    trace = run(controller, 0.1)
    require(np.isfinite(trace.tau).all(), "a torque is not finite")
    require((np.abs(trace.tau) <= np.asarray(controller.torque_limit) * (1 + 1e-9)).all(), "a torque beyond its limit")
    trace.summary()


def seldom(chance: random.Random) -> bool:
    return chance.random() < WALKS


class Door:
    """Makes inputs, and tries them. `kinds` are errors that refuse, besides zmpwalk's own."""

    kinds: tuple[type, ...] = ()

    def make(self, chance: random.Random) -> Any:
        raise NotImplementedError

    def enter(self, given: Any, chance: random.Random) -> None:
        raise NotImplementedError

    def show(self, given: Any) -> str:
        return repr(given)


class RobotJson(Door):
    def make(self, chance: random.Random) -> Any:
        plain = {"model": str(robot_file("mahru")), **description_to_dict(DESCRIPTION)}
        kind = chance.random()
        if kind < 0.8:
            return json.dumps(odd_tree(chance, plain), ensure_ascii=chance.random() < 0.5, default=str)
        text = json.dumps(plain)
        return odd_text(chance, text) if kind < 0.95 else text[: chance.randrange(len(text))]

    def enter(self, given: str, chance: random.Random) -> None:
        path = PLACE / "robot.json"
        path.write_bytes(given.encode("utf-8", "surrogatepass"))
        description = read_description(path)
        again = description_to_dict(description)
        require(description_to_dict(description_from_dict(again)) == again, "no round trip")
        description.check(MODEL)
        if seldom(chance):
            walk(WalkingController(MODEL, description, profile=0.0))


ROUGH = (
    '<mujoco><compiler angle="radian" autolimits="true"/><option timestep="0.001" gravity="0 0 -9.81"/><worldbody>'
    '<geom name="floor" type="plane" size="0 0 1" pos="0 0 0"/><body name="trunk" pos="0 0 0.75"><freejoint name="root"/>'
    '<geom type="box" size="0.1 0.12 0.2" pos="0 0 0.15" mass="20"/>LEGS</body></worldbody><actuator>MOTORS</actuator></mujoco>'
)
LEG = [("hip_yaw", "0 0 1"), ("hip_roll", "1 0 0"), ("hip_pitch", "0 1 0"), ("knee", "0 1 0"), ("ankle_pitch", "0 1 0"), ("ankle_roll", "1 0 0")]  # fmt: skip


def rough_robot() -> str:
    """The smallest biped."""
    legs, motors = "", ""
    for side, y in (("l", 0.1), ("r", -0.1)):
        for i, (name, axis) in enumerate(LEG):
            pos = f"0 {y} -0.05" if i == 0 else "0 0 -0.3" if name in ("knee", "ankle_pitch") else "0 0 0"
            last = '<geom type="box" size="0.1 0.05 0.01" pos="0.03 0 -0.05" friction="1 0.005 0.0001"/>'
            geom = last if i == 5 else '<geom type="sphere" size="0.04" mass="1.5"/>'
            legs += f'<body name="{side}_{name}" pos="{pos}"><joint name="{side}_{name}" type="hinge" axis="{axis}" range="-2 2" armature="0.01" damping="0.1"/>{geom}'
            motors += f'<motor joint="{side}_{name}" ctrlrange="-200 200"/>'
        legs += "</body>" * len(LEG)
    return ROUGH.replace("LEGS", legs).replace("MOTORS", motors)


class Mjcf(Door):
    TOKENS = ["<body>", "</body>", "<joint/>", '<joint type="ball"/>', '<geom size="1"/>', '<site name="left_sole"/>',
              "<freejoint/>", "<keyframe><key qpos='0'/></keyframe>", '"', "<", "&", "<!--", '<include file="x.xml"/>',
              '<equality><weld body1="trunk"/></equality>', '<option gravity="0 0 0"/>', '<option integrator="RK4"/>']  # fmt: skip

    def make(self, chance: random.Random) -> str:
        text = rough_robot()
        for _ in range(chance.choice([1, 1, 2, 4])):
            kind = chance.random()
            if kind < 0.5:  # a value of an attribute
                found = list(re.finditer(r'(\w+)="([^"]*)"', text))
                if not found:
                    break
                spot = chance.choice(found)
                numbers = spot.group(2).split()
                k = chance.randrange(len(numbers)) if numbers else 0
                try:
                    other = odd_number(chance, float(numbers[k]))
                    numbers[k] = f"{other!r}" if not isinstance(other, float) or math.isfinite(other) else f"{other}"
                    value = " ".join(numbers)
                except (ValueError, IndexError):
                    value = chance.choice([*WORDS[:20], "box", "mesh", "slide", "ball", "hinge", "trunk", "l_knee"])
                    value = value.replace('"', "").replace("\x00", "")
                text = text[: spot.start(2)] + value + text[spot.end(2) :]
            elif kind < 0.7:  # an element
                found = list(re.finditer(r"<\w+ [^<>]*/>", text))
                if not found:
                    break
                spot = chance.choice(found)
                text = text[: spot.start()] + chance.choice(["", spot.group() * 2]) + text[spot.end() :]
            elif kind < 0.85:
                spot_at = chance.choice([m.end() for m in re.finditer(r">", text)] or [0])
                text = text[:spot_at] + chance.choice(self.TOKENS) + text[spot_at:]
            else:
                text = odd_text(chance, text, self.TOKENS)
        return text

    def enter(self, given: str, chance: random.Random) -> None:
        path = PLACE / "robot.xml"
        path.write_bytes(given.encode("utf-8", "surrogatepass"))
        model, proposal = examine(path)
        json.dumps(proposal.table, allow_nan=False)
        require(all("\n" not in remark for remark in proposal.remarks), "a remark of several lines")
        again = description_to_dict(proposal.description)
        require(description_to_dict(description_from_dict(again)) == again, "no round trip")
        if seldom(chance) and proposal.table["speed_limit_mps"] is not None:
            walk(WalkingController(model, proposal.description, profile=0.0))

    def show(self, given: str) -> str:
        return given


class Csv(Door):
    def make(self, chance: random.Random) -> bytes:
        rows = ["t,vx,vy,wz"] + [f"{k},{0.1 * k},0,{0.05 * k}" for k in range(4)]
        if chance.random() < 0.3:
            rows = [f"{k},{0.1 * k}" for k in range(3)]
        text = odd_text(
            chance, "\n".join(rows) + "\n", [",", ",,", "\n", "\r", '"', "t,vx", "#", ";", "nan", "-1", "1e99"]
        )
        return as_bytes(chance, text, spoiled=0.2)

    def enter(self, given: bytes, chance: random.Random) -> None:
        path = PLACE / "v.csv"
        path.write_bytes(given)
        check_profile(profile_of(path), chance)


def check_profile(profile: VelocityProfile, chance: random.Random) -> None:
    require(np.isfinite(profile.v).all() and np.isfinite(profile.t).all(), "not finite")
    require((np.diff(profile.t) > 0).all() and profile.t[0] == 0, "times do not increase from 0")
    require(VelocityProfile.from_dict(json.loads(json.dumps(profile.to_dict()))) == profile, "no round trip")
    repr(profile)
    for t in (0.0, 1.0, 1e3):
        require(np.isfinite(profile.velocity(t)).all(), "a velocity that is not finite")
        require(np.isfinite(profile.displacement(0.0, t)).all(), "a displacement that is not finite")
    if seldom(chance):
        walk(WalkingController(MODEL, DESCRIPTION, profile=profile))


class Motion(Door):
    def make(self, chance: random.Random) -> bytes:
        joints = chance.choice([["l_elbow"], ["l_elbow", "waist_yaw"], ["trunk_pitch", "r_elbow"], ["l_knee"]])
        rows = ["t," + ",".join(joints)]
        rows += [",".join([f"{k}"] + [f"{-0.1 * k}" for _ in joints]) for k in range(4)]
        text = odd_text(chance, "\n".join(rows) + "\n", [",", "\n", '"', "l_elbow", "root", "nan", "-1"])
        return as_bytes(chance, text)

    def enter(self, given: bytes, chance: random.Random) -> None:
        path = PLACE / "m.csv"
        path.write_bytes(given)
        motion = JointMotion.from_csv(path)
        require(np.isfinite(motion.q).all(), "not finite")
        require(JointMotion.from_dict(json.loads(json.dumps(motion.to_dict()))) == motion, "no round trip")
        repr(motion)
        controller = WalkingController(MODEL, DESCRIPTION, profile=0.0)
        controller.move(motion)
        if seldom(chance):
            walk(controller)


SETTINGS = WalkSettings.table()


class Toml(Door):
    def make(self, chance: random.Random) -> bytes:
        if not hasattr(self, "text"):
            self.text = settings_toml(WalkingController(MODEL, DESCRIPTION), WalkSettings())
        lines = [line for line in self.text.splitlines() if line and not line.startswith("#")]
        tables = [i for i, line in enumerate(lines) if line.startswith("[")]
        begin = chance.choice(tables)
        end = next((i for i in tables if i > begin), len(lines))
        part = "\n".join([lines[begin], *(line for line in lines[begin + 1 : end] if chance.random() < 0.5)]) + "\n"
        text = odd_text(
            chance, part, ["[", "]", "=", '"', "true", "{a=1}", "[1,2]", "1979-05-27", "# x", "law = 'paper'"]
        )
        return as_bytes(chance, text, spoiled=0.1)

    def enter(self, given: bytes, chance: random.Random) -> None:
        path = PLACE / "s.toml"
        path.write_bytes(given)
        check_settings(load_settings(path), chance)


def check_settings(made: WalkSettings, chance: random.Random) -> None:
    values = made.to_dict()
    again = WalkSettings(**values)
    require(again == made and repr(again.to_dict()) == repr(values), "no round trip")
    if chance.random() < 4 * WALKS:
        controller = WalkingController(MODEL, DESCRIPTION, made, 0.0)
        settings_toml(controller, made)
        if chance.random() < 0.5 and 1e-4 <= controller.settings.control_dt <= 0.05:
            walk(controller)


class Settings(Door):
    kinds = (TypeError,)

    def make(self, chance: random.Random) -> dict[str, Any]:
        given = {}
        for _ in range(chance.choice([1, 1, 2, 5])):
            row = SETTINGS[chance.choice(list(SETTINGS))]
            name = row.flat if chance.random() < 0.95 else odd_text(chance, row.flat)
            given[name] = odd_value(chance, row.default)
        return given

    def enter(self, given: dict[str, Any], chance: random.Random) -> None:
        check_settings(WalkSettings(**given), chance)


class Npz(Door):
    """Members of a trace that go, change their kind, their length or their bytes."""

    def make(self, chance: random.Random) -> bytes:
        if not hasattr(self, "members"):
            with zipfile.ZipFile(TRACE) as file:
                self.members = {name: file.read(name) for name in file.namelist()}
        members, out = dict(self.members), io.BytesIO()
        if chance.random() < 0.1:
            return odd_bytes(chance, TRACE.read_bytes())
        for _ in range(chance.choice([1, 1, 2, 4])):
            name = chance.choice(list(members))
            kind = chance.random()
            if name == "meta.json" or kind < 0.35:
                with contextlib.suppress(ValueError):
                    meta = odd_tree(chance, json.loads(members.get("meta.json", b"{}")))
                    members["meta.json"] = json.dumps(meta, default=str).encode("utf-8", "surrogatepass")
            elif kind < 0.45:
                del members[name]
            elif kind < 0.55:
                members[name] = odd_bytes(chance, members[name])
            elif kind < 0.6:
                members[chance.choice(["../x.npy", "a/b.npy", "t.npy", "x.npy", "model/x.xml"])] = members[name]
            elif name.endswith(".npy"):
                with contextlib.suppress(ValueError, EOFError, TypeError, OverflowError):
                    array = np.load(io.BytesIO(members[name]), allow_pickle=False)
                    members[name] = _npy(self._other(chance, array))
        with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as file:
            for name, raw in members.items():
                file.writestr(name, raw)
        return out.getvalue()

    @staticmethod
    def _other(chance: random.Random, array: np.ndarray) -> np.ndarray:
        kind = chance.randrange(8)
        if kind == 0:
            return array[: chance.randrange(len(array) + 1)] if array.ndim else array
        if kind == 1:
            return array.astype(chance.choice(["i1", "f4", "U5", "S3", "?", "c16", "u8", ">f8"]))
        if kind == 2:
            return array.reshape(-1)
        if kind == 3:
            return np.full_like(array, odd_number(chance))
        if kind == 4:
            return np.zeros(chance.choice([0, 1, (0, 3), (2, 2, 2), 1000]))
        if kind == 5:
            return np.concatenate([array, array]) if array.ndim else array
        if kind == 6:
            return np.zeros(2, [("a", float), ("b", "S2")])
        out = array.astype(float)
        if out.size:
            out.flat[chance.randrange(out.size)] = float(odd_number(chance))
        return out

    def enter(self, given: bytes, chance: random.Random) -> None:
        path = PLACE / "in.npz"
        path.write_bytes(given)
        trace = Trace.load(path)
        saved = Trace.load(trace.save(PLACE / "again.npz"))
        require(set(saved) == set(trace), "no round trip")
        require(all(np.array_equal(saved[name], trace[name], equal_nan=True) for name in trace), "no round trip")
        repr(trace)
        for use in (trace.flat, trace.summary, lambda: trace.profile, lambda: trace.settings, lambda: trace.fall,
                    lambda: trace.description, trace._repr_html_ if seldom(chance) else trace.flat):  # fmt: skip
            try:
                use()
            except zmpwalk.Error as error:
                one_line(str(error))
            except AttributeError as error:  # a column that is not there
                require("nearest" in str(error) or "no '" in str(error) or "has no" in str(error), f"unclear: {error}")
        with contextlib.suppress(zmpwalk.Error):
            json.dumps(trace.summary(), allow_nan=False)

    def show(self, given: bytes) -> str:
        shown = [f"{len(given)} bytes"]
        with contextlib.suppress(Exception), zipfile.ZipFile(io.BytesIO(given)) as file:
            for name in file.namelist():
                with contextlib.suppress(Exception):
                    if file.read(name) != getattr(self, "members", {}).get(name):
                        shown.append(f"{name}: {file.read(name)[:300]!r}")
        return "\n".join(shown)


def _npy(array: np.ndarray) -> bytes:
    out = io.BytesIO()
    np.lib.format.write_array(out, array, allow_pickle=False)
    return out.getvalue()


class Profile(Door):
    def make(self, chance: random.Random) -> Any:
        kind = chance.random()
        if kind < 0.4:
            tokens = [",", ":", "/", "0:0", "paper", "1:0.1/0/0.2", " ", "x.csv"]
            return odd_text(
                chance, chance.choice(["0:0.1,5:0.2/0/0.3", "0.2", "0:0,1:0.1,2:0.1/0.05/0.1", "paper"]), tokens
            )
        if kind < 0.8:
            return odd_tree(
                chance, chance.choice([[[0, 0.1], [1, [0.1, 0, 0.2]], [3, 0.0]], [0.1, 0.0, 0.1], [[0, 0]]])
            )
        if kind < 0.9:
            return odd_value(chance, 0.2)
        return np.array([odd_number(chance) for _ in range(chance.choice([0, 1, 3, 6]))], dtype=object)

    def enter(self, given: Any, chance: random.Random) -> None:
        check_profile(profile_of(given), chance)


class Words(Door):
    """Texts that say pushes, uncertainty or ground."""

    def make(self, chance: random.Random) -> Any:
        kind = chance.choice(["push", "terrain", "uncertainty"])
        if kind == "push":
            given: Any = chance.choice(
                [
                    "3.0:0.08:torso:0,50,0",
                    "1:0.1::5,0,0",
                    [[1.0, 0.1, None, [0, 50, 0]]],
                    [[1, 0.1, "torso", [1, 2, 3, 4, 5, 6]]],
                ]
            )
        elif kind == "terrain":
            given = chance.choice(
                [
                    "flat",
                    "slope:5",
                    "slope:5,30",
                    "blocks:2,7",
                    "plates:3,1",
                    "step:2,1",
                    "stairs:12x28",
                    "waves:2",
                    "soft:0.02",
                ]
            )
        else:
            given = {"noise": 1.0, "torque_delay": 0.004, "mass": 1.1, "roll_bias": 0.02, "links": 0.1, "lag": 0.01}
        return kind, odd_text(chance, given, [":", ",", "x", "1e9", "-1"]) if isinstance(given, str) else odd_tree(
            chance, given
        )

    def enter(self, given: Any, chance: random.Random) -> None:
        kind, value = given
        if kind == "push":
            for each in pushes_of(value):
                require(np.isfinite([each.t, each.duration, *each.force]).all(), "not finite")
            if seldom(chance):
                zmpwalk.simulate((MODEL, DESCRIPTION), 0.0, 0.05, push=value)
        elif kind == "terrain":
            ground = Terrain.of(value)
            require(Terrain.of(ground.text).text == ground.text, "no round trip")
            ground.height(0.7, 0.1)
        else:
            unsure = (
                Uncertainty(**value) if isinstance(value, dict) and all(map(str.isidentifier, value)) else Uncertainty()
            )
            require(Uncertainty(**unsure.to_dict()) == unsure, "no round trip")

    kinds = (TypeError,)


class Command(Door):
    """Live commands, and plans."""

    kinds = (TypeError,)

    def make(self, chance: random.Random) -> Any:
        if chance.random() < 0.7:
            return "command", [
                odd_number(chance, 0.2) if chance.random() < 0.9 else odd_value(chance)
                for _ in range(chance.choice([3, 3, 3, 1, 2, 4]))
            ]
        return "plan", [
            odd_number(chance, 2.0) if chance.random() < 0.9 else odd_value(chance)
            for _ in range(chance.choice([1, 2]))
        ]

    def enter(self, given: Any, chance: random.Random) -> None:
        kind, values = given
        controller, data = started()
        if kind == "plan":
            plan = controller.plan(*values)
            require(
                all(np.isfinite(plan[name]).all() for name in ("t", "com", "dcom", "zmp")), "a plan that is not finite"
            )
            require(len(plan["t"]) > 0, "an empty plan")
            return
        controller.command(*values)
        require(
            np.isfinite(controller.within_reach([float(v) for v in values] + [0.0] * (3 - len(values)))).all(),
            "not finite",
        )
        for _ in range(30):
            out = controller.update(data)
            require(np.isfinite(out.tau).all(), "a torque is not finite")
            require(
                controller.reach_share(out.command) <= 1 + 1e-9 if np.isfinite(out.command).all() else True,
                "beyond reach",
            )
            mujoco.mj_step(MODEL, data)


def started() -> tuple[WalkingController, Any]:
    controller, data = WalkingController(MODEL, DESCRIPTION, profile=0.1), mujoco.MjData(MODEL)
    DESCRIPTION.place(MODEL, data)
    controller.reset(data)
    return controller, data


class Update(Door):
    """States that have changed in reset and update, in `MjData` and in plain numbers."""

    kinds = (TypeError,)

    def make(self, chance: random.Random) -> Any:
        changes = []
        for _ in range(chance.choice([1, 1, 2, 6])):
            where = chance.choice(["qpos", "qvel", "time", "qpos", "qvel", "contact", "wrench", "size"])
            changes.append((where, chance.randrange(64), odd_number(chance, 0.1)))
        return chance.choice(["reset", "update", "state", "state reset", "after"]), changes, chance.randrange(5)

    def enter(self, given: Any, chance: random.Random) -> None:
        how, changes, cycles = given
        controller, data = started()
        for _ in range(cycles):
            controller.update(data)
            mujoco.mj_step(MODEL, data)
        t, q, dq = data.time, data.qpos.copy(), data.qvel.copy()
        more: dict[str, Any] = {}
        for where, i, value in changes:
            value = float(value)
            if where == "qpos":
                q[i % len(q)] = value
            elif where == "qvel":
                dq[i % len(dq)] = value
            elif where == "time":
                t = value
            elif where == "contact":
                more["contact"] = (value, 1.0)
            elif where == "size" and how.startswith("state"):
                q = np.resize(q, i)
        before = controller.com_height
        try:
            if how == "after":
                mujoco.mj_step1(MODEL, data)
            if how in ("reset", "update", "after"):
                data.time, data.qpos[:], data.qvel[:] = t, np.resize(q, MODEL.nq), dq
                if how == "reset":
                    controller.reset(data)
                    return
                out = controller.update(data, after_step1=how == "after")
            else:
                state = State(t, q, dq)
                if how == "state reset":
                    controller.reset(state)
                    return
                out = controller.update(state, **more)
        except (zmpwalk.Error, TypeError):
            require(controller.com_height == before, "a refused call changed the controller")
            raise
        require(np.isfinite(out.tau).all(), "a torque is not finite")
        require(
            (np.abs(out.tau) <= np.asarray(controller.torque_limit) * (1 + 1e-9)).all(), "a torque beyond its limit"
        )


class Line(Door):
    """The command line, in a folder of its own."""

    CORPUS = [
        ["walk", "--duration", "0.05", "--no-figures", "--out", "o"],
        ["walk", "--duration", "0.05", "--no-figures", "--out", "o", "--profile", "0:0.1,1:0.2", "--set", "tracker_gain=3"],
        ["walk", "--duration", "0.05", "--json", "--no-figures", "--law", "paper", "--out", "o", "--strict"],
        ["walk", "--duration", "0.05", "--no-figures", "--out", "o", "--push", "0.01:0.01:torso:0,9,0", "--seed", "3"],
        ["walk", "--duration", "0.05", "--no-figures", "--out", "o", "--terrain", "slope:5", "--uncertain", "noise=1"],
        ["inspect", "mahru"], ["inspect", "mahru", "--json"], ["inspect", "x.xml", "--write", "r.json"],
        ["settings", "mahru"], ["settings", "r.json"], ["humanoid", "--height", "1.2", "--mass", "40", "--out", "h.xml"],
        ["plot", "t.npz", "--figure", "velocity", "--out", "p"], ["plot", "--compare", "t.npz", "t.npz", "--out", "p"],
        ["sweep", "g.toml", "--out", "s"], ["video", "t.npz", "--out", "v.txt"], ["--version"], ["walk", "--help"],
    ]  # fmt: skip
    TOKENS = ["--out", "--robot", "--profile", "--duration", "--set", "--json", "-h", "mahru", "x.xml", "t.npz", "/dev/null",
              "/dev/zero", "/proc/self/mem", ".", "/", "~", "~nouser/x", "", "0", "-1", "nan", "1e300", "o", "a" * 300, "é"]  # fmt: skip

    def make(self, chance: random.Random) -> list[str]:
        words = list(chance.choice(self.CORPUS))
        for _ in range(chance.choice([0, 1, 1, 2, 3])):
            i = chance.randrange(1, len(words) + 1)
            kind = chance.random()
            if kind < 0.2:
                del words[i:][:1]
            elif kind < 0.45:
                words.insert(i, chance.choice(self.TOKENS))
            elif i < len(words):
                words[i] = odd_text(chance, words[i], self.TOKENS) if kind < 0.8 else chance.choice(self.TOKENS)
        words = [word.replace("\x00", "") for word in words]
        if "--duration" in words:  # a long walk is no hang
            k = words.index("--duration") + 1
            with contextlib.suppress(ValueError, IndexError):
                if 0.1 < float(words[k]) < 1e5:
                    words[k] = "0.05"
        return words if words[0] == "walk" or "--duration" not in words else words[:1]

    def enter(self, given: list[str], chance: random.Random) -> None:
        folder = PLACE / "cli"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        (folder / "x.xml").write_text(rough_robot())
        (folder / "g.toml").write_text("duration = 'a'\n[grid]\nprofile = [0.1]\n")
        shutil.copy(TRACE, folder / "t.npz")
        before = os.getcwd()
        out, err = io.StringIO(), io.StringIO()
        os.chdir(folder)
        try:
            words = given
            if words[:1] == ["walk"] and "--duration" not in words and "-h" not in words and "--help" not in words:
                words = [*words, "--duration", "0.05", "--no-figures"]
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
                code = cli.main(words)
        finally:
            os.chdir(before)
        said = err.getvalue()
        require(code in (0, 2, 3), f"exit code {code}: {said[-300:]}")
        require("Traceback" not in said + out.getvalue(), said[-500:])
        require(
            not list(folder.glob("**/.walk-*")) and not (folder / "MUJOCO_LOG.TXT").exists(), "left something behind"
        )
        lines = [line for line in said.splitlines() if line.startswith("zmpwalk: ")]
        if code == 2:
            require(lines, f"exit code 2 without a line: {said[-300:]}")
            raise zmpwalk.InputError(lines[-1])


DOORS: dict[str, Door] = {
    "robot": RobotJson(), "mjcf": Mjcf(), "csv": Csv(), "motion": Motion(), "toml": Toml(), "settings": Settings(),
    "npz": Npz(), "profile": Profile(), "words": Words(), "command": Command(), "update": Update(), "line": Line(),
}  # fmt: skip


# --- trying


def one_line(text: str) -> None:
    require(text.strip() and "\n" not in text.strip(), f"refused in several lines: {text[:300]!r}")
    require(len(text) <= LONGEST_LINE, f"refused in {len(text)} characters: {text[:200]!r}")
    require("nan m" not in text.lower().replace("nan m/s", ""), f"unclear: {text[:200]!r}")


def attempt(name: str, index: int, seed: int, show: bool = False) -> tuple[str, str]:
    """Tries an input. Returns "accepted", "refused" or "finding", and what was said."""
    chance = random.Random(f"{seed}:{name}:{index}")
    door = DOORS[name]
    given = door.make(chance)
    if show:
        print(door.show(given))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            door.enter(given, chance)
        return "accepted", ""
    except zmpwalk.Error as error:
        try:
            one_line(str(error))
        except Wrong as wrong:
            return "finding", str(wrong)
        return "refused", str(error)
    except MemoryError:
        return "finding", "it takes more than 1 GB"
    except Wrong as wrong:
        return "finding", f"wrong: {wrong}"
    except Exception as error:
        if isinstance(error, door.kinds):
            return "refused", str(error)
        place = traceback.extract_tb(error.__traceback__)[-1]
        return "finding", f"{type(error).__name__} at {Path(place.filename).name}:{place.lineno}: {str(error)[:300]}"


def worker(name: str, first: int, count: int, seed: int, pipe: int) -> None:
    """Tries inputs and writes a line for each: begun, and how it ended."""
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 2)
    os.dup2(quiet, 1)
    with open("/proc/self/statm", encoding="ascii") as file:
        now = int(file.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + MEMORY, now + MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for index in range(first, first + count):
        signal.setitimer(signal.ITIMER_PROF, HANGS)
        os.write(pipe, _packed("b", index, ""))
        what, said = attempt(name, index, seed)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        os.write(pipe, _packed(what[0], index, said if what == "finding" else ""))
    os._exit(0)


def _packed(what: str, index: int, said: str) -> bytes:
    raw = said.encode("utf-8", "replace")[:2000]
    return struct.pack("<cII", what.encode(), index, len(raw)) + raw


def assault(name: str, count: int, seed: int, until: float) -> tuple[dict[str, int], list[tuple[str, str]]]:
    """Tries inputs of a door until there were `count`, or the time is over."""
    counts, findings, index = {"accepted": 0, "refused": 0, "finding": 0}, [], 0
    word = {"a": "accepted", "r": "refused", "f": "finding"}
    while index < count and time.monotonic() < until:
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(read)
            try:
                worker(name, index, min(BATCH, count - index), seed, write)
            finally:
                os._exit(1)
        os.close(write)
        begun, buffer, deaf = -1, b"", False
        while True:
            if not select.select([read], [], [], DEAF)[0]:
                deaf = True
                break
            if time.monotonic() > until and begun < index:
                break
            part = os.read(read, 65536)
            if not part:
                break
            buffer += part
            while len(buffer) >= 9:
                what, k, size = struct.unpack("<cII", buffer[:9])
                if len(buffer) < 9 + size:
                    break
                said, buffer = buffer[9 : 9 + size].decode("utf-8", "replace"), buffer[9 + size :]
                if what == b"b":
                    begun = k
                    continue
                index = k + 1
                counts[word[what.decode()]] += 1
                if what == b"f":
                    findings.append((f"{name}:{k}", said))
        over = time.monotonic() > until
        with contextlib.suppress(ProcessLookupError):
            if deaf or over:
                os.kill(child, signal.SIGKILL)
        os.close(read)
        status = os.waitpid(child, 0)[1]
        if begun >= index and not (
            over and os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGKILL and not deaf
        ):
            how = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
            why = (
                f"hangs: over {HANGS:g} s" if how == signal.SIGPROF or deaf
                else f"crash: {signal.Signals(how).name}" if how else "the process ended"
            )  # fmt: skip
            findings.append((f"{name}:{begun}", why))
            counts["finding"] += 1
            index = begun + 1
    return counts, findings


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=int(np.random.SeedSequence().entropy % 1_000_000))
    parser.add_argument("--inputs", type=int, default=1000, help="at each door")
    parser.add_argument("--seconds", type=float, default=math.inf, help="at all doors together")
    parser.add_argument("--only", help="doors with commas, or one input such as npz:17, which is shown")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="fuzz-") as place:
        prepare(Path(place))
        if args.only and ":" in args.only:
            name, _, index = args.only.partition(":")
            what, said = attempt(name, int(index), args.seed, show=True)
            print(f"{args.only}: {what}: {said}")
            return int(what == "finding")
        names = args.only.split(",") if args.only else list(DOORS)
        print(f"seed {args.seed}, MuJoCo {mujoco.__version__}")
        print(f"{'door':10s} {'inputs':>8s} {'accepted':>9s} {'refused':>8s} {'findings':>9s} {'per second':>11s}")
        every: list[tuple[str, str]] = []
        total, start = 0, time.monotonic()
        for i, name in enumerate(names):
            began = time.monotonic()
            left = start + args.seconds - began
            counts, findings = assault(name, args.inputs, args.seed, began + left / (len(names) - i))
            tried = sum(counts.values())
            total += tried
            rate = tried / max(time.monotonic() - began, 1e-9)
            print(f"{name:10s} {tried:8d} {counts['accepted']:9d} {counts['refused']:8d} {counts['finding']:9d} {rate:11.0f}",
                  flush=True)  # fmt: skip
            every += findings
        print(f"{total} inputs, {len(every)} findings, {total / max(time.monotonic() - start, 1e-9):.0f} per second")
    for where, said in every:
        print(f"{where}: {said}")
    return int(bool(every))


if __name__ == "__main__":
    sys.exit(main())
