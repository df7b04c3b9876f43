# ruff: noqa: E501  (MJCF in one line)
"""Models as people bring them: any actuators, bases and chains walk; what is not modelled is refused in one line."""

import re
import xml.etree.ElementTree as ET

import mujoco
import numpy as np
import pytest
import zmpwalk
from zmpwalk import InputError, ModelError, VelocityProfile, WalkSettings
from zmpwalk.robots import description_from_dict, description_to_dict

NEW = not mujoco.__version__.startswith("2.")
ARM = "shoulder|elbow|wrist"


# --- changes to the bundled robot's MJCF: each is a function of its XML tree


def actuators(make, names=".*"):
    """Replace the motors of the joints that match by `make(joint, limit)`, MJCF text."""

    def change(root):
        motors = root.find("actuator")
        limits = {
            c.get("class"): c.find("motor").get("ctrlrange")
            for c in root.iter("default")
            if c.find("motor") is not None
        }
        for motor in motors.findall("motor[@class]"):
            joint, limit = motor.get("joint"), limits[motor.get("class")].split()[1]
            if not re.search(names, joint):
                continue
            motors.remove(motor)
            motors.extend(ET.fromstring(f"<a>{make(joint, float(limit))}</a>"))

    return change


def add(where, text):
    """Put MJCF text into the first element that the path finds; a new section where there is none."""

    def change(root):
        parent = root.find(where)
        if parent is None:
            parent = ET.SubElement(root, where)
        parent.extend(ET.fromstring(f"<a>{text}</a>"))

    return change


def body(name):
    return f".//body[@name='{name}']"


def put(where, **attributes):
    def change(root):
        for element in root.findall(where):
            for name, value in attributes.items():
                element.set(name, value)

    return change


def fixed(names):
    """Weld the joints that match: they, their motors and their angles in the keyframe go."""

    def change(root):
        joints = [joint.get("name") for joint in root.find("worldbody").iter("joint")]
        key = root.find("keyframe/key")
        qpos = key.get("qpos").split()
        kept = [q for name, q in zip(joints, qpos[7:]) if not re.search(names, name)]
        key.set("qpos", " ".join(qpos[:7] + kept))
        for parent in root.find("worldbody").iter("body"):
            for joint in parent.findall("joint"):
                if re.search(names, joint.get("name")):
                    parent.remove(joint)
        for motor in list(root.find("actuator")):
            if re.search(names, motor.get("joint")):
                root.find("actuator").remove(motor)

    return change


def keyframe_of(pose):
    """Rewrite the keyframe by joint name, for trees that other joints have come into; 0 where `pose` says nothing."""

    def change(root):
        key = root.find("keyframe/key")
        old = key.get("qpos").split()
        joints = [joint.get("name") for joint in root.find("worldbody").iter("joint")]
        key.set("qpos", " ".join(old[:7] + [str(pose.get(name, 0.0)) for name in joints]))

    return change


@pytest.fixture(scope="module")
def mahru():
    return zmpwalk.load_robot("mahru")


@pytest.fixture(scope="module")
def build(mahru_edited, mahru):
    pose = dict(mahru[1].stand_joints)
    named = {"waist in the chain": mahru_edited.hang_pelvis_from_torso, "keyframe": keyframe_of(pose)}

    def make(*changes):
        own_inertia = put("compiler", inertiafromgeom="auto")  # what is added weighs what its geoms do
        xml = mahru_edited.xml(
            own_inertia, *(named.get(change, change) if isinstance(change, str) else change for change in changes)
        )
        return mujoco.MjModel.from_xml_string(xml)

    return make


# --- what walks

