"""Random plausible humanoids as MJCF in memory: `xml, facts = random_humanoid(seed)`.

x forward, y left, z up, SI; `leg` is thigh + shank. Every limit is a constant below, listed in `docs/random_robots.md`.
The robots carry no marks, neither sole sites nor a keyframe: `zmpwalk.describe` has to find everything.
"""

from __future__ import annotations

import itertools
import xml.etree.ElementTree as ET
from typing import Any

import numpy as np

G = 9.81
LEG, THIGH = (0.2, 0.9), (0.4, 0.6)  # thigh + shank [m]; thigh, of the leg
DENSITY, MASS = 150.0, (0.5, 2.0)  # mass / leg^3 [kg/m^3], and the factor about it
FOOT_LENGTH, FOOT_WIDTH, WIDEST = (0.3, 0.5), (0.12, 0.25), 0.8  # of the leg; the width at most of the hips' distance
HEEL, ANKLE_SIDE = (0.25, 0.5), (-0.1, 0.1)  # ankle from the heel, of the length; beside the middle, of the width
ANKLE_HEIGHT, HIP_DISTANCE, HIP_OFFSET = (0.06, 0.15), (0.22, 0.45), (0.01, 0.06)  # of the leg
LINK_MASS = {"hip": (0.01, 0.03), "thigh": (0.06, 0.11), "shank": (0.04, 0.07), "foot": (0.015, 0.03),
             "arm": (0.02, 0.06), "head": (0.02, 0.07), "pelvis": (0.08, 0.16)}  # of the mass  # fmt: skip
TORSO_HEIGHT = (0.45, 0.75)  # of the leg
TORQUE, GEAR = (1.2, 3.0), (5.0, 150.0)  # limit of each kind of joint, of its static need; gear where it is not 1
ARMATURE = (1e-3, 0.5)  # of mass leg^2; or none
DAMPING = (1e-3, 0.05)  # of mass g leg sqrt(leg / g); or none
FRICTION = (1e-4, 5e-3)  # dry friction, of mass g leg; or none
ARM_SHARE = 0.1  # armature, damping and friction of arms and neck, of those of legs and waist
TIMESTEPS, SOLREFS = (0.0005, 0.001, 0.002), (0.005, 0.01, 0.02)  # [s]
FEET = ("box", "spheres", "capsules", "mesh")
HIPS, ANKLES = tuple("".join(order) for order in itertools.permutations("yrp")), ("pr", "rp")
WAISTS, ARM, NECK = ("", "y", "p", "yp", "ypr"), "prypyrp", "yp"
AXES = {"r": (1, 0, 0), "p": (0, 1, 0), "y": (0, 0, 1)}
RANGES = {"hip_p": (-2.0, 0.9), "hip_r": (-0.5, 0.8), "hip_y": (-0.8, 0.8), "knee_p": (-0.05, 2.4),
          "ankle_p": (-1.1, 0.8), "ankle_r": (-0.5, 0.5), "upper": (-2.0, 2.0)}  # [rad], left leg  # fmt: skip
BEND = 0.73  # knee of the static need [rad]


def random_humanoid(seed: int) -> tuple[str, dict[str, Any]]:
    """One robot: its MJCF, and what was drawn, by name."""
    rng = np.random.default_rng(seed)

    def between(limits, log=False):
        low, high = limits
        return float(np.exp(rng.uniform(np.log(low), np.log(high))) if log else rng.uniform(low, high))

    def chance(share):
        return bool(rng.random() < share)

    leg = between(LEG)
    thigh, hips, length = between(THIGH) * leg, between(HIP_DISTANCE) * leg, between(FOOT_LENGTH) * leg
    width = min(between(FOOT_WIDTH) * leg, WIDEST * hips)
    arm_joints = 0 if chance(0.25) else int(rng.integers(2, len(ARM) + 1))
    f = {
        "seed": seed, "leg": leg, "thigh": thigh, "shank": leg - thigh,
        "mass": DENSITY * leg**3 * between(MASS, log=True), "hip_distance": hips,
        "foot_length": length, "foot_width": width, "heel": between(HEEL) * length,
        "ankle_side": between(ANKLE_SIDE) * width, "ankle_height": between(ANKLE_HEIGHT) * leg,
        "torso_height": between(TORSO_HEIGHT) * leg,
        "feet": str(rng.choice(FEET)), "hips": str(rng.choice(HIPS)), "ankles": str(rng.choice(ANKLES)),
        "waist": str(rng.choice(WAISTS)), "base": "pelvis" if chance(0.5) else "trunk",
        "arm_joints": arm_joints, "neck_joints": int(rng.integers(0, 3)),
        "many_joints_per_body": chance(0.4), "hip_offset": 0.0 if chance(0.5) else between(HIP_OFFSET) * leg,
        "turned_axes": chance(0.3), "gear": 1.0 if chance(0.5) else between(GEAR, log=True),
        "armature": 0.0 if chance(0.15) else between(ARMATURE, log=True),
        "damping": 0.0 if chance(0.3) else between(DAMPING, log=True),
        "friction": 0.0 if chance(0.3) else between(FRICTION, log=True),
        "timestep": float(rng.choice(TIMESTEPS)), "solref": float(rng.choice(SOLREFS)),
        "torque": {kind: between(TORQUE, log=True) for kind in RANGES},
    }  # fmt: skip
    f["masses"] = {link: f["mass"] * between(share) for link, share in LINK_MASS.items()}
    if not arm_joints:
        f["masses"]["arm"] = 0.0
    twice = sum(f["masses"][link] for link in ("hip", "thigh", "shank", "foot", "arm"))
    f["masses"]["torso"] = f["mass"] - 2 * twice - f["masses"]["head"] - f["masses"]["pelvis"]
    return ET.tostring(_Mjcf(f).root, encoding="unicode"), f


def static_need(f: dict[str, Any]) -> dict[str, float]:
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
    """Writes the robot of the facts `f`."""

    def __init__(self, f: dict[str, Any]):
        self.f, leg, masses = f, f["leg"], f["masses"]
        scale = f["mass"] * leg
        self.passive = np.array(
            [f["armature"] * scale * leg, f["damping"] * scale * np.sqrt(G * leg), f["friction"] * scale * G]
        )
        self.limit = {kind: f["torque"][kind] * need for kind, need in static_need(f).items()}
        self.root = ET.Element("mujoco", model=f"random_{f['seed']}")
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
        ET.SubElement(parent, "geom", mass="0", contype="1", conaffinity="1", **attributes)

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
            for hinge in hinges:
                self.hinge(parent, *hinge, sign if hinge[1] != "p" else 1, share)
            if len(hinges) > 1:
                self.box(parent, (len(hinges) - 1) * link_mass, 3 * (0.05 * self.f["leg"],))
            return parent
        for i, hinge in enumerate(hinges):
            is_last = i == len(hinges) - 1
            parent = self.body(parent, last if is_last else hinge[0] + "_link", (0, 0, -step) if i else pos)
            self.hinge(parent, *hinge, sign if hinge[1] != "p" else 1, share)
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
