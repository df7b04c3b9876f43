"""Random plausible humanoids as MJCF in memory: `xml, facts = random_humanoid(seed)`.

x forward, y left, z up, SI; `leg` is thigh + shank. Every limit is a constant below, listed in `docs/random_robots.md`.
The robots carry no marks, neither sole sites nor a keyframe: `zmpwalk.describe` has to find everything.
"""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
from zmpwalk.robots.humanoid import ARM, DENSITY, FEET, RANGES, WAISTS, mjcf

LEG, THIGH = (0.2, 0.9), (0.4, 0.6)  # thigh + shank [m]; thigh, of the leg
MASS = (0.5, 2.0)  # of DENSITY leg^3
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
TIMESTEPS, SOLREFS = (0.0005, 0.001, 0.002), (0.005, 0.01, 0.02)  # [s]
HIPS, ANKLES = tuple("".join(order) for order in itertools.permutations("yrp")), ("pr", "rp")


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
        "seed": seed, "name": f"random_{seed}", "leg": leg, "thigh": thigh, "shank": leg - thigh,
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
    return mjcf(f), f