POSITION = '<position name="{0}" joint="{0}" kp="300" forcerange="-{1} {1}"/>'
FINGERS = "".join(
    f'<body name="finger_{k}" pos="{0.02 * k} 0 -0.11"><joint name="finger_{k}" axis="0 1 0" range="-1 1" limited="true" '
    f'damping="0.05"/><geom type="capsule" size="0.006" fromto="0 0 0 0 0 -0.03" mass="0.02" contype="0" conaffinity="0"/></body>'
    for k in range(3)
)
FINGER_TENDON = '<fixed name="grip" stiffness="2" damping="0.1" springlength="0.05"><joint joint="finger_0" coef="1"/><joint joint="finger_1" coef="0.5"/></fixed>'
NECK = '<body name="head_2" pos="0 0 0.4"><joint name="neck" axis="0 0 1"/><joint name="nod" axis="0 1 0"/><geom size="0.05" mass="1" contype="0" conaffinity="0"/></body>'
TOE = '<body name="toe_{0}" pos="0.14 0 -0.07"><joint name="toe_{0}" axis="0 1 0" stiffness="5" damping="0.1"/><geom type="box" size="0.02 0.05 0.01" mass="0.1"/></body>'
TAIL = (
    "".join(
        f'<body name="tail_{k}" pos="-0.02 0 0"><joint name="tail_{k}" axis="0 1 0"/><geom size="0.01" mass="0.01" contype="0" conaffinity="0"/>'
        for k in range(35)
    )
    + "</body>" * 35
)
BALL = '<body name="ball" pos="2 2 0.2"><freejoint name="ball"/><geom size="0.1"/></body>'
SPINE = '<joint name="waist_roll" axis="1 0 0" pos="0 0 0.1"/><joint name="waist_pitch" axis="0 1 0" pos="0 0 0.1"/>'
WAISTS = '<motor joint="waist_roll" ctrlrange="-150 150"/><motor joint="waist_pitch" ctrlrange="-150 150"/>'
THIN_ARMS = put(f"{body('torso')}//geom", contype="0", conaffinity="0")  # hanging straight, they touch the thighs
MIMIC = '<joint name="mimic" joint1="l_wrist_yaw" joint2="r_wrist_yaw" polycoef="0 -1 0 0 0"/>'
MOCAP = '<body name="marker" mocap="true" pos="0 0 2"><geom size="0.02" contype="0" conaffinity="0"/></body>'

WALKS = {
    "motors with a negative gear": [actuators(lambda j, t: f'<motor joint="{j}" gear="-7" ctrlrange="-{t / 7} {t / 7}"/>')],
    "general actuators of pure gain": [actuators(lambda j, t: f'<general joint="{j}" gainprm="3.5" gear="2" forcerange="-{t / 2} {t / 2}"/>')],
    "position servos": [actuators(lambda j, t: POSITION.format(j, t))],
    "position servos that cannot follow": [actuators(lambda j, t: f'<position joint="{j}" kp="300" ctrlrange="-0.1 0.1"/>')],
    "velocity servos": [actuators(lambda j, t: f'<velocity joint="{j}" kv="20" forcerange="-{t} {t}"/>')],
    "position and velocity servos": [actuators(lambda j, t: f'<position joint="{j}" kp="300"/><velocity joint="{j}" kv="20"/>')],
    "servos with a filter": [actuators(lambda j, t: f'<general joint="{j}" dyntype="filter" dynprm="0.01" gainprm="50" biastype="affine" biasprm="0 -50 -1"/>')],
    "servos with an integrator": [actuators(lambda j, t: f'<general joint="{j}" dyntype="integrator" gainprm="50" biastype="affine" biasprm="3 -50 -1"/>')],
    "muscles at the knees": [actuators(lambda j, t: f'<muscle joint="{j}" force="500" lengthrange="-1 3"/>', "knee")],
    "two motors a knee": [actuators(lambda j, t: f'<motor joint="{j}" ctrlrange="-80 80"/>' * 2, "knee")],
    "no actuators at all": [actuators(lambda j, t: "")],
    "arms without actuators": [actuators(lambda j, t: "", ARM)],
    "actuation switched off": [add("option", '<flag actuation="disable"/>')],
    "welded arms": [fixed(ARM), THIN_ARMS],
    "legs alone": [fixed(f"{ARM}|waist"), THIN_ARMS],
    "a neck, toes and fingers": [add(body("torso"), NECK), add(body("l_hand"), FINGERS), *(add(body(f"{s}_foot"), TOE.format(s)) for s in "lr"), "keyframe"],
    "sixty joints": [add(body("torso"), TAIL), "keyframe"],
    "springs, dampers, friction, rotors": [put(".//default[@class='mahru']/joint", stiffness="10", springref="0.1", damping="1.5", frictionloss="1", armature="0.08")],
    "friction switched off": [put(".//default[@class='mahru']/joint", frictionloss="5"), add("option", '<flag frictionloss="disable"/>')],
    "under a fluid": [put("option", density="50", viscosity="0.1")],
    "Runge-Kutta steps": [put("option", integrator="RK4")],
    "implicit steps": [put("option", integrator="implicit")],
    "fingers on a tendon with a spring and a motor": [
        add(body("l_hand"), FINGERS), add("tendon", FINGER_TENDON), add("actuator", '<motor name="grip" tendon="grip"/>'), "keyframe",
    ],
    "wrists that mimic each other": [add("equality", MIMIC)],
    "a loop that is not active": [add("equality", '<connect body1="l_hand" body2="r_hand" anchor="0 0 0" active="false"/>')],
    "a mocap body": [add("worldbody", MOCAP)],
    "a tendon to the world that only measures": [
        add("worldbody", '<site name="hook" pos="0 0 3"/>'),
        add("tendon", '<spatial name="tape"><site site="hook"/><site site="imu"/></spatial>'),
    ],
    "a waist inside the legs' chain": ["waist in the chain"],
    "three waist joints inside the legs' chain": ["waist in the chain", add(body("pelvis"), SPINE), add("actuator", WAISTS), "keyframe_up"],
}  # fmt: skip
if NEW:
    WALKS.update({
        "implicitfast steps": [put("option", integrator="implicitfast")],
        "discrete steps": [put("option", integrator="discrete")],
        "motors of a group that is switched off": [actuators(lambda j, t: f'<motor joint="{j}" group="2"/>'), put("option", actuatorgroupdisable="2")],
        "gravity compensation through the motors": [put(".//body", gravcomp="0.25"), put("worldbody//joint", actuatorgravcomp="true")],
        "gravity compensation": [put(body("torso"), gravcomp="0.5")],
        "limits on the joints": [actuators(lambda j, t: f'<motor joint="{j}"/>'), put("worldbody//joint", actuatorfrcrange="-140 140")],
    })  # fmt: skip
