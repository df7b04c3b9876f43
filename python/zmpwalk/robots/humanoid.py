"""A humanoid of the measures that you give, as an MJCF: to study proportions, feet and motors.

x forward, y left, z up, SI; the leg is thigh + shank. The robots carry no marks, neither sole sites nor a keyframe:
`zmpwalk.describe` finds everything. `benchmarks/random_humanoid.py` draws measures at random and writes them likewise.
"""

from __future__ import annotations

import math
import os
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping, Sequence

import mujoco
import numpy as np

from .._core import RobotDescription
from ..errors import InputError, ModelError
from ..files import as_input_error, whole
from .proposal import propose
from .source import Source, remember

__all__ = ["Humanoid", "humanoid", "mjcf", "static_need"]

G = 9.81  # [m/s^2]
DENSITY = 150.0  # mass / leg^3 of a robot whose mass is not given [kg/m^3]
ARM_SHARE = 0.1  # armature, damping and friction of arms and neck, of those of legs and waist
FEET = ("box", "spheres", "capsules", "mesh")
WAISTS, ARM, NECK = ("", "y", "p", "yp", "ypr"), "prypyrp", "yp"  # axes of joints, from the trunk outward
AXES = {"r": (1, 0, 0), "p": (0, 1, 0), "y": (0, 0, 1)}
RANGES = {"hip_p": (-2.0, 0.9), "hip_r": (-0.5, 0.8), "hip_y": (-0.8, 0.8), "knee_p": (-0.05, 2.4),
          "ankle_p": (-1.1, 0.8), "ankle_r": (-0.5, 0.5), "upper": (-2.0, 2.0)}  # [rad], left leg  # fmt: skip
BEND = 0.73  # knee of the static need [rad]
# Of the mass: both sides have hip, thigh, shank, foot and arm; what is left over is the torso's.
LINK_MASS = {"hip": 0.02, "thigh": 0.085, "shank": 0.055, "foot": 0.022, "arm": 0.04, "head": 0.045, "pelvis": 0.12}
WAIST, CROWN, NECK_AT = 0.1, 0.22, 1.05  # waist over the hips and crown over the neck, of the leg; neck, of the torso
WEAK = ("torque: ", "cannot hold the robot", "reach: ", "a usual walk", "the walking controller refuses it")


@dataclass(frozen=True)
class Humanoid:
    """A humanoid of given measures.

    Fields: xml, its MJCF; measures, name -> value of everything that was chosen or followed [m, kg, N m].
    """

    xml: str
    measures: Mapping[str, Any]

    @property
    def robot(self) -> tuple[mujoco.MjModel, RobotDescription]:
        """The compiled model and its description, which is what `simulate` and `WalkingController` take.

        Usage: `zmpwalk.simulate(zmpwalk.humanoid(height=1.2).robot)`
        """
        model = mujoco.MjModel.from_xml_string(self.xml)
        remember(model, Source({"humanoid.xml": self.xml.encode()}))
        return model, propose(model).description

    def save(self, path: str | os.PathLike) -> Path:
        """Write the MJCF, which `load_robot` and the commands take.

        Raises:
            InputError: the file cannot be written.

        Usage: `zmpwalk.humanoid(height=1.2).save("small.xml")`
        """
        path = Path(path)
        with as_input_error(path), whole(path) as draft:
            draft.write_text(self.xml, encoding="utf-8")
        return path


