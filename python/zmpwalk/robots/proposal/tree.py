"""The kinematic tree of a robot, and what is found in it: names, links, joints, the two sides."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np

from ..._core import RobotDescription

UP = np.array([0.0, 0.0, 1.0])
OBJ = mujoco.mjtObj


def _numbers(kinds: Any) -> Any:
    """The members of one of MuJoCo's enums as plain integers: NumPy's do not always compare with the enum's own."""
    names = [name for name in dir(kinds) if name.startswith("mj")]
    return SimpleNamespace(**{name: int(getattr(kinds, name)) for name in names})


GEOM, JNT, EQ = (_numbers(kinds) for kinds in (mujoco.mjtGeom, mujoco.mjtJoint, mujoco.mjtEq))
WRAP = _numbers(mujoco.mjtWrap)
HELP = "; add box sites left_sole and right_sole and a keyframe stand, or pass a robot.json"


class Tree:
    """The kinematic tree that a body hangs in; a link is a body with joints, and what is welded to it."""

    def __init__(self, model: mujoco.MjModel, body: int):
        self.model, self.root = model, int(model.body_rootid[body])
        self.bodies = [b for b in range(1, model.nbody) if model.body_rootid[b] == self.root]
        self.links = sorted({int(model.body_weldid[b]) for b in self.bodies})

    def chain(self, link: int) -> list[int]:
        """Links from `link` up to the root, itself first."""
        links = []
        while link > 0:
            links.append(link)
            link = int(self.model.body_weldid[self.model.body_parentid[link]])
        return links

    def joints(self, link: int, stop: list[int]) -> list[int]:
        """Joints from the first link outside `stop` down to `link`."""
        links = [one for one in self.chain(link) if one not in stop]
        return [int(self.model.body_jntadr[one]) + k for one in links[::-1] for k in range(self.model.body_jntnum[one])]

    def under(self, link: int) -> list[int]:
        """Bodies that move with `link`."""
        return [b for b in self.bodies if link in self.chain(int(self.model.body_weldid[b]))]

    def limbs(self, legs: set[int]) -> list[int]:
        """First links of what hangs from the trunk and the links of the `legs`: arms, head, toes.

        The trunk is the root and each link above the legs that carries more than an arm does: waist, torso.
        """
        model, trunk, limbs = self.model, legs | {self.root}, []
        for link in self.links:  # parents come first
            if link not in trunk and int(model.body_weldid[model.body_parentid[link]]) in trunk:
                if model.body_subtreemass[link] > 0.2 * model.body_subtreemass[self.root]:
                    trunk.add(link)
                else:
                    limbs.append(link)
        return limbs


@dataclass
class Side:
    """A foot as it is found: its link, its leg's joint numbers, and the sole in the foot body's frame."""

    link: int
    joints: list[int]
    corners: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))  # on the sole, in the body [m]
    up: np.ndarray = field(default_factory=lambda: UP)
    pos: np.ndarray = field(default_factory=lambda: np.zeros(3))
    R: np.ndarray = field(default_factory=lambda: np.eye(3))  # columns: forward, left, up in the body
    length: float = 0.0
    width: float = 0.0


@dataclass
class Found:
    """The robot in the model: the tree, data at the reference pose, left and right, directions in the world."""

    tree: Tree
    data: mujoco.MjData
    sides: list[Side]
    remarks: list[str]
    forward: np.ndarray = field(default_factory=lambda: np.array([1.0, 0.0, 0.0]))
    left: np.ndarray = field(default_factory=lambda: np.array([0.0, 1.0, 0.0]))


def name_of(model: mujoco.MjModel, kind: Any, index: int) -> str:
    return mujoco.mj_id2name(model, kind, int(index)) or ""


def find_id(model: mujoco.MjModel, kind: Any, name: str) -> int:
    return int(mujoco.mj_name2id(model, kind, name))


def root_body(model: mujoco.MjModel, description: RobotDescription) -> int:
    """The floating base of a robot whose description fits the model."""
    return int(model.body_rootid[find_id(model, OBJ.mjOBJ_BODY, description.left.body)])


def body_label(model: mujoco.MjModel, body: int) -> str:
    return f"body '{name_of(model, OBJ.mjOBJ_BODY, body) or body}'"


def joint_names(model: mujoco.MjModel, joints: list[int]) -> str:
    return ", ".join(name_of(model, OBJ.mjOBJ_JOINT, j) or f"joint {j}" for j in joints)


def tendon_joints(model: mujoco.MjModel, tendon: int) -> list[int]:
    """Joints that a tendon pulls: those of a fixed one, those between the sites of a spatial one."""
    wraps = range(int(model.tendon_adr[tendon]), int(model.tendon_adr[tendon] + model.tendon_num[tendon]))
    joints, bodies = [], []
    for w in wraps:
        if model.wrap_type[w] == WRAP.mjWRAP_JOINT:
            joints.append(int(model.wrap_objid[w]))
        elif model.wrap_type[w] == WRAP.mjWRAP_SITE:
            bodies.append(int(model.site_bodyid[model.wrap_objid[w]]))
    chains: list[set[int]] = []
    for body in bodies:
        chain = set()
        while body > 0:
            chain.add(body)
            body = int(model.body_parentid[body])
        chains.append(chain)
    moved = chains[0].union(*chains) - chains[0].intersection(*chains) if chains else set()
    return joints + [int(j) for j in range(model.njnt) if model.jnt_bodyid[j] in moved]