if not hasattr(mujoco.mjtIntegrator, "mjINT_DISCRETE"):
    WALKS.pop("discrete steps", None)


@pytest.mark.parametrize("kind", WALKS)
def test_it_walks_and_the_estimate_is_the_contacts(build, kind):
    changes = [lift_keyframe if change == "keyframe_up" else change for change in WALKS[kind]]
    model = build(*changes)
    trace = zmpwalk.simulate(model, duration=2.8)
    summary = trace.summary()
    assert not summary["fell"]
    assert not trace.saturated.any()
    friction = model.dof_frictionloss.max() if "off" not in kind else 0.0
    # 1 mm for a sole of 0.25 m, and what the dry friction of an ankle may do
    weight = 9.81 * model.body_subtreemass[1]
    assert max(summary["zmp_error_mm"]["single_support_p95"]) < 0.3 + 1500 * friction / weight


def lift_keyframe(root):
    """As `keyframe_of` nothing: two more joints of the waist, after the first."""
    key = root.find("keyframe/key")
    qpos = key.get("qpos").split()
    key.set("qpos", " ".join([*qpos[:8], "0", "0", *qpos[8:]]))


def test_waist_inside_the_chain_walks_the_same_walk(build, mahru):
    inside = zmpwalk.simulate(build("waist in the chain"), duration=2.0)
    outside = zmpwalk.simulate(mahru, duration=2.0)
    assert list(inside.description.left.leg_joints) == list(outside.description.left.leg_joints)
    assert np.abs(inside.com[:, :2] - outside.com[:, :2]).max() < 1e-3


SERVOS = {
    "position": lambda j, t: POSITION.format(j, t),
    "clipped": lambda j, t: f'<position joint="{j}" kp="300" ctrlrange="-0.1 0.1" forcerange="-20 20"/>',
    "several": lambda j, t: f'<position joint="{j}" kp="300"/><velocity joint="{j}" kv="20"/><motor joint="{j}"/>',
    "filter": lambda j, t: (
        f'<general joint="{j}" dyntype="filter" dynprm="0.01" gainprm="50" biastype="affine" biasprm="2 -50 -1"/>'
    ),
    "muscle": lambda j, t: f'<muscle joint="{j}" force="300" lengthrange="-1 3"/>',
    "none": lambda j, t: "",
}