def humanoid(
    height: float = 1.6,
    mass: float | None = None,
    foot: Sequence[float] | None = None,
    *,
    leg: float | None = None,
    thigh: float = 0.5,
    hips: float | None = None,
    ankle: float | None = None,
    heel: float = 0.35,
    torque: float = 2.0,
    armature: float = 0.01,
    damping: float = 0.0,
    waist: str = "y",
    arms: int = 4,
    neck: int = 0,
    soles: str = "box",
    timestep: float = 0.001,
    name: str = "humanoid",
) -> Humanoid:
    """A humanoid of these measures that can walk, with six joints in each leg and a motor at each joint.

    Args:
        height: from the soles to the crown, standing straight [m].
        mass: of the whole robot [kg]; None takes 150 kg/m^3 leg^3, which is the mass of a slender person.
        foot: length and width of a sole [m]; None takes 0.4 and 0.18 of the leg.
        leg: thigh + shank [m]; None takes the share of the height that people have. What is left over is the torso's.
        thigh: share of the leg, 0.4 to 0.6.
        hips: distance between the two hips [m]; None takes 0.3 of the leg.
        ankle: height of the ankle over the sole [m]; None takes 0.1 of the leg.
        heel: how far the ankle is ahead of the heel, of the foot's length.
        torque: limit of each joint, as a multiple of what holds the robot on one bent leg with its weight over the toe.
        armature: rotor inertia of each joint of legs and waist, of mass leg^2.
        damping: of these joints, of mass g leg sqrt(leg / g).
        waist: axes of the waist's joints from below: "", "y", "p", "yp" or "ypr" (y yaw, p pitch, r roll).
        arms: joints in each arm, 2 to 7, or 0 for none.
        neck: joints of the neck, 0 to 2.
        soles: what touches the ground: "box", "spheres", "capsules" or "mesh".
        timestep: of the simulation [s].
        name: of the model.

    Returns:
        The robot: its MJCF and its measures.

    Raises:
        InputError: a measure that no such robot has, with the rule.
        ModelError: the robot is well formed but could not walk, with the reason.

    Usage: `zmpwalk.simulate(zmpwalk.humanoid(height=1.2, mass=40, foot=(0.2, 0.1)).robot)`
    """
    height = _number("height", height, 0.3, 3.0, "m")
    straight = 1.0 + WAIST + CROWN  # all but ankle and torso, of the leg
    leg = height / 2.05 if leg is None else leg  # people: about 0.49 of the height
    leg = _number("leg", leg, 0.2 * height, 0.6 * height, "m, 0.2 to 0.6 of the height")
    ankle = _number(
        "ankle", 0.1 * leg if ankle is None else ankle, 0.03 * leg, 0.25 * leg, "m, 0.03 to 0.25 of the leg"
    )
    torso = (height - ankle - straight * leg) / NECK_AT
    if torso < 0.2 * leg:
        raise InputError(f"leg is {leg:g} m: that leaves {torso:.3g} m for the torso, which needs {0.2 * leg:.3g} m")
    mass = DENSITY * leg**3 if mass is None else mass
    mass = _number("mass", mass, 20.0 * leg**3, 1000.0 * leg**3, "kg, 20 to 1000 kg/m^3 times the leg cubed")
    hips = _number("hips", 0.3 * leg if hips is None else hips, 0.1 * leg, leg, "m, 0.1 to 1 of the leg")
    if foot is None:
        foot = (0.4 * leg, 0.18 * leg)
    if len(foot) != 2:
        raise InputError(f"foot is {foot!r}; it must be length and width [m], such as (0.2, 0.1)")
    length = _number("foot's length", foot[0], 0.1 * leg, leg, "m, 0.1 to 1 of the leg")
    width = _number("foot's width", foot[1], 0.03 * leg, 0.95 * hips, "m, or the feet touch each other")
    for label, value, allowed in (("waist", waist, WAISTS), ("soles", soles, FEET)):
        if value not in allowed:
            raise InputError(f"{label} is {value!r}; it must be one of {', '.join(map(repr, allowed))}")
    if arms not in (0, *range(2, len(ARM) + 1)):
        raise InputError(f"arms is {arms!r}; it must be 0, or 2 to {len(ARM)} joints")
    if neck not in range(len(NECK) + 1):
        raise InputError(f"neck is {neck!r}; it must be 0 to {len(NECK)} joints")
    thigh = _number("thigh", thigh, 0.4, 0.6, "of the leg") * leg
    torque = _number("torque", torque, 0.01, 100.0, "times the static need")
    masses = {link: mass * share for link, share in LINK_MASS.items()}
    if not arms:
        masses["arm"] = 0.0
    twice = sum(masses[link] for link in ("hip", "thigh", "shank", "foot", "arm"))
    masses["torso"] = mass - 2 * twice - masses["head"] - masses["pelvis"]
    measures = {
        "name": name, "height": height, "leg": leg, "thigh": thigh, "shank": leg - thigh, "mass": mass,
        "hip_distance": hips, "foot_length": length, "foot_width": width,
        "heel": _number("heel", heel, 0.1, 0.9, "of the foot's length") * length, "ankle_side": 0.0,
        "ankle_height": ankle, "torso_height": torso, "feet": soles, "hips": "yrp", "ankles": "pr", "waist": waist,
        "base": "pelvis", "arm_joints": arms, "neck_joints": neck, "many_joints_per_body": False, "hip_offset": 0.0,
        "turned_axes": False, "gear": 1.0, "armature": _number("armature", armature, 0.0, 1.0, "of mass leg^2"),
        "damping": _number("damping", damping, 0.0, 1.0, "of mass g leg sqrt(leg / g)"), "friction": 0.0,
        "timestep": _number("timestep", timestep, 1e-5, 0.01, "s"), "solref": 0.005,
        "torque": dict.fromkeys(RANGES, torque), "masses": masses,
    }  # fmt: skip
    made = Humanoid(mjcf(measures), measures)
    _refuse_what_cannot_walk(made)
    return made


