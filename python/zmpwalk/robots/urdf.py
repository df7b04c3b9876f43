"""URDF files: MuJoCo reads them, and what they lack to walk is added and said: a free joint, a floor, motors."""

from __future__ import annotations

import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco

from ..errors import ModelError

__all__ = ["mesh_file", "read_urdf"]


def read_urdf(path: Path) -> tuple[mujoco.MjModel, list[str]]:
    """A URDF as a model that can walk.

    The robot gets a free joint at its root link where it has none, a floor at z = 0, and a motor at each joint with an
    effort limit. Visual shapes are left out, because contacts and masses do not need them. Mesh files are looked for as
    the URDF names them; `package://NAME/...` is looked for in the folders above the URDF.

    Args:
        path: the URDF.

    Returns:
        model: the compiled model.
        remarks: what was added, a line each.

    Raises:
        ModelError: it is no URDF, has no single root link, names a mesh that does not exist, or MuJoCo refuses it.

    Usage: `model, remarks = read_urdf(Path("robot.urdf"))`
    """
    try:
        robot = ET.parse(path).getroot()
    except (ET.ParseError, UnicodeDecodeError) as error:
        raise ModelError(f"{path}: it is not XML: {error}") from None
    if robot.tag != "robot":
        raise ModelError(f"{path}: it is no URDF: its outermost element is <{robot.tag}>, not <robot>")
    remarks = _free(robot, path)
    for link in robot.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    _find_meshes(robot, path)
    try:
        fixed = _compiled(robot)
        with tempfile.TemporaryDirectory() as scratch:
            saved = Path(scratch, "robot.xml")
            mujoco.mj_saveLastXML(str(saved), fixed)
            mjcf = ET.parse(saved).getroot()
        remarks += _complete(mjcf, robot)
        return _compiled(mjcf), remarks
    except ValueError as error:
        raise ModelError(f"{path}: MuJoCo cannot load it: {' '.join(str(error).split())}") from None


def _compiled(root: ET.Element) -> mujoco.MjModel:
    try:
        return mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))
    except Exception as error:  # MuJoCo raises ValueError, or its own FatalError
        raise ValueError(str(error)) from None


def _free(robot: ET.Element, path: Path) -> list[str]:
    """Give the root link a free joint."""
    links = [link.get("name") for link in robot.findall("link")]
    joints = [joint for joint in robot.findall("joint") if joint.find("child") is not None]
    children = {joint.find("child").get("link") for joint in joints}  # type: ignore[union-attr]
    roots = [name for name in links if name not in children]
    if len(roots) != 1:
        raise ModelError(f"{path}: a URDF has one root link, this has {len(roots)}: {', '.join(map(str, roots))}")
    if any(joint.get("type") == "floating" for joint in joints):
        return []
    root, world = str(roots[0]), "world"
    below = [joint for joint in joints if joint.find("parent").get("link") == root]  # type: ignore[union-attr]
    is_ground = robot.find(f"link[@name='{root}']/inertial") is None and len(below) == 1
    if is_ground and below[0].get("type") == "fixed":  # a link without mass that only holds the robot to the world
        below[0].set("type", "floating")
        return [f"URDF: joint '{below[0].get('name')}', which held the robot to '{root}', became a free joint"]
    while world in links:
        world += "_"
    ET.SubElement(robot, "link", name=world)
    free = ET.SubElement(robot, "joint", name="floating_base", type="floating")
    ET.SubElement(free, "parent", link=world)
    ET.SubElement(free, "child", link=root)
    return [f"URDF: a free joint 'floating_base' was added at link '{root}'"]


def _find_meshes(robot: ET.Element, path: Path) -> None:
    """Replace the names of mesh files by absolute paths, and have MuJoCo take them as they are."""
    found = {name: mesh_file(name, path, robot) for name in (mesh.get("filename", "") for mesh in robot.iter("mesh"))}
    own = robot.find("mujoco")
    own = ET.SubElement(robot, "mujoco") if own is None else own
    compiler = own.find("compiler")
    compiler = ET.SubElement(own, "compiler") if compiler is None else compiler
    folder = Path(path.parent, compiler.attrib.pop("meshdir", ""))
    compiler.set("strippath", "false")
    compiler.attrib.setdefault("balanceinertia", "true")
    for mesh in robot.iter("mesh"):
        name = mesh.get("filename", "")
        file = found[name]
        if file is None:
            raise ModelError(f"{path}: the mesh '{name}' was not found; it was looked for in {folder} and above")
        mesh.set("filename", file.resolve().as_posix())


def mesh_file(name: str, path: Path, robot: ET.Element) -> Path | None:
    """The file of a mesh of the URDF `robot` at `path`; None where it is not found.

    It is looked for in the compiler's mesh folder, beside the URDF and in the folders above.

    Usage: `mesh_file("package://robot/meshes/foot.stl", path, robot)`
    """
    compiler = robot.find("mujoco/compiler")
    folder = Path(path.parent, compiler.get("meshdir", "") if compiler is not None else "")
    _, is_package, inside = name.partition("package://")
    plain = inside if is_package else name.partition("file://")[2] or name
    places = [folder, path.parent, *path.resolve().parents]
    tails = [plain, *([plain.partition("/")[2]] if is_package else []), Path(plain).name]
    return next((p for tail in tails for p in (place / tail for place in places) if p.is_file()), None)


def _complete(mjcf: ET.Element, robot: ET.Element) -> list[str]:
    """Add a floor and motors to what MuJoCo made of the URDF."""
    world = mjcf.find("worldbody")
    assert world is not None  # MuJoCo always writes one
    floor = {"name": "floor", "type": "plane", "size": "20 20 0.1", "friction": "1 0.005 0.0001"}
    world.insert(0, ET.Element("geom", floor))
    world.insert(0, ET.Element("light", {"pos": "0 0 4", "dir": "0 0 -1"}))
    actuators = mjcf.find("actuator")
    actuators = ET.SubElement(mjcf, "actuator") if actuators is None else actuators
    motors = 0
    for joint in robot.findall("joint"):
        limit = joint.find("limit")
        effort = float(limit.get("effort", "0")) if limit is not None else 0.0
        if joint.get("type") in ("revolute", "continuous", "prismatic") and effort > 0.0:
            name = str(joint.get("name"))
            limits = {"ctrllimited": "true", "ctrlrange": f"{-effort!r} {effort!r}"}
            ET.SubElement(actuators, "motor", {"name": name, "joint": name, **limits})
            motors += 1
    return [f"URDF: a floor at z = 0 and {motors} motors, with the joints' effort limits, were added"]