@pytest.mark.parametrize("kind", SERVOS)
@pytest.mark.parametrize("hold", [1, 3])
def test_exactly_the_torque_reaches_the_joints(build, kind, hold):
    model = build(actuators(SERVOS[kind]))
    description = zmpwalk._core.describe(model)
    settings = WalkSettings(control_dt=hold * model.opt.timestep)
    controller = zmpwalk.WalkingController(model, description, settings, VelocityProfile.constant(0.02))
    assert all(path.startswith("qfrc_applied: ") for path in controller.torque_path.values())
    data = mujoco.MjData(model)
    description.place(model, data)
    data.act[:] = 0.3
    data.ctrl[:] = 7.0
    controller.reset(data)
    for _ in range(30):
        out = controller.update(data)
        mujoco.mj_step(model, data)  # forces that stay in data are those of the state before
        assert np.abs((data.qfrc_actuator + data.qfrc_applied)[6:] - out.tau).max() < 1e-9
        assert not data.qfrc_applied[:6].any()


def robot_drives(model):
    return zmpwalk._core.describe(model).drives(model)


def test_torque_path_is_told(build):
    model = build(
        actuators(lambda j, t: POSITION.format(j, t), "ankle"), actuators(lambda j, t: "", "elbow"),
        actuators(lambda j, t: f'<velocity name="{j}" joint="{j}" kv="1"/>', "waist"),
    )  # fmt: skip
    robot = zmpwalk.Robot(model, zmpwalk._core.describe(model))
    path = robot.torque_path
    assert {joint: way for joint, (_, way) in robot_drives(model).items()} == path
    remarks = zmpwalk.propose(model).remarks
    assert (
        "the torque of 4 joints (l_ankle_pitch, l_ankle_roll, r_ankle_pitch, ...) goes through qfrc_applied: position servo is silenced"
        in remarks
    )
    assert list(path) == robot.joint_names
    assert path["l_knee"] == "motor 'l_knee'"
    assert path["l_ankle_roll"] == "qfrc_applied: position servo 'l_ankle_roll' is silenced"
    assert path["waist_yaw"] == "qfrc_applied: velocity servo 'waist_yaw' is silenced"
    assert path["r_elbow"] == "qfrc_applied: it has no actuator"


def test_what_others_write_stays(build):
    arm = '<body name="crane" pos="0 3 1"><joint name="crane" axis="0 1 0"/><geom size="0.1"/></body>'
    model = build(
        add("worldbody", arm), add("actuator", '<position name="crane" joint="crane" kp="5"/>'),
        actuators(lambda j, t: POSITION.format(j, t), "ankle"), lambda root: root.find("keyframe/key").set("qpos", root.find("keyframe/key").get("qpos") + " 0"),
    )  # fmt: skip
    description = zmpwalk._core.describe(model)
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    crane = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, "crane")
    dof = {name: model.joint(name).dofadr[0] for name in ("crane", "l_knee", "l_ankle_roll")}
    data.ctrl[crane], data.qfrc_applied[:] = 0.4, 0.25
    controller.update(data)
    assert data.ctrl[crane] == 0.4
    assert data.qfrc_applied[dof["crane"]] == data.qfrc_applied[dof["l_knee"]] == data.qfrc_applied[0] == 0.25
    assert data.qfrc_applied[dof["l_ankle_roll"]] != 0.25


def test_limits_come_from_model_description_and_settings(build, mahru):
    model = build(
        actuators(lambda j, t: f'<position joint="{j}" kp="300"/>', "hip"),
        actuators(lambda j, t: f'<motor joint="{j}" gear="2" ctrlrange="-30 40"/><position joint="{j}" kp="1" forcerange="-5 5"/>', "knee"),
        actuators(lambda j, t: f'<motor joint="{j}" gear="-2" ctrlrange="-50 40"/>', "ankle"),
    )  # fmt: skip
    plain = description_to_dict(mahru[1])
    plain["torque_limits"] = {"l_hip_yaw": 70.0, "l_ankle_roll": 60.0, "r_ankle_roll": 500.0}
    description = description_from_dict(plain)
    controller = zmpwalk.WalkingController(
        model,
        description,
        WalkSettings(torque_limits={"l_hip_yaw": 66, "r_hip_yaw": 55}),
        VelocityProfile.constant(0.1),
    )
    limit = dict(zip(controller.joint_names, controller.torque_limit))
    assert limit["l_hip_yaw"] == 66.0  # the settings have the last word
    assert limit["r_hip_yaw"] == 55.0
    assert np.isinf(limit["l_hip_roll"])
    assert limit["l_knee"] == 65.0  # 60 of the motor, the weaker way, and 5 of the servo
    assert limit["l_knee"] == description.drives(model)["l_knee"][0]
    assert limit["l_ankle_roll"] == 60.0
    assert limit["r_ankle_roll"] == 80.0  # a motor gives no more than the model lets through
    assert description_from_dict(description_to_dict(controller.description)).torque_limits["r_hip_yaw"] == 55.0