def mjcf(measures: Mapping[str, Any]) -> str:
    """The MJCF of a humanoid of all these measures, of which `humanoid(...).measures` is an example.

    Usage: `mjcf({**zmpwalk.humanoid().measures, "hips": "pry"})`
    """
    return ET.tostring(_Mjcf(measures).root, encoding="unicode")


def _refuse_what_cannot_walk(made: Humanoid) -> None:
    remarks = propose(mujoco.MjModel.from_xml_string(made.xml)).remarks  # raises ModelError where it finds no robot
    reasons = [remark for remark in remarks if any(word in remark for word in WEAK)]
    if reasons:
        raise ModelError(*(f"this humanoid cannot walk: {reason}" for reason in reasons))


def _number(name: str, value: Any, low: float, high: float, unit: str) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; it must be a number") from None
    if not (math.isfinite(number) and low <= number <= high):
        raise InputError(f"{name} is {number:g}; it must be {low:.3g} to {high:.3g} {unit}")
    return number


def static_need(f: Mapping[str, Any]) -> dict[str, float]:
    """Torque [N m] by kind of joint that holds the robot on one bent leg, its weight as far ahead as the toe.

    Pitches: the weight times the largest lever while it goes from under the ankle to the toe. Ankle roll: weight at
    the sole's edge. Hip roll: the weight half the hips' distance beside the hip; hip yaw: half of that. Upper body:
    the torso leaning by 0.3 rad.
    """
    weight, toe, thigh, shank = G * f["mass"], f["foot_length"] - f["heel"], f["thigh"], f["shank"]
    knee = thigh * shank * np.sin(BEND) / np.sqrt(thigh**2 + shank**2 + 2 * thigh * shank * np.cos(BEND))
    roll = weight * f["hip_distance"] / 2
    return {
        "hip_p": weight * toe, "hip_r": roll, "hip_y": roll / 2, "knee_p": weight * max(knee, toe - knee),
        "ankle_p": weight * toe, "ankle_r": weight * (f["foot_width"] / 2 + abs(f["ankle_side"])),
        "upper": 0.3 * G * (f["masses"]["torso"] + 2 * f["masses"]["arm"] + f["masses"]["head"]) * f["torso_height"],
    }  # fmt: skip


def _text(*values: float) -> str:
    return " ".join(f"{value:.9g}" for value in values)