def test_silenced_servo_saturates_at_its_force_range(build):
    model = build(actuators(lambda j, t: f'<position joint="{j}" kp="300" forcerange="-3 3"/>', "knee"))
    trace = zmpwalk.simulate((model, zmpwalk._core.describe(model)), duration=0.3)
    knee = list(trace.meta["joint_names"]).index("l_knee")
    assert ((trace.saturated > 0) | (trace.limit_torques > 0))[:50].all()
    assert np.abs(trace.tau[:, knee]).max() == 3.0
    assert trace.torque_ratio[0] > 1.0


@pytest.mark.parametrize("limits", [{"l_knee": 0.0}, {"l_knee": -5.0}, {"l_knee": float("nan")}, {"tail": 5.0}])
def test_torque_limits_that_cannot_be_are_refused(mahru, limits):
    with pytest.raises((InputError, ModelError), match="|".join(limits)):
        zmpwalk.WalkingController(*mahru, WalkSettings(torque_limits=limits))


# --- what does not walk, and why

HAND_LOOP = '<connect name="clasp" body1="l_hand" body2="r_hand" anchor="0 0 0"/>'
KNEE_TENDON = '<fixed name="band" {}><joint joint="l_knee" coef="1"/></fixed>'
ELBOW_TENDON = KNEE_TENDON.replace("l_knee", "l_elbow")
HOOK = add("worldbody", '<site name="hook" pos="0 0 3"/>')
ROPE = '<spatial name="rope" {}><site site="hook"/><site site="imu"/></spatial>'
SKIRT = '<flex name="skirt" dim="2" body="torso torso pelvis" vertex="0 0 0 0.1 0 0 0 0.1 0" element="0 1 2"/>'
HEAD = '<body name="head_2" pos="0 0 0.4"><joint name="neck" {}/><geom size="0.05" mass="1"/></body>'

REFUSED = {
    "gravity sideways": ([put("option", gravity="0 1 -9.81")], "gravity is (0, 1, -9.81) m/s^2;"),
    "no gravity": ([put("option", gravity="0 0 0")], "gravity is (0, 0, 0) m/s^2;"),
    "gravity upwards": ([put("option", gravity="0 0 9.81")], "points down along z"),
    "gravity switched off": ([add("option", '<flag gravity="disable"/>')], "and switched off"),
    "contacts switched off": ([add("option", '<flag contact="disable"/>')], "switch contacts off"),
    "soles that do not collide": ([put(".//default[@class='sole_box']/geom", contype="0", conaffinity="0")], "has no geom that can collide"),
    "hands clasped": ([add("equality", HAND_LOOP)], "closed loop: equality 'clasp' ties body 'l_hand' to body 'r_hand'"),
    "hung by a weld": ([add("equality", '<weld name="hook" body1="torso"/>')], "equality 'hook' ties body 'torso' to what is not the robot"),
    "a coupled knee": ([add("equality", '<joint name="cam" joint1="l_knee" joint2="r_elbow"/>')], "equality 'cam' couples leg joint 'l_knee'"),
    "a mimic off at the stand": ([add("equality", '<joint name="mimic" joint1="l_elbow" polycoef="0.3 0 0 0 0"/>')], "equality 'mimic' is 0.85"),
    "a knee held by a tendon's equality": (
        [add("tendon", KNEE_TENDON.format("")), add("equality", '<tendon name="tie" tendon1="band"/>')], "equality 'tie' couples leg joint 'l_knee'"),
    "a knee limited by a tendon": ([add("tendon", KNEE_TENDON.format('limited="true" range="0 1"'))], "tendon 'band' limits leg joint 'l_knee'"),
    "a tendon's limit broken at the stand": ([add("tendon", ELBOW_TENDON.format('limited="true" range="0 1"'))], "the limit of tendon 'band' is 0.55"),
    "a tendon that rubs": ([add("tendon", ELBOW_TENDON.format('frictionloss="1"'))], "tendon 'band' of the robot has dry friction"),
    "a rope to the ceiling": ([HOOK, add("tendon", ROPE.format('stiffness="100"'))], "tendon 'rope' pulls the robot to what is not the robot"),
    "a winch at the ceiling": ([HOOK, add("tendon", ROPE.format("")), add("actuator", '<motor name="winch" tendon="rope"/>')], "actuator 'winch' pulls the robot"),
    "a knee driven by a tendon": (
        [add("tendon", KNEE_TENDON.format("")), add("actuator", '<motor name="winch" tendon="band"/>')], "actuator 'winch' drives leg joint 'l_knee' through a tendon"),
    "a thruster": ([add("actuator", '<general name="jet" site="imu" gear="0 0 1 0 0 0"/>')], "actuator 'jet' acts on the robot through a site"),
    "sticky feet": ([add("actuator", '<adhesion name="glue" body="l_foot" ctrlrange="0 1" gain="10"/>')], "actuator 'glue' acts on the robot through a body"),
    "a slider-crank": ([add("actuator", '<motor name="crank" cranksite="imu" slidersite="left_foot_ft" cranklength="0.9"/>')], "through a slider-crank"),
    "a pushed base": ([add("actuator", '<motor name="push" joint="root" gear="0 0 1 0 0 0"/>')], "actuator 'push' pushes the floating base"),
    "a motor that only pushes": ([actuators(lambda j, t: f'<motor joint="{j}" ctrlrange="5 9"/>', "l_knee")], "range without 0 inside"),
}  # fmt: skip
if NEW:
    REFUSED.update({
        "motors that answer late": ([actuators(lambda j, t: f'<motor name="{j}" joint="{j}" delay="0.004" nsample="5"/>', "l_knee")], "actuator 'l_knee' of the robot delays its control"),
        "a robot that floats": ([put(".//body", gravcomp="0.5")], "lifts 50 %"),
        "a skirt": ([add("deformable", SKIRT)], "body 'pelvis': a flex is attached to it"),
        "a tendon with a rotor": ([add("tendon", ELBOW_TENDON.format('armature="1"'))], "has armature"),
        "geoms that stick": ([put(".//default[@class='sole_box']/geom", adhesion="5")], "its geoms stick"),
    })  # fmt: skip
for member, kind in (("actuator_delay", "motors that answer late"), ("geom_adhesion", "geoms that stick")):
    if not hasattr(mujoco.MjModel, member):
        REFUSED.pop(kind, None)


@pytest.mark.parametrize("route", ["robot.json", "its own marks"])
@pytest.mark.parametrize("kind", REFUSED)
def test_what_is_not_modelled_is_refused_in_one_line(build, mahru, kind, route):
    changes, words = REFUSED[kind]
    model = build(*changes)
    with pytest.raises(ModelError) as caught:
        zmpwalk.WalkingController(model, mahru[1] if route == "robot.json" else None)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def change(plain, path, value):
    *keys, last = path.split(".")
    for key in keys:
        plain = plain[key]
    plain[last] = value


LEG = [f"l_{joint}" for joint in ("hip_yaw", "hip_roll", "hip_pitch", "knee", "ankle_pitch", "ankle_roll")]
WRONG = {
    "five joints a leg": ("left.leg_joints", LEG[:5], "the left leg that ends at body 'l_foot' has 5 joints ('l_hip_yaw', 'l_hip_roll', 'l_hip_pitch', 'l_knee', 'l_ankle_pitch')"),
    "a leg from foot to hip": ("left.leg_joints", LEG[::-1], "not listed from hip to ankle: 'l_ankle_pitch' comes before 'l_ankle_roll'"),
    "one leg twice": ("right.leg_joints", LEG, "the right leg lists joints that do not move its foot 'r_foot': 'l_hip_yaw', 'l_hip_roll'"),
    "a fixed base": ("root_joint", "l_knee", "'l_knee' is not a free joint"),
    "point feet": ("left.length", 0.02, "point foot: the left sole, of body 'l_foot', is 0.02 x 0.14 m"),
    "a stand in the air": ("stand_base_pos", [0, 0, 0.9], "m over the ground; both soles must lie flat"),
    "a stand on the toes": ("stand_joints.l_ankle_pitch", 0.0, "the left sole is tilted by 0.39"),
    "a limit of nothing": ("torque_limits", {"l_knee": 0}, "the torque limit of joint 'l_knee' is 0 N m"),
    "a limit of no joint": ("torque_limits", {"l_nee": 5}, "no joint named 'l_nee'"),
}  # fmt: skip