class _Mjcf:
    """Writes the robot of the measures `f`."""

    def __init__(self, f: Mapping[str, Any]):
        self.f, leg, masses = f, f["leg"], f["masses"]
        scale = f["mass"] * leg
        self.passive = np.array(
            [f["armature"] * scale * leg, f["damping"] * scale * np.sqrt(G * leg), f["friction"] * scale * G]
        )
        self.limit = {kind: f["torque"][kind] * need for kind, need in static_need(f).items()}
        self.root = ET.Element("mujoco", model=f["name"])
        ET.SubElement(self.root, "compiler", angle="radian")
        ET.SubElement(self.root, "option", timestep=str(f["timestep"]))
        default = ET.SubElement(self.root, "default")
        ET.SubElement(default, "geom", contype="0", conaffinity="0", solref=_text(f["solref"], 1))
        if f["feet"] == "mesh":
            asset = ET.SubElement(self.root, "asset")
            ET.SubElement(asset, "mesh", name="foot", vertex=_text(*self.foot_mesh().ravel()))
        world = ET.SubElement(self.root, "worldbody")
        ET.SubElement(world, "geom", name="floor", type="plane", size="0 0 1", contype="1", conaffinity="1")
        self.contact = ET.SubElement(self.root, "contact")
        self.actuator = ET.SubElement(self.root, "actuator")

        waist, down = [("waist_" + axis, axis, "upper") for axis in f["waist"]], f["base"] == "trunk"
        z = f["ankle_height"] + leg + 0.1 * leg + 2 * f["hip_offset"]  # the waist, over the hips by 0.1 leg
        base = self.body(world, "torso" if down else "pelvis", (0, 0, z))
        ET.SubElement(base, "freejoint", name="root")
        other = self.chain(base, (0, 0, 0), waist, "pelvis" if down else "torso", 0.02 * masses["pelvis"])
        torso, pelvis = (base, other) if down else (other, base)
        own = masses["pelvis"] * (1 - 0.02 * max(len(waist) - 1, 0))  # without the links between the waist's joints
        self.box(pelvis, own, (0.2 * leg, f["hip_distance"], 0.15 * leg), (0, 0, -0.05 * leg))
        tall = f["torso_height"]
        wide = max(0.5 * leg, f["hip_distance"] + 0.15 * leg)
        self.box(torso, masses["torso"], (0.22 * leg, wide, tall), (0, 0, tall / 2))
        neck = [("neck_" + axis, axis, "upper") for axis in NECK[: f["neck_joints"]]]
        head = self.chain(torso, (0, 0, 1.05 * tall), neck, "head", 0.1 * masses["head"], share=ARM_SHARE)
        self.box(head, masses["head"] * (1 - 0.1 * max(len(neck) - 1, 0)), 3 * (0.2 * leg,), (0, 0, 0.12 * leg))
        for side, sign in (("left", 1), ("right", -1)):
            self.leg(pelvis, side, sign)
            if f["arm_joints"]:
                self.arm(torso, side, (0, sign * (wide / 2 + 0.08 * leg), 0.85 * tall))

    def body(self, parent: ET.Element, name: str, pos: tuple) -> ET.Element:
        return ET.SubElement(parent, "body", name=name, pos=_text(*pos))

    def box(self, parent: ET.Element, mass: float, size: tuple, pos: tuple = (0, 0, 0)) -> None:
        ET.SubElement(parent, "geom", type="box", mass=_text(mass), size=_text(*np.divide(size, 2)), pos=_text(*pos))

    def touch(self, parent: ET.Element, **attributes: str) -> None:
        ET.SubElement(parent, "geom", {"mass": "0", "contype": "1", "conaffinity": "1", **attributes})

    def limb(self, parent: ET.Element, mass: float, length: float, touch: bool) -> None:
        """A capsule from the body's origin down; where it touches, only its middle part does."""
        radius = 0.06 * self.f["leg"]
        ends = _text(0, 0, -0.1 * length, 0, 0, -0.9 * length)
        ET.SubElement(parent, "geom", type="capsule", mass=_text(mass), size=_text(radius), fromto=ends)
        if touch:
            self.touch(
                parent, type="capsule", size=_text(radius), fromto=_text(0, 0, -0.3 * length, 0, 0, -0.7 * length)
            )

    def hinge(self, parent: ET.Element, name: str, axis: str, kind: str, sign: int, share: float) -> None:
        low, high = sorted(sign * np.array(RANGES[kind]))
        armature, damping, friction = share * self.passive
        turned = self.f["turned_axes"] and (name.startswith("right") or axis == "p")
        if turned:
            low, high = -high, -low
        limit, gear = (1.0 if share == 1.0 else 0.3) * self.limit[kind], self.f["gear"]
        ET.SubElement(parent, "joint", name=name, axis=_text(*np.multiply(AXES[axis], -1 if turned else 1)),
                      limited="true", range=_text(low, high), armature=_text(armature), damping=_text(damping),
                      frictionloss=_text(friction))  # fmt: skip
        ET.SubElement(self.actuator, "motor", name=name, joint=name, gear=_text(gear), ctrllimited="true",
                      ctrlrange=_text(-limit / gear, limit / gear))  # fmt: skip

    def chain(
        self,
        parent: ET.Element,
        pos: tuple,
        hinges: list,
        last: str,
        link_mass: float,
        *,
        sign: int = 1,
        share: float = 1.0,
        step: float = 0.0,
    ) -> ET.Element:
        """Bodies with one hinge each, `step` below one another, or one body with all; the last one is called `last`."""
        if not hinges or self.f["many_joints_per_body"]:
            parent = self.body(parent, last, pos)
            for name, axis, kind in hinges:
                self.hinge(parent, name, axis, kind, sign if axis != "p" else 1, share)
            if len(hinges) > 1:
                self.box(parent, (len(hinges) - 1) * link_mass, 3 * (0.05 * self.f["leg"],))
            return parent
        for i, (name, axis, kind) in enumerate(hinges):
            is_last = i == len(hinges) - 1
            parent = self.body(parent, last if is_last else name + "_link", (0, 0, -step) if i else pos)
            self.hinge(parent, name, axis, kind, sign if axis != "p" else 1, share)
            if not is_last:
                self.box(parent, link_mass, 3 * (0.05 * self.f["leg"],))
        return parent

    def leg(self, pelvis: ET.Element, side: str, sign: int) -> None:
        f, masses, leg = self.f, self.f["masses"], self.f["leg"]
        step = 0.0 if f["many_joints_per_body"] else f["hip_offset"]
        hips = [(f"{side}_hip_{axis}", axis, f"hip_{axis}") for axis in f["hips"]]
        at = (0, sign * f["hip_distance"] / 2, -0.1 * leg)
        thigh = self.chain(pelvis, at, hips, side + "_thigh", masses["hip"] / 2, sign=sign, step=step)
        length = f["thigh"] - step * (2 - f["hips"].index("p"))  # the thigh goes from the hip's pitch to the knee
        self.limb(thigh, masses["thigh"], length, touch=True)
        shank = self.chain(thigh, (0, 0, -length), [(side + "_knee", "p", "knee_p")], side + "_shank", 0.0)
        self.limb(shank, masses["shank"], f["shank"], touch=True)
        ankles = [(f"{side}_ankle_{axis}", axis, f"ankle_{axis}") for axis in f["ankles"]]
        foot = self.chain(shank, (0, 0, -f["shank"]), ankles, side + "_foot", 0.2 * masses["foot"], sign=sign)
        ET.SubElement(self.contact, "exclude", body1=side + "_shank", body2=side + "_foot")
        x, y, z = f["foot_length"] / 2 - f["heel"], sign * f["ankle_side"], -f["ankle_height"]
        a, b, h = f["foot_length"] / 2, f["foot_width"] / 2, 0.4 * f["ankle_height"]
        self.box(foot, 0.8 * masses["foot"], (2 * a, 2 * b, h), (x, y, z + h / 2))
        if f["feet"] == "box":
            self.touch(foot, type="box", size=_text(a, b, h / 2), pos=_text(x, y, z + h / 2))
        elif f["feet"] == "mesh":
            self.touch(foot, type="mesh", mesh="foot", pos=_text(x, y, z + h / 2))
        else:
            r = 0.1 * f["ankle_height"]
            for v in (-b, b):
                if f["feet"] == "capsules":
                    ends = (x - a, y + v, z + r, x + a, y + v, z + r)
                    self.touch(foot, type="capsule", size=_text(r), fromto=_text(*ends))
                    continue
                for u in (-a, a):
                    self.touch(foot, type="sphere", size=_text(r), pos=_text(x + u, y + v, z + r))

    def foot_mesh(self) -> np.ndarray:
        """A flat prism whose corners are cut by a tenth of the width, about its middle."""
        a, b, h = self.f["foot_length"] / 2, self.f["foot_width"] / 2, 0.2 * self.f["ankle_height"]
        cut = 0.2 * b
        outline = [(u * (a - p), v * (b - q)) for u in (-1, 1) for v in (-1, 1) for p, q in ((0, cut), (cut, 0))]
        return np.array([(*point, z) for point in outline for z in (-h, h)])

    def arm(self, torso: ET.Element, side: str, at: tuple) -> None:
        length, mass = 0.35 * self.f["leg"], self.f["masses"]["arm"]
        hinges = [(f"{side}_arm_{i}", axis, "upper") for i, axis in enumerate(ARM[: self.f["arm_joints"]])]
        links = [("upper_arm", hinges[:3], at), ("forearm", hinges[3:5], (0, 0, -length))]
        links = [link for link in [*links, ("hand", hinges[5:], (0, 0, -0.8 * length))] if link[1]]
        shares = {1: (1.0,), 2: (0.55, 0.45), 3: (0.5, 0.4, 0.1)}[len(links)]
        parent = torso
        for (name, part, pos), share in zip(links, shares):
            sign = 1 if side == "left" else -1
            parent = self.chain(parent, pos, part, f"{side}_{name}", 0.02 * mass, sign=sign, share=ARM_SHARE)
            own = (share - 0.02 * (len(part) - 1)) * mass  # without the links between the joints
            self.limb(parent, own, 0.3 * length if name == "hand" else length, touch=False)