@pytest.mark.parametrize("kind", WRONG)
def test_description_that_cannot_walk_is_refused_in_one_line(mahru, kind):
    path, value, words = WRONG[kind]
    plain = description_to_dict(mahru[1])
    change(plain, path, value)
    with pytest.raises(ModelError) as caught:
        zmpwalk.WalkingController(mahru[0], description_from_dict(plain))
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_straight_knees_are_refused(mahru):
    plain = description_to_dict(mahru[1])
    for side in "lr":
        for joint in ("hip_pitch", "knee", "ankle_pitch"):
            plain["stand_joints"][f"{side}_{joint}"] = 0.0
    plain["stand_base_pos"][2] += 0.61 * (1 - np.cos(0.3925))
    with pytest.raises(
        ModelError, match="cannot move its sole in every direction at the start pose: its knee is straight"
    ):
        zmpwalk.WalkingController(mahru[0], description_from_dict(plain))


def test_joints_of_the_robot_that_no_one_knows_are_refused(build, mahru):
    for joint, words in (('type="ball"', "'neck' is neither hinge nor slide"), ("", "no value for joint 'neck'")):
        model = build(
            add(body("torso"), HEAD.format(joint)),
            "keyframe" if not joint else lambda root: root.remove(root.find("keyframe")),
        )
        with pytest.raises(ModelError, match=words):
            zmpwalk.WalkingController(model, mahru[1])
    model = build(add(body("torso"), HEAD.format("").replace('name="neck" ', "")), "keyframe")
    with pytest.raises(ModelError, match="at body 'head_2' has no name"):
        zmpwalk.WalkingController(model, mahru[1])


@pytest.mark.parametrize("floor", [put(".//geom[@name='floor']", pos="0 0 -0.1"), lambda root: root.find("worldbody").remove(root.find(".//geom[@name='floor']"))])  # fmt: skip
def test_simulation_without_a_floor_under_the_feet_is_refused(build, mahru, floor):
    with pytest.raises(ModelError, match="'l_foot' touches nothing: the model needs a floor at z = 0"):
        zmpwalk.simulate((build(floor), mahru[1]), duration=0.1)


def test_passive_callback_is_refused(mahru):
    mujoco.set_mjcb_passive(lambda model, data: None)
    try:
        with pytest.raises(ModelError, match="mjcb_passive"):
            zmpwalk.WalkingController(*mahru)
    finally:
        mujoco.set_mjcb_passive(None)


def test_time_step_of_nothing_is_refused(build, mahru):
    for timestep in (0.0, -0.001, float("nan")):
        model = build()
        model.opt.timestep = timestep
        with pytest.raises(ModelError, match="time step"):
            zmpwalk.WalkingController(model, mahru[1])


def test_robot_is_the_one_that_is_named_among_many(build, mahru):
    """Two robots, a ball and a pendulum in one scene: the second robot walks, the first one's controls are left alone."""

    def second_robot(root):
        world, motors = root.find("worldbody"), root.find("actuator")
        text = ET.tostring(world.find("body[@name='pelvis']"), encoding="unicode")
        twin = ET.fromstring(re.sub(r'\bname="', 'name="b_', text))
        twin.set("pos", "0 3 0.75")
        world.insert(1, ET.fromstring(BALL))
        world.append(twin)
        for motor in list(motors):
            motors.append(ET.fromstring(re.sub(r'(name|joint)="', r'\1="b_', ET.tostring(motor, encoding="unicode"))))
        root.remove(root.find("keyframe"))
        root.remove(root.find("contact"))

    model = build(second_robot)
    plain = description_to_dict(mahru[1])
    plain = {**plain, "root_joint": "b_root", "stand_joints": {f"b_{j}": q for j, q in plain["stand_joints"].items()}}
    for side in ("left", "right"):
        foot = plain[side]
        plain[side] = {**foot, "foot_body": f"b_{foot['foot_body']}", "sole_site": f"b_{foot['sole_site']}", "leg_joints": [f"b_{j}" for j in foot["leg_joints"]]}  # fmt: skip
    plain["stand_base_pos"][1] += 3.0
    controller = zmpwalk.WalkingController(model, description_from_dict(plain), profile=VelocityProfile.paper())
    data = mujoco.MjData(model)
    controller.description.place(model, data)
    data.ctrl[:] = 0.125
    controller.reset(data)
    while data.time < 2.0:
        out = controller.update(data)
        mujoco.mj_step(model, data)
        assert not out.fell
    assert (data.ctrl[:25] == 0.125).all()
    assert out.com[0] > 0.1
    assert abs(out.com[1] - 3.0) < 0.2
