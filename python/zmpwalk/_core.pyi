"""
zmpwalk's C++ core: contact-consistent control, ZMP estimate, gait, and the walking loop.
"""

from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import typing

__all__: list[str] = [
    "ArmsSettings",
    "ComSettings",
    "CommandSettings",
    "Contact",
    "ContactSettings",
    "ContactSpace",
    "ControlSettings",
    "CycleOutput",
    "Dynamics",
    "FallSettings",
    "Foot",
    "FrameState",
    "FrameTask",
    "GaitGenerator",
    "GaitOutput",
    "GaitSettings",
    "JointMotion",
    "JointTask",
    "KnownGround",
    "LegParts",
    "LimitsSettings",
    "LinearInvertedPendulum",
    "MomentumTask",
    "ObserverSettings",
    "Plane",
    "PoseReference",
    "PostureSettings",
    "PythonTask",
    "RateSettings",
    "RecordedColumn",
    "Recorder",
    "ReferenceResult",
    "Robot",
    "RobotDescription",
    "RobotParts",
    "SensorNoise",
    "Setting",
    "SignalUncertainty",
    "Simulation",
    "State",
    "StepsSettings",
    "SwingSettings",
    "Task",
    "TaskAccelerations",
    "TaskSpace",
    "TaskState",
    "TrackingSettings",
    "TrunkSettings",
    "VelocityProfile",
    "VelocityTracker",
    "WalkSettings",
    "WalkingController",
    "WholeBodyController",
    "WholeBodyResult",
    "ZmpEstimate",
    "ZmpEstimator",
    "ZmpSettings",
    "benchmark_cycle",
    "benchmark_walk",
    "build_info",
    "common_plane",
    "connect",
    "describe",
    "distribute_wrench",
    "iterate_reference",
    "measured_zmp",
    "model_reasons",
    "mujoco_version",
    "pd_acceleration",
    "recorded_columns",
    "seen",
    "simulate",
    "solve_reference",
    "trunk_body",
    "yaw_momentum",
    "zmp_bounds",
    "zmp_of_wrench",
    "zmp_on_plane",
]

class Setting:
    """
    A row of the table of settings, see `WalkSettings.table`.
    """
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    @property
    def default(self) -> typing.Any:
        """
        default; NaN where it depends on the robot
        """
    @property
    def flat(self) -> str:
        """
        its one word, such as 'tracker_gain'
        """
    @property
    def group(self) -> str:
        """
        its group, such as 'tracking'
        """
    @property
    def meaning(self) -> str:
        """
        what it is for
        """
    @property
    def name(self) -> str:
        """
        its name in the group, such as 'gain'
        """
    @property
    def range(self) -> str:
        """
        the rule for its number or numbers; '' for what is no number
        """
    @property
    def rule(self) -> str:
        """
        how the robot gives its default; '' where it does not depend on the robot
        """
    @property
    def text(self) -> str:
        """
        what it is for, its unit, its words and its default, in one paragraph
        """
    @property
    def type(self) -> str:
        """
        its type, as an annotation
        """
    @property
    def unit(self) -> str:
        """
        SI; '' where it has none
        """
    @property
    def words(self) -> list[str]:
        """
        the words that there are, where it is one of a few
        """

class GaitSettingsDict(typing.TypedDict, total=False):
    T_ds: float
    T_ss: float
    T_ds_first: float
    first_swing: typing.Literal["right", "left"]
    cadence_speed: float
    cadence_exponent: float
    cadence_double: float
    cadence_sideways: float
    cadence_turning: float
    stand: bool
    stand_gain: float
    closing_distance: float
    closing_turn: float
    touch_down: typing.Literal["felt", "time", "contact"]
    touch_down_share: float
    touch_down_time: float
    touch_down_speed: float

class StepsSettingsDict(typing.TypedDict, total=False):
    mode: typing.Literal["tied", "absolute", "paper", "printed", "list"] | typing.Sequence[float]
    lengths: typing.Sequence[float]
    width: float
    clearance: float
    shift: float
    filter_time: float
    give: float
    freeze: float
    capture_distance: float
    capture_speed: float
    timing: bool
    ahead_most: float
    aside_most: float
    least_time: float
    wait_time: float

class SwingSettingsDict(typing.TypedDict, total=False):
    height: float
    feed_forward: bool
    kp: float
    kd: float
    ahead_acceleration: float
    aside_acceleration: float

class ComSettingsDict(typing.TypedDict, total=False):
    state: typing.Literal["measured", "desired"]
    feed_forward: bool
    kp_x: float
    kd_x: float
    kp_y: float
    kd_y: float
    kp_z: float
    kd_z: float
    lead: float
    least_knee: float
    crouch_limit: float
    crouch_margin: float
    crouch_time: float

class ZmpSettingsDict(typing.TypedDict, total=False):
    modification: bool
    iteration: typing.Literal["closed_form", "loop", "none"]
    threshold: float
    max_iterations: int
    sole_fraction: float
    sole_exponent: float
    ankle_torque_fraction: float
    bound_lateral: bool
    lateral_law: typing.Literal["orbit", "paper"]
    lateral_shift: float
    whole_fraction: float
    corner_cut: float

class TrackingSettingsDict(typing.TypedDict, total=False):
    law: typing.Literal["smooth", "bang_bang"]
    gain: float
    time: float
    catch_up_speed: float
    deadband: float
    regain_from: float
    regain_gain: float
    regain_speed: float

class RateSettingsDict(typing.TypedDict, total=False):
    limit: bool
    forward_jump: float
    sideways_jump: float
    turning_jump: float
    forward_acceleration: float
    forward_deceleration: float
    sideways_acceleration: float
    turning_acceleration: float

class TrunkSettingsDict(typing.TypedDict, total=False):
    kp: float
    kd: float
    yields: bool

class PostureSettingsDict(typing.TypedDict, total=False):
    task: bool
    kp: float
    kd: float
    motion_blend: float

class ArmsSettingsDict(typing.TypedDict, total=False):
    momentum: float
    kp: float
    kd: float
    reserve: float
    reserve_time: float

class ContactSettingsDict(typing.TypedDict, total=False):
    wrench_distribution: bool
    load_alone: float
    damping: float

class ControlSettingsDict(typing.TypedDict, total=False):
    dt: float
    textbook: bool
    singular_damping: float
    singular_pivot: float
    singular_task: float
    friction_velocity: float
    kernel: str
    torque_limits: typing.Mapping[str, float]

class LimitsSettingsDict(typing.TypedDict, total=False):
    keep: bool
    friction: float
    feel_slip: bool
    twist: float
    range_margin: float
    range_rate: float

class ObserverSettingsDict(typing.TypedDict, total=False):
    on: bool
    time: float
    speed_noise: float
    tolerance: float
    force_most: float
    weight_most: float
    push: float
    attitude_time: float
    attitude_noise: float
    bias_time: float
    bias_most: float
    sole_tilt: float

class CommandSettingsDict(typing.TypedDict, total=False):
    limit: bool
    share: float

class FallSettingsDict(typing.TypedDict, total=False):
    height: float
    tilt: float
    foot_tilt: float
    foresee: bool
    crouch: bool
    margin: float
    confirm_time: float

class WalkSettings:
    """
    Everything about a walk that can be set: gains, times, bounds and laws, in groups. Settings that are not given take a default, most of which scale with the robot. `help(WalkSettings.__init__)` lists them all.
    """

    __hash__: typing.ClassVar[None] = None
    @staticmethod
    def __repr__(settings: WalkSettings) -> str: ...
    @staticmethod
    def _repr_html_(settings: WalkSettings) -> str: ...
    @staticmethod
    def find(name: str) -> Setting:
        """
        The row of one setting.

        Args:
            name: 'tracking.gain', or its one word 'tracker_gain'.

        Raises:
            InputError: there is none; the message names the nearest.

        Usage: `print(WalkSettings.find('T_ss').text)`
        """
    def __copy__(self) -> WalkSettings: ...
    def __deepcopy__(self, arg0: dict) -> WalkSettings: ...
    def __eq__(self, arg0: WalkSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        All settings by their one word, as plain Python values.
        """
    @property
    def lateral_feedback(self) -> bool:
        """
        It is zmp.lateral_law now: true stands for 'orbit', false for 'paper'.
        """
    @lateral_feedback.setter
    def lateral_feedback(self, arg1: typing.Any) -> None: ...
    @property
    def law(self) -> str:
        """
        preset this started from
        """
    def __init__(
        self,
        law: str = "default",
        *,
        gait: GaitSettings | GaitSettingsDict = ...,
        T_ds: float = ...,
        T_ss: float = ...,
        T_ds_first: float = ...,
        first_swing: typing.Literal["right", "left"] = ...,
        cadence_speed: float = ...,
        cadence_exponent: float = ...,
        cadence_double: float = ...,
        cadence_sideways: float = ...,
        cadence_turning: float = ...,
        stand: bool = ...,
        stand_gain: float = ...,
        closing_reach: float = ...,
        closing_turn: float = ...,
        touch_down: typing.Literal["felt", "time", "contact"] = ...,
        touch_down_share: float = ...,
        touch_down_time: float = ...,
        touch_down_speed: float = ...,
        steps: StepsSettings | StepsSettingsDict = ...,
        footsteps: typing.Literal["tied", "absolute", "paper", "printed", "list"] | typing.Sequence[float] = ...,
        step_lengths: typing.Sequence[float] = ...,
        step_width: float = ...,
        foot_clearance: float = ...,
        foothold_reach: float = ...,
        foothold_time: float = ...,
        foothold_give: float = ...,
        foothold_freeze: float = ...,
        capture_reach: float = ...,
        capture_speed: float = ...,
        step_timing: bool = ...,
        step_ahead_most: float = ...,
        step_aside_most: float = ...,
        step_least_time: float = ...,
        step_wait_time: float = ...,
        swing: SwingSettings | SwingSettingsDict = ...,
        step_height: float = ...,
        swing_feed_forward: bool = ...,
        swing_kp: float = ...,
        swing_kd: float = ...,
        swing_ahead_acceleration: float = ...,
        swing_aside_acceleration: float = ...,
        com: ComSettings | ComSettingsDict = ...,
        com_state: typing.Literal["measured", "desired"] = ...,
        feed_forward: bool = ...,
        com_x_kp: float = ...,
        com_x_kd: float = ...,
        com_y_kp: float = ...,
        com_y_kd: float = ...,
        com_z_kp: float = ...,
        com_z_kd: float = ...,
        com_lead: float = ...,
        least_knee: float = ...,
        crouch_limit: float = ...,
        crouch_margin: float = ...,
        crouch_time: float = ...,
        zmp: ZmpSettings | ZmpSettingsDict = ...,
        zmp_modification: bool = ...,
        iteration: typing.Literal["closed_form", "loop", "none"] = ...,
        zmp_threshold: float = ...,
        max_iterations: int = ...,
        sole_fraction: float = ...,
        sole_exponent: float = ...,
        ankle_torque_fraction: float = ...,
        bound_lateral: bool = ...,
        lateral_law: typing.Literal["orbit", "paper"] = ...,
        lateral_reach: float = ...,
        whole_sole_fraction: float = ...,
        corner_cut: float = ...,
        tracking: TrackingSettings | TrackingSettingsDict = ...,
        tracker: typing.Literal["smooth", "bang_bang"] = ...,
        tracker_gain: float = ...,
        tracker_time: float = ...,
        tracker_reach: float = ...,
        tracker_deadband: float = ...,
        regain_from: float = ...,
        regain_gain: float = ...,
        regain_speed: float = ...,
        rate: RateSettings | RateSettingsDict = ...,
        rate_limit: bool = ...,
        forward_jump: float = ...,
        sideways_jump: float = ...,
        turning_jump: float = ...,
        forward_acceleration: float = ...,
        forward_deceleration: float = ...,
        sideways_acceleration: float = ...,
        turning_acceleration: float = ...,
        trunk: TrunkSettings | TrunkSettingsDict = ...,
        trunk_kp: float = ...,
        trunk_kd: float = ...,
        trunk_yields: bool = ...,
        posture: PostureSettings | PostureSettingsDict = ...,
        posture_task: bool = ...,
        posture_kp: float = ...,
        posture_kd: float = ...,
        motion_blend: float = ...,
        arms: ArmsSettings | ArmsSettingsDict = ...,
        momentum_arms: float = ...,
        momentum_kp: float = ...,
        momentum_kd: float = ...,
        arms_reserve: float = ...,
        arms_reserve_time: float = ...,
        contact: ContactSettings | ContactSettingsDict = ...,
        wrench_distribution: bool = ...,
        load_alone: float = ...,
        contact_damping: float = ...,
        control: ControlSettings | ControlSettingsDict = ...,
        control_dt: float = ...,
        textbook: bool = ...,
        singular_damping: float = ...,
        singular_pivot: float = ...,
        singular_task: float = ...,
        friction_velocity: float = ...,
        kernel: str = ...,
        torque_limits: typing.Mapping[str, float] = ...,
        limits: LimitsSettings | LimitsSettingsDict = ...,
        keep_limits: bool = ...,
        friction: float = ...,
        feel_slip: bool = ...,
        twist_share: float = ...,
        range_margin: float = ...,
        range_rate: float = ...,
        observer: ObserverSettings | ObserverSettingsDict = ...,
        disturbance_observer: bool = ...,
        observer_time: float = ...,
        observer_speed_noise: float = ...,
        observer_tolerance: float = ...,
        observer_force_most: float = ...,
        observer_weight_most: float = ...,
        observer_push: float = ...,
        attitude_time: float = ...,
        attitude_noise: float = ...,
        attitude_bias_time: float = ...,
        attitude_bias_most: float = ...,
        attitude_sole_tilt: float = ...,
        command: CommandSettings | CommandSettingsDict = ...,
        command_limit: bool = ...,
        command_share: float = ...,
        fall: FallSettings | FallSettingsDict = ...,
        fall_height: float = ...,
        fall_tilt: float = ...,
        fall_foot_tilt: float = ...,
        fall_foresee: bool = ...,
        fall_crouch: bool = ...,
        fall_margin: float = ...,
        fall_confirm_time: float = ...,
    ) -> None:
        """Every gain, bound and switch of the walk, in groups: `settings.tracking.gain`.

        Each setting has one word as well (in brackets below, where it is not the name itself), which does the same as
        keyword, as attribute and in files. NaN means 'from the robot': WalkingController fills it in. Defaults scale
        with the height z_c of the COM over the soles at the start, with gravity g, and with T_c = sqrt(z_c / g), the
        time constant in which the robot would fall over.

        Args:
            law: preset, 'default' or 'paper' (the literal law of the paper).
            gait: When a foot is lifted and set down, and when the robot stands. A dict, or GaitSettings.
                T_ds: Double support time of a step: how long both feet stand between two swings. Unit: s. Default: 0.2 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m).
                T_ss: Single support time of a step: how long one foot is in the air. Unit: s. Default: 0.8 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m).
                T_ds_first: Length of the first double support, in which the COM leaves its rest. With the default its sway is the steady one from the first step on. Unit: s. Default: the time in which a COM at rest takes up the sway of the steady walk.
                first_swing: Foot that takes the first step. One of 'right', 'left'. Default: 'right'.
                cadence_speed: Speed up to which every step takes T_ss + T_ds, and a faster walk takes longer steps. Above it the steps come faster as well. Unit: m/s. Default: 0.1 sqrt(g z_c).
                cadence_exponent: How much faster steps come above cadence_speed: a step takes (cadence_speed / speed)^cadence_exponent of T_ss + T_ds. With 0 all steps take the same time. Default: 0.4, or 0 where a list sets the lengths of the steps.
                cadence_double: How much the double support's share of a step shrinks above cadence_speed: as (cadence_speed / speed)^cadence_double. With 0 the share stays. Default: 0.5.
                cadence_sideways: Weight of the sideways velocity in the speed that is compared with cadence_speed: 1 m/s sideways counts as this many m/s forward. Default: 3.0.
                cadence_turning: Weight of turning in the speed that is compared with cadence_speed: 1 rad/s counts as this many m/s forward. Unit: m/rad. Default: 0.54 z_c.
                stand: Whether the robot stands still, feet side by side, while the planned velocity is zero. With false it steps on the spot. Default: True.
                stand_gain: How hard a standing robot is brought back over the middle between its feet: the ZMP goes beyond the DCM (COM + T_c times its velocity) by this many times the DCM's distance from the middle. Default: 1.0.
                closing_distance (closing_reach): A walk ends with a step that sets the foot beside the other one. That step is taken once the DCM (COM + T_c times its velocity) will be this near to the standing foot at its end. Unit: m. Default: 0.1 z_c.
                closing_turn: A walk ends with a step that sets the foot beside the other one. That step is taken only where the headings of the path and of the standing foot differ by no more than this. Unit: rad. Default: 0.05.
                touch_down: What ends a step. 'felt': by time, but a foot that meets the ground well before its time stays there, and once feet have found the ground uneven it is felt for; then height and swing follow the ground. 'time' alone; or 'contact': each step ends when the swing foot is felt to touch. A foot whose contact is not known, or was never felt, ends its step by time. One of 'felt', 'time', 'contact'. Default: 'felt'.
                touch_down_share: Share of the single support before which a contact of the swing foot does not end the step: a foot that has just lifted may scuff the ground. Not where touch_down is 'time'. Default: 0.5.
                touch_down_time: How long a swing foot that meets no ground at its planned time goes on down, until the step ends by time. Not where touch_down is 'time'. Unit: s. Default: 0.18 T_c.
                touch_down_speed: Speed at which a swing foot comes down onto the ground where touch_down is 'contact', and on ground that has been felt to be uneven. A foot that meets none at its planned time goes on at this speed, ever slower: within touch_down_time by two thirds of touch_down_speed times touch_down_time. By time, a foot lands at rest. Unit: m/s. Default: 0.037 sqrt(g z_c).
            steps: Where the feet are set down. A dict, or StepsSettings.
                mode (footsteps): What decides where a foot lands: 'tied' follows the COM, which keeps the walk balanced; 'absolute' takes the places of the plan; 'paper' and 'printed' take the step lengths of section IV, corrected and as printed; 'list' takes steps.lengths. Python and files take a list of lengths here as well. One of 'tied', 'absolute', 'paper', 'printed', 'list'. Default: 'tied'.
                lengths (step_lengths): How far each step lands ahead of the standing foot, one number per step; the last one repeats. Tied footsteps do not use it. Unit: m. Default: [].
                width (step_width): Distance of the two feet from each other, sideways. Unit: m. Default: as the feet stand at the start.
                clearance (foot_clearance): Least gap that a step leaves between the edges of the two feet, sideways. Unit: m. Default: 0.03 z_c.
                shift (foothold_reach): How far a tied foothold moves from its nominal place to keep the robot balanced, whatever the foot in the air does. A longer way, and any way of a robot that has been pushed, is bounded by the reach of the leg and by where the foot in the air can still get to. Unit: m. Default: 0.25 z_c.
                filter_time (foothold_time): Time constant of the low-pass through which a tied foothold moves while the foot is in the air. Unit: s. Default: 0.18 T_c.
                give (foothold_give): A COM that is faster or slower than planned needs another foothold or another ZMP. Up to this share of its bounds the ZMP over the next foot makes up for it; only the rest moves a tied foothold. With 0 each long step would be followed by a short one. Default: 0.3.
                freeze (foothold_freeze): Share of the single support after which a tied foothold stays where it is, so that the foot lands calmly. Default: 0.7.
                capture_distance (capture_reach): How far the DCM (COM + T_c times its velocity) may be from its planned place when the next foot takes over, with tied footsteps. Beyond that, or where the ZMP over that foot could not hold it, the tracked speed yields, so that the next step still catches the robot. Unit: m. Default: 0.07 z_c.
                capture_speed: Most that the tracked speed yields, either way, to keep the DCM within capture_distance of its plan. Unit: m/s. Default: 0.2 sqrt(g z_c).
                timing (step_timing): Whether a robot that has been pushed changes the time of its step, uses the whole sole, and steps out of a stand to catch itself. Only with tied footsteps. Default: True.
                ahead_most (step_ahead_most): How far ahead of the standing foot, or behind it, a foot may be set down to catch the robot. Unit: m. Default: 0.6 z_c.
                aside_most (step_aside_most): How far beside the standing foot a foot may be set down to catch the robot. Unit: m. Default: 0.67 z_c.
                least_time (step_least_time): Shortest single support of a step that catches the robot. Unit: s. Default: 1.1 T_c.
                wait_time (step_wait_time): How much longer than planned a foot may stay in the air, while the ZMP brings the DCM (COM + T_c times its velocity) back over the standing foot. Unit: s. Default: 3 T_c.
            swing: How the foot in the air moves. A dict, or SwingSettings.
                height (step_height): Height to which a step lifts the foot. Unit: m. Default: 0.0535 z_c, or less (down to 0.01 z_c) where the knee's rotor and damping would take over 0.6 of its torque at the walk's top speed.
                feed_forward (swing_feed_forward): Whether the acceleration of the planned swing is added to that which corrects the foot's error. Without it the foot lags behind its path. Default: True.
                kp (swing_kp): Stiffness with which the foot in the air is held on its path: acceleration per error, in position and orientation. Unit: 1/s^2. Default: 3600 (0.276 s / T_c)^2.
                kd (swing_kd): Damping with which the foot in the air is held on its path: acceleration per velocity error, in position and orientation. Unit: 1/s. Default: 120 (0.276 s / T_c).
                ahead_acceleration (swing_ahead_acceleration): Acceleration, forward or backward, that a foothold may ask of the foot in the air beyond its way by itself. More would turn the standing foot on the ground, and push the COM the other way. Unit: m/s^2. Default: 1.5 g.
                aside_acceleration (swing_aside_acceleration): Acceleration, sideways, that a foothold may ask of the foot in the air beyond its way by itself. Unit: m/s^2. Default: 4 g.
            com: How the centre of mass (COM) is moved: forward, sideways and in height. A dict, or ComSettings.
                state (com_state): What counts as the COM's current state in the pendulum (16), (17): the 'measured' one, or the one that was 'desired' in the cycle before. One of 'measured', 'desired'. Default: 'measured'.
                feed_forward: Whether the pendulum's acceleration is added to the COM's commanded acceleration (8). Without it the COM is one cycle late and takes stiffer gains. Default: True.
                kp_x (com_x_kp): Stiffness of the COM's motion forward: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2.
                kd_x (com_x_kd): Damping of the COM's motion forward: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c).
                kp_y (com_y_kp): Stiffness of the COM's motion sideways: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2.
                kd_y (com_y_kd): Damping of the COM's motion sideways: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c).
                kp_z (com_z_kp): Stiffness of the COM's height: acceleration per position error in (8). Unit: 1/s^2. Default: 200 (0.276 s / T_c)^2.
                kd_z (com_z_kd): Damping of the COM's height: acceleration per velocity error in (8). Unit: 1/s. Default: 28 (0.276 s / T_c).
                lead (com_lead): How far the COM rides ahead of the middle between the feet, with tied footsteps. So a foot that has just landed is not loaded on its heel, where the contact settles slowly. Unit: m. Default: 0.0134 z_c.
                least_knee: Smallest knee angle that the plan allows, so that no leg becomes straight. It leaves room for what the plan does not know: swing leg and pelvis move the hips against the COM. Unit: rad. Default: 0.3.
                crouch_limit: How far the COM may come down so that the legs reach far enough for long steps. Unit: m. Default: 0.1 z_c.
                crouch_margin: For long steps the COM comes down until the legs reach this many times as far as the feet are from under the hips in double support. Default: 1.2.
                crouch_time: Time constant with which the COM comes down for long steps and rises after them. Unit: s. Default: 0.5 T_c.
            zmp: Where the ZMP may be, and how the reference ZMP is found that puts it there (III-B, III-D). A dict, or ZmpSettings.
                modification (zmp_modification): Whether the estimated ZMP is kept inside its bounds (III-B, III-C). With false the planned velocity is tracked blindly. Default: True.
                iteration: How the reference ZMP is found that puts the estimated ZMP where it is desired: in 'closed_form', or by the 'loop' that III-B prints. With 'none' the pendulum's ZMP is taken as it is, and the estimate changes nothing. One of 'closed_form', 'loop', 'none'. Default: 'closed_form'.
                threshold (zmp_threshold): The reference ZMP is good enough once the estimated ZMP is this near to the desired one (section IV). Unit: m. Default: 0.001.
                max_iterations: Most passes of the loop of III-B in one control cycle, which then goes on with what it has. Default: 200.
                sole_fraction: Share of the sole's length and width that the ZMP may use. The rest is a margin: a foot whose ZMP is at its edge tips. Default: 0.72.
                sole_exponent: How much less of the sole's length the ZMP uses above cadence_speed: (cadence_speed / speed)^sole_exponent of it. At the sole's ends the contact of a fast walk chatters. Default: 0.5.
                ankle_torque_fraction: Share of an ankle's torque limit that may hold the ZMP away from the ankle. Where ankles are weak this, not the sole, bounds the ZMP. Default: 0.9.
                bound_lateral: Whether the ZMP is kept inside its bounds sideways too. The paper bounds it forward only. Default: True.
                lateral_law: Law by which the reference ZMP is shifted sideways from the middle of the sole that carries it (III-D). One of 'orbit', which shifts it so that the sway repeats; 'paper', which leaves it in the middle, so that an error at the start never decays. Default: 'orbit'.
                lateral_shift (lateral_reach): Largest sideways shift of the reference ZMP that the lateral law may ask for, as a share of half the sole's width. Default: 1.6.
                whole_fraction (whole_sole_fraction): Share of the sole's length and width that the ZMP may use when the robot has been pushed. It takes the place of sole_fraction as the DCM (COM + T_c times its velocity) leaves its plan. Default: 0.95.
                corner_cut: Share of the sole's length that the ZMP gives up where it is at the sole's side: in a corner of the sole it would tip the foot. Default: 0.3.
            tracking: How the walk follows the planned velocity (III-C). A dict, or TrackingSettings.
                law (tracker): Law by which the COM's velocity follows the planned one. One of 'smooth', which accelerates in proportion to the error; 'bang_bang', which drives the ZMP to its bounds until the error is gone, as III-C is printed. Default: 'smooth'.
                gain (tracker_gain): How fast the smooth law makes up lost way: speed that it adds per metre behind the plan. Unit: 1/s. Default: 1.38 / T_c.
                time (tracker_time): Time constant with which the smooth law removes an error of the speed. Unit: s. Default: 0.18 T_c.
                catch_up_speed (tracker_reach): Largest speed that the smooth law adds or takes away to make up lost or gained way. Feet cannot make up a long way in one step. Unit: m/s. Default: 0.03 sqrt(g z_c).
                deadband (tracker_deadband): How far the COM may be ahead of its plan or behind it before the bang-bang law drives it back. A drive ends a little beyond the plan, since time is discrete; without a deadband that would start the next drive. Unit: m. Default: 0.0002.
                regain_from: How far the COM must be behind its plan, or ahead of it, before steps become longer or shorter to make up for it. A push can cost half a metre. Only with tied footsteps. Unit: m. Default: 0.08 z_c.
                regain_gain: Speed that those steps add per metre beyond regain_from. Unit: 1/s. Default: 0.14 / T_c.
                regain_speed: Largest speed that those steps add or take away. Unit: m/s. Default: 0.045 sqrt(g z_c).
            rate: How fast the planned velocity may change, whatever a profile or command asks for at once. A dict, or RateSettings.
                limit (rate_limit): Whether the planned velocity changes no faster than steps can follow. With false profiles and commands are taken as they are. Default: True.
                forward_jump: Change of the forward velocity v_x that is taken up at once. A larger one follows at forward_acceleration or forward_deceleration. Unit: m/s. Default: 0.036 sqrt(g z_c).
                sideways_jump: Change of the sideways velocity v_y that is taken up at once. A larger one follows at sideways_acceleration. Unit: m/s. Default: 0.0.
                turning_jump: Change of the turning velocity w_z that is taken up at once. A larger one follows at turning_acceleration. Unit: rad/s. Default: 0.07 / T_c.
                forward_acceleration: Rate at which the forward velocity v_x moves away from zero. Unit: m/s^2. Default: 0.02 g.
                forward_deceleration: Rate at which the forward velocity v_x goes back to zero. Unit: m/s^2. Default: 0.056 g.
                sideways_acceleration: Rate at which the sideways velocity v_y changes. Unit: m/s^2. Default: 0.025 g.
                turning_acceleration: Rate at which the turning velocity w_z changes. Unit: rad/s^2. Default: 0.08 / T_c^2.
            trunk: How the trunk is kept upright and along the path. A dict, or TrunkSettings.
                kp (trunk_kp): Stiffness of the trunk's orientation: angular acceleration per angle of error. Unit: 1/s^2. Default: 300 (0.276 s / T_c)^2.
                kd (trunk_kd): Damping of the trunk's orientation: angular acceleration per error of angular velocity. Unit: 1/s. Default: 35 (0.276 s / T_c).
                yields (trunk_yields): Whether the trunk of a robot that has been pushed comes back upright slowly. A trunk that is held stiffly takes the ZMP away from where it would hold the DCM (COM + T_c times its velocity), and turns the standing foot. Default: True.
            posture: How the joints outside the legs (waist, arms, head) are moved. A dict, or PostureSettings.
                task (posture_task): Whether the joints outside the legs are controlled. With false their motion is left to the torque of least norm. Default: True.
                kp (posture_kp): Stiffness of the joints outside the legs: acceleration per angle of error. Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2.
                kd (posture_kd): Damping of the joints outside the legs: acceleration per error of joint velocity. Unit: 1/s. Default: 20 (0.276 s / T_c).
                motion_blend: Time in which a new joint motion takes over from the one before it. Unit: s. Default: 1.8 T_c.
            arms: How the arms swing so that the robot does not turn about the vertical. A dict, or ArmsSettings.
                momentum (momentum_arms): Share of the yaw momentum of legs and trunk that the arms cancel by swinging, 0 to 1. Joints that a motion names do not swing. Default: 0.0.
                kp (momentum_kp): Stiffness of the spring that brings swinging arms back to their posture: acceleration per angle. Unit: 1/s^2. Default: 20 (0.276 s / T_c)^2.
                kd (momentum_kd): Rate at which swinging arms bring the robot's yaw momentum to zero. Unit: 1/s. Default: 20 (0.276 s / T_c).
                reserve (arms_reserve): Share of the yaw momentum that the arms cancel, where this is more than momentum, while the yaw friction of a sole holds the torque back, so that the foot does not spin. With 0 they never help. Default: 1.0.
                reserve_time (arms_reserve_time): Time in which the arms return to their posture once the soles hold the yaw moment again. They come to help in a tenth of it. Unit: s. Default: 2 T_c.
            contact: How the feet that stand carry the robot. A dict, or ContactSettings.
                wrench_distribution: Whether two standing feet share the load by the place of the ZMP between them. With false the torque of least norm decides, which ignores that feet cannot pull. Default: True.
                load_alone: In double support one foot carries everything while the ZMP is this near to its centre line, in half sole widths. A foot that has just landed would chatter under a light load. Default: 0.7.
                damping (contact_damping): Damping of the velocity of a standing foot that does not carry the ZMP. Without a load it would drift off the ground. Unit: 1/s. Default: 100.0.
            control: How the torque is computed, how often, and within which limits. A dict, or ControlSettings.
                dt (control_dt): Control period: a new torque is computed this often and held in between. It must be a multiple of the model's time step. Unit: s. Default: the model's time step.
                textbook: Whether equations (1) to (13) are computed as printed instead of on the direct path. It is slower and gives the same numbers. Default: False.
                singular_damping: Damping that keeps the joints' motion bounded where a leg is straight. Default: 0.001.
                singular_pivot: Smallest pivot of a leg's equations below which that leg counts as straight. Default: 0.01.
                singular_task: How far a task of your own may be from impossible before it is met in part only: the motion that it asks for is damped in directions in which the joints outside the legs move it by less than this share of its size. So it stays bounded where an arm is stretched out. With 0 nothing is damped. Default: 0.005.
                friction_velocity: Joint speed below which dry friction is taken as proportional to the speed, so that it does not jump where a joint turns around. Unit: rad/s. Default: 0.02.
                kernel: Build of the inner loops: 'auto' takes the best that this processor runs, and build_info()['kernels'] names those that there are. They agree to rounding. Default: 'auto'.
                torque_limits: Torque limits by joint name, in place of the robot's own. A motor still gives no more than the model lets through. Unit: N m. Default: {}.
            limits: What a torque must keep to: the joints' torques and ranges, and what the soles can hold. A dict, or LimitsSettings.
                keep (keep_limits): Whether the nearest torque that keeps the limits is found where the closed form's torque would break one: the tasks give way, first the swing foot, then the trunk, the COM's height, and last its horizontal acceleration. With false torques are cut to their limits, and nothing else is kept. Default: True.
                friction: Friction of the soles: tangential force per normal force that they can hold. Default: that of the soles in the model.
                feel_slip: Whether a sole that slides while it carries lowers the friction that is believed, and with it the planned speed. With true the robot walks on over ice; but soles that slide a little as they land, as they do where the measured attitude is off by 2 degrees, pass for slipping ones, and it slows down. Default: False.
                twist (twist_share): Moment about the vertical that a sole may give, as a share of what its friction holds while it turns about its centre. With more than 1 the foot turns a little where it must. Default: 1.0.
                range_margin: How far from the ends of its range a joint comes to rest. Unit: rad. Default: 0.0.
                range_rate: How fast a joint may still move towards the end of its range: it comes to rest there as a critically damped joint of this damping does. A small rate brakes early. Unit: 1/s. Default: 120 (0.276 s / T_c).
            observer: What the controller finds out about what it does not know: steady forces, wrong masses, a biased attitude, noise. A dict, or ObserverSettings.
                on (disturbance_observer): Whether the walk makes up for steady forces, wrong masses, and noise or bias of the measured attitude. A walk that knows everything keeps its bits. Default: True.
                time (observer_time): Time constant with which a disturbance is found: an acceleration of the COM that the command does not explain. Where the measured speed is noisy, it grows up to four times. Unit: s. Default: 0.18 T_c.
                speed_noise (observer_speed_noise): Change of the COM's speed from cycle to cycle that the command does not explain, as root of its mean square, up to which the speed counts as measured without noise. Unit: m/s. Default: 0.0092 sqrt(g z_c).
                tolerance (observer_tolerance): A disturbance is made up for where it is larger than this, and less by this: contacts that give way a little are none. Unit: m/s^2. Default: 0.015 g.
                force_most (observer_force_most): Most that is made up for of a steady horizontal disturbance, along either axis. Unit: m/s^2. Default: 0.13 g.
                weight_most (observer_weight_most): Most that the robot is taken to be heavier or lighter than its model says, as a share of its mass. Default: 0.35.
                push (observer_push): A horizontal disturbance that is larger than this is a push and not steady: what was found before it is held. Unit: m/s^2. Default: 0.16 g.
                attitude_time: Time constant with which a noisy attitude of the base corrects the one that its angular velocity leads to. Unit: s. Default: 1.1 T_c.
                attitude_noise: Angle between the measured attitude and the one that the angular velocity leads to from the cycle before, as root of its mean square, up to which the attitude is taken as it is measured. Unit: rad. Default: 0.001.
                bias_time (attitude_bias_time): Time constant with which a bias of the measured attitude is found. Unit: s. Default: 1.8 T_c.
                bias_most (attitude_bias_most): Most that is made up for of a bias of the measured attitude. Unit: rad. Default: 0.09.
                sole_tilt (attitude_sole_tilt): Tilt of the standing sole from level that shows no bias yet: contacts give way a little. Unit: rad. Default: 0.004.
            command: Which velocities may be commanded. A dict, or CommandSettings.
                limit (command_limit): Whether commands and profiles are kept within what the torques of the legs and the friction under the soles give. With false only the reach of the legs limits them. Default: True.
                share (command_share): Share of those torques and that friction that a commanded velocity may use. More than 1 allows faster walks, which cut torques and slide. Default: 1.0.
            fall: What counts as a fall, when one is foreseen, and what the robot does then. A dict, or FallSettings.
                height (fall_height): The robot has fallen where its COM is less high over the support foot than this share of its height at the start. Default: 0.8.
                tilt (fall_tilt): The robot has fallen where its trunk tilts by more than this. Unit: rad. Default: 0.8.
                foot_tilt (fall_foot_tilt): A fall is foreseen where the only foot that stands tilts by more than this, as it tips over its edge. Unit: rad. Default: 0.45.
                foresee (fall_foresee): Whether a fall is foreseen: it is certain once no foothold within reach, and no time of landing, can catch the DCM (COM + T_c times its velocity) any more. Default: True.
                crouch (fall_crouch): Whether the robot crouches once a fall is foreseen: the legs bend and every joint is damped, until the walk is started anew. With false it walks on as if nothing were foreseen. Default: True.
                margin (fall_margin): How far the DCM must be beyond what any foothold within reach can catch before the fall counts as certain. Trunk, arms and what the pendulum does not know may bring back that much. Unit: m. Default: 0.03 z_c.
                confirm_time (fall_confirm_time): How long the DCM must be that far off without a break before the fall counts as certain: a noisy measurement alone fells nobody. Unit: s. Default: 0.04 T_c.

        Raises:
            InputError: an unknown name or a value of the wrong type.

        Usage:
            >>> WalkSettings(law='paper', steps={'mode': 'absolute', 'width': 0.2}, tracker_gain=4.0)
        """
    def update(
        self,
        *,
        gait: GaitSettings | GaitSettingsDict = ...,
        T_ds: float = ...,
        T_ss: float = ...,
        T_ds_first: float = ...,
        first_swing: typing.Literal["right", "left"] = ...,
        cadence_speed: float = ...,
        cadence_exponent: float = ...,
        cadence_double: float = ...,
        cadence_sideways: float = ...,
        cadence_turning: float = ...,
        stand: bool = ...,
        stand_gain: float = ...,
        closing_reach: float = ...,
        closing_turn: float = ...,
        touch_down: typing.Literal["felt", "time", "contact"] = ...,
        touch_down_share: float = ...,
        touch_down_time: float = ...,
        touch_down_speed: float = ...,
        steps: StepsSettings | StepsSettingsDict = ...,
        footsteps: typing.Literal["tied", "absolute", "paper", "printed", "list"] | typing.Sequence[float] = ...,
        step_lengths: typing.Sequence[float] = ...,
        step_width: float = ...,
        foot_clearance: float = ...,
        foothold_reach: float = ...,
        foothold_time: float = ...,
        foothold_give: float = ...,
        foothold_freeze: float = ...,
        capture_reach: float = ...,
        capture_speed: float = ...,
        step_timing: bool = ...,
        step_ahead_most: float = ...,
        step_aside_most: float = ...,
        step_least_time: float = ...,
        step_wait_time: float = ...,
        swing: SwingSettings | SwingSettingsDict = ...,
        step_height: float = ...,
        swing_feed_forward: bool = ...,
        swing_kp: float = ...,
        swing_kd: float = ...,
        swing_ahead_acceleration: float = ...,
        swing_aside_acceleration: float = ...,
        com: ComSettings | ComSettingsDict = ...,
        com_state: typing.Literal["measured", "desired"] = ...,
        feed_forward: bool = ...,
        com_x_kp: float = ...,
        com_x_kd: float = ...,
        com_y_kp: float = ...,
        com_y_kd: float = ...,
        com_z_kp: float = ...,
        com_z_kd: float = ...,
        com_lead: float = ...,
        least_knee: float = ...,
        crouch_limit: float = ...,
        crouch_margin: float = ...,
        crouch_time: float = ...,
        zmp: ZmpSettings | ZmpSettingsDict = ...,
        zmp_modification: bool = ...,
        iteration: typing.Literal["closed_form", "loop", "none"] = ...,
        zmp_threshold: float = ...,
        max_iterations: int = ...,
        sole_fraction: float = ...,
        sole_exponent: float = ...,
        ankle_torque_fraction: float = ...,
        bound_lateral: bool = ...,
        lateral_law: typing.Literal["orbit", "paper"] = ...,
        lateral_reach: float = ...,
        whole_sole_fraction: float = ...,
        corner_cut: float = ...,
        tracking: TrackingSettings | TrackingSettingsDict = ...,
        tracker: typing.Literal["smooth", "bang_bang"] = ...,
        tracker_gain: float = ...,
        tracker_time: float = ...,
        tracker_reach: float = ...,
        tracker_deadband: float = ...,
        regain_from: float = ...,
        regain_gain: float = ...,
        regain_speed: float = ...,
        rate: RateSettings | RateSettingsDict = ...,
        rate_limit: bool = ...,
        forward_jump: float = ...,
        sideways_jump: float = ...,
        turning_jump: float = ...,
        forward_acceleration: float = ...,
        forward_deceleration: float = ...,
        sideways_acceleration: float = ...,
        turning_acceleration: float = ...,
        trunk: TrunkSettings | TrunkSettingsDict = ...,
        trunk_kp: float = ...,
        trunk_kd: float = ...,
        trunk_yields: bool = ...,
        posture: PostureSettings | PostureSettingsDict = ...,
        posture_task: bool = ...,
        posture_kp: float = ...,
        posture_kd: float = ...,
        motion_blend: float = ...,
        arms: ArmsSettings | ArmsSettingsDict = ...,
        momentum_arms: float = ...,
        momentum_kp: float = ...,
        momentum_kd: float = ...,
        arms_reserve: float = ...,
        arms_reserve_time: float = ...,
        contact: ContactSettings | ContactSettingsDict = ...,
        wrench_distribution: bool = ...,
        load_alone: float = ...,
        contact_damping: float = ...,
        control: ControlSettings | ControlSettingsDict = ...,
        control_dt: float = ...,
        textbook: bool = ...,
        singular_damping: float = ...,
        singular_pivot: float = ...,
        singular_task: float = ...,
        friction_velocity: float = ...,
        kernel: str = ...,
        torque_limits: typing.Mapping[str, float] = ...,
        limits: LimitsSettings | LimitsSettingsDict = ...,
        keep_limits: bool = ...,
        friction: float = ...,
        feel_slip: bool = ...,
        twist_share: float = ...,
        range_margin: float = ...,
        range_rate: float = ...,
        observer: ObserverSettings | ObserverSettingsDict = ...,
        disturbance_observer: bool = ...,
        observer_time: float = ...,
        observer_speed_noise: float = ...,
        observer_tolerance: float = ...,
        observer_force_most: float = ...,
        observer_weight_most: float = ...,
        observer_push: float = ...,
        attitude_time: float = ...,
        attitude_noise: float = ...,
        attitude_bias_time: float = ...,
        attitude_bias_most: float = ...,
        attitude_sole_tilt: float = ...,
        command: CommandSettings | CommandSettingsDict = ...,
        command_limit: bool = ...,
        command_share: float = ...,
        fall: FallSettings | FallSettingsDict = ...,
        fall_height: float = ...,
        fall_tilt: float = ...,
        fall_foot_tilt: float = ...,
        fall_foresee: bool = ...,
        fall_crouch: bool = ...,
        fall_margin: float = ...,
        fall_confirm_time: float = ...,
    ) -> None:
        """Changes settings, named as in the constructor: all of them or, if one is refused, none.

        Raises:
            InputError: an unknown name or a value of the wrong type.

        Usage: `settings.update(tracking={'gain': 3.0}, T_ss=0.6)`
        """
    @staticmethod
    def table() -> dict[str, Setting]:
        """Every setting, as a `Setting` by its path such as 'tracking.gain'."""
    @property
    def gait(self) -> GaitSettings:
        """When a foot is lifted and set down, and when the robot stands."""
    @gait.setter
    def gait(self, value: GaitSettings | GaitSettingsDict) -> None: ...
    @property
    def steps(self) -> StepsSettings:
        """Where the feet are set down."""
    @steps.setter
    def steps(self, value: StepsSettings | StepsSettingsDict) -> None: ...
    @property
    def swing(self) -> SwingSettings:
        """How the foot in the air moves."""
    @swing.setter
    def swing(self, value: SwingSettings | SwingSettingsDict) -> None: ...
    @property
    def com(self) -> ComSettings:
        """How the centre of mass (COM) is moved: forward, sideways and in height."""
    @com.setter
    def com(self, value: ComSettings | ComSettingsDict) -> None: ...
    @property
    def zmp(self) -> ZmpSettings:
        """Where the ZMP may be, and how the reference ZMP is found that puts it there (III-B, III-D)."""
    @zmp.setter
    def zmp(self, value: ZmpSettings | ZmpSettingsDict) -> None: ...
    @property
    def tracking(self) -> TrackingSettings:
        """How the walk follows the planned velocity (III-C)."""
    @tracking.setter
    def tracking(self, value: TrackingSettings | TrackingSettingsDict) -> None: ...
    @property
    def rate(self) -> RateSettings:
        """How fast the planned velocity may change, whatever a profile or command asks for at once."""
    @rate.setter
    def rate(self, value: RateSettings | RateSettingsDict) -> None: ...
    @property
    def trunk(self) -> TrunkSettings:
        """How the trunk is kept upright and along the path."""
    @trunk.setter
    def trunk(self, value: TrunkSettings | TrunkSettingsDict) -> None: ...
    @property
    def posture(self) -> PostureSettings:
        """How the joints outside the legs (waist, arms, head) are moved."""
    @posture.setter
    def posture(self, value: PostureSettings | PostureSettingsDict) -> None: ...
    @property
    def arms(self) -> ArmsSettings:
        """How the arms swing so that the robot does not turn about the vertical."""
    @arms.setter
    def arms(self, value: ArmsSettings | ArmsSettingsDict) -> None: ...
    @property
    def contact(self) -> ContactSettings:
        """How the feet that stand carry the robot."""
    @contact.setter
    def contact(self, value: ContactSettings | ContactSettingsDict) -> None: ...
    @property
    def control(self) -> ControlSettings:
        """How the torque is computed, how often, and within which limits."""
    @control.setter
    def control(self, value: ControlSettings | ControlSettingsDict) -> None: ...
    @property
    def limits(self) -> LimitsSettings:
        """What a torque must keep to: the joints' torques and ranges, and what the soles can hold."""
    @limits.setter
    def limits(self, value: LimitsSettings | LimitsSettingsDict) -> None: ...
    @property
    def observer(self) -> ObserverSettings:
        """What the controller finds out about what it does not know: steady forces, wrong masses, a biased attitude, noise."""
    @observer.setter
    def observer(self, value: ObserverSettings | ObserverSettingsDict) -> None: ...
    @property
    def command(self) -> CommandSettings:
        """Which velocities may be commanded."""
    @command.setter
    def command(self, value: CommandSettings | CommandSettingsDict) -> None: ...
    @property
    def fall(self) -> FallSettings:
        """What counts as a fall, when one is foreseen, and what the robot does then."""
    @fall.setter
    def fall(self, value: FallSettings | FallSettingsDict) -> None: ...
    @property
    def T_ds(self) -> float:
        """gait.T_ds: Double support time of a step: how long both feet stand between two swings. Unit: s. Default: 0.2 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m)."""
    @T_ds.setter
    def T_ds(self, value: float) -> None: ...
    @property
    def T_ss(self) -> float:
        """gait.T_ss: Single support time of a step: how long one foot is in the air. Unit: s. Default: 0.8 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m)."""
    @T_ss.setter
    def T_ss(self, value: float) -> None: ...
    @property
    def T_ds_first(self) -> float:
        """gait.T_ds_first: Length of the first double support, in which the COM leaves its rest. With the default its sway is the steady one from the first step on. Unit: s. Default: the time in which a COM at rest takes up the sway of the steady walk."""
    @T_ds_first.setter
    def T_ds_first(self, value: float) -> None: ...
    @property
    def first_swing(self) -> typing.Literal["right", "left"]:
        """gait.first_swing: Foot that takes the first step. One of 'right', 'left'. Default: 'right'."""
    @first_swing.setter
    def first_swing(self, value: typing.Literal["right", "left"]) -> None: ...
    @property
    def cadence_speed(self) -> float:
        """gait.cadence_speed: Speed up to which every step takes T_ss + T_ds, and a faster walk takes longer steps. Above it the steps come faster as well. Unit: m/s. Default: 0.1 sqrt(g z_c)."""
    @cadence_speed.setter
    def cadence_speed(self, value: float) -> None: ...
    @property
    def cadence_exponent(self) -> float:
        """gait.cadence_exponent: How much faster steps come above cadence_speed: a step takes (cadence_speed / speed)^cadence_exponent of T_ss + T_ds. With 0 all steps take the same time. Default: 0.4, or 0 where a list sets the lengths of the steps."""
    @cadence_exponent.setter
    def cadence_exponent(self, value: float) -> None: ...
    @property
    def cadence_double(self) -> float:
        """gait.cadence_double: How much the double support's share of a step shrinks above cadence_speed: as (cadence_speed / speed)^cadence_double. With 0 the share stays. Default: 0.5."""
    @cadence_double.setter
    def cadence_double(self, value: float) -> None: ...
    @property
    def cadence_sideways(self) -> float:
        """gait.cadence_sideways: Weight of the sideways velocity in the speed that is compared with cadence_speed: 1 m/s sideways counts as this many m/s forward. Default: 3.0."""
    @cadence_sideways.setter
    def cadence_sideways(self, value: float) -> None: ...
    @property
    def cadence_turning(self) -> float:
        """gait.cadence_turning: Weight of turning in the speed that is compared with cadence_speed: 1 rad/s counts as this many m/s forward. Unit: m/rad. Default: 0.54 z_c."""
    @cadence_turning.setter
    def cadence_turning(self, value: float) -> None: ...
    @property
    def stand(self) -> bool:
        """gait.stand: Whether the robot stands still, feet side by side, while the planned velocity is zero. With false it steps on the spot. Default: True."""
    @stand.setter
    def stand(self, value: bool) -> None: ...
    @property
    def stand_gain(self) -> float:
        """gait.stand_gain: How hard a standing robot is brought back over the middle between its feet: the ZMP goes beyond the DCM (COM + T_c times its velocity) by this many times the DCM's distance from the middle. Default: 1.0."""
    @stand_gain.setter
    def stand_gain(self, value: float) -> None: ...
    @property
    def closing_reach(self) -> float:
        """gait.closing_distance: A walk ends with a step that sets the foot beside the other one. That step is taken once the DCM (COM + T_c times its velocity) will be this near to the standing foot at its end. Unit: m. Default: 0.1 z_c."""
    @closing_reach.setter
    def closing_reach(self, value: float) -> None: ...
    @property
    def closing_turn(self) -> float:
        """gait.closing_turn: A walk ends with a step that sets the foot beside the other one. That step is taken only where the headings of the path and of the standing foot differ by no more than this. Unit: rad. Default: 0.05."""
    @closing_turn.setter
    def closing_turn(self, value: float) -> None: ...
    @property
    def touch_down(self) -> typing.Literal["felt", "time", "contact"]:
        """gait.touch_down: What ends a step. 'felt': by time, but a foot that meets the ground well before its time stays there, and once feet have found the ground uneven it is felt for; then height and swing follow the ground. 'time' alone; or 'contact': each step ends when the swing foot is felt to touch. A foot whose contact is not known, or was never felt, ends its step by time. One of 'felt', 'time', 'contact'. Default: 'felt'."""
    @touch_down.setter
    def touch_down(self, value: typing.Literal["felt", "time", "contact"]) -> None: ...
    @property
    def touch_down_share(self) -> float:
        """gait.touch_down_share: Share of the single support before which a contact of the swing foot does not end the step: a foot that has just lifted may scuff the ground. Not where touch_down is 'time'. Default: 0.5."""
    @touch_down_share.setter
    def touch_down_share(self, value: float) -> None: ...
    @property
    def touch_down_time(self) -> float:
        """gait.touch_down_time: How long a swing foot that meets no ground at its planned time goes on down, until the step ends by time. Not where touch_down is 'time'. Unit: s. Default: 0.18 T_c."""
    @touch_down_time.setter
    def touch_down_time(self, value: float) -> None: ...
    @property
    def touch_down_speed(self) -> float:
        """gait.touch_down_speed: Speed at which a swing foot comes down onto the ground where touch_down is 'contact', and on ground that has been felt to be uneven. A foot that meets none at its planned time goes on at this speed, ever slower: within touch_down_time by two thirds of touch_down_speed times touch_down_time. By time, a foot lands at rest. Unit: m/s. Default: 0.037 sqrt(g z_c)."""
    @touch_down_speed.setter
    def touch_down_speed(self, value: float) -> None: ...
    @property
    def footsteps(self) -> typing.Literal["tied", "absolute", "paper", "printed", "list"]:
        """steps.mode: What decides where a foot lands: 'tied' follows the COM, which keeps the walk balanced; 'absolute' takes the places of the plan; 'paper' and 'printed' take the step lengths of section IV, corrected and as printed; 'list' takes steps.lengths. Python and files take a list of lengths here as well. One of 'tied', 'absolute', 'paper', 'printed', 'list'. Default: 'tied'."""
    @footsteps.setter
    def footsteps(
        self, value: typing.Literal["tied", "absolute", "paper", "printed", "list"] | typing.Sequence[float]
    ) -> None: ...
    @property
    def step_lengths(self) -> list[float]:
        """steps.lengths: How far each step lands ahead of the standing foot, one number per step; the last one repeats. Tied footsteps do not use it. Unit: m. Default: []."""
    @step_lengths.setter
    def step_lengths(self, value: typing.Sequence[float]) -> None: ...
    @property
    def step_width(self) -> float:
        """steps.width: Distance of the two feet from each other, sideways. Unit: m. Default: as the feet stand at the start."""
    @step_width.setter
    def step_width(self, value: float) -> None: ...
    @property
    def foot_clearance(self) -> float:
        """steps.clearance: Least gap that a step leaves between the edges of the two feet, sideways. Unit: m. Default: 0.03 z_c."""
    @foot_clearance.setter
    def foot_clearance(self, value: float) -> None: ...
    @property
    def foothold_reach(self) -> float:
        """steps.shift: How far a tied foothold moves from its nominal place to keep the robot balanced, whatever the foot in the air does. A longer way, and any way of a robot that has been pushed, is bounded by the reach of the leg and by where the foot in the air can still get to. Unit: m. Default: 0.25 z_c."""
    @foothold_reach.setter
    def foothold_reach(self, value: float) -> None: ...
    @property
    def foothold_time(self) -> float:
        """steps.filter_time: Time constant of the low-pass through which a tied foothold moves while the foot is in the air. Unit: s. Default: 0.18 T_c."""
    @foothold_time.setter
    def foothold_time(self, value: float) -> None: ...
    @property
    def foothold_give(self) -> float:
        """steps.give: A COM that is faster or slower than planned needs another foothold or another ZMP. Up to this share of its bounds the ZMP over the next foot makes up for it; only the rest moves a tied foothold. With 0 each long step would be followed by a short one. Default: 0.3."""
    @foothold_give.setter
    def foothold_give(self, value: float) -> None: ...
    @property
    def foothold_freeze(self) -> float:
        """steps.freeze: Share of the single support after which a tied foothold stays where it is, so that the foot lands calmly. Default: 0.7."""
    @foothold_freeze.setter
    def foothold_freeze(self, value: float) -> None: ...
    @property
    def capture_reach(self) -> float:
        """steps.capture_distance: How far the DCM (COM + T_c times its velocity) may be from its planned place when the next foot takes over, with tied footsteps. Beyond that, or where the ZMP over that foot could not hold it, the tracked speed yields, so that the next step still catches the robot. Unit: m. Default: 0.07 z_c."""
    @capture_reach.setter
    def capture_reach(self, value: float) -> None: ...
    @property
    def capture_speed(self) -> float:
        """steps.capture_speed: Most that the tracked speed yields, either way, to keep the DCM within capture_distance of its plan. Unit: m/s. Default: 0.2 sqrt(g z_c)."""
    @capture_speed.setter
    def capture_speed(self, value: float) -> None: ...
    @property
    def step_timing(self) -> bool:
        """steps.timing: Whether a robot that has been pushed changes the time of its step, uses the whole sole, and steps out of a stand to catch itself. Only with tied footsteps. Default: True."""
    @step_timing.setter
    def step_timing(self, value: bool) -> None: ...
    @property
    def step_ahead_most(self) -> float:
        """steps.ahead_most: How far ahead of the standing foot, or behind it, a foot may be set down to catch the robot. Unit: m. Default: 0.6 z_c."""
    @step_ahead_most.setter
    def step_ahead_most(self, value: float) -> None: ...
    @property
    def step_aside_most(self) -> float:
        """steps.aside_most: How far beside the standing foot a foot may be set down to catch the robot. Unit: m. Default: 0.67 z_c."""
    @step_aside_most.setter
    def step_aside_most(self, value: float) -> None: ...
    @property
    def step_least_time(self) -> float:
        """steps.least_time: Shortest single support of a step that catches the robot. Unit: s. Default: 1.1 T_c."""
    @step_least_time.setter
    def step_least_time(self, value: float) -> None: ...
    @property
    def step_wait_time(self) -> float:
        """steps.wait_time: How much longer than planned a foot may stay in the air, while the ZMP brings the DCM (COM + T_c times its velocity) back over the standing foot. Unit: s. Default: 3 T_c."""
    @step_wait_time.setter
    def step_wait_time(self, value: float) -> None: ...
    @property
    def step_height(self) -> float:
        """swing.height: Height to which a step lifts the foot. Unit: m. Default: 0.0535 z_c, or less (down to 0.01 z_c) where the knee's rotor and damping would take over 0.6 of its torque at the walk's top speed."""
    @step_height.setter
    def step_height(self, value: float) -> None: ...
    @property
    def swing_feed_forward(self) -> bool:
        """swing.feed_forward: Whether the acceleration of the planned swing is added to that which corrects the foot's error. Without it the foot lags behind its path. Default: True."""
    @swing_feed_forward.setter
    def swing_feed_forward(self, value: bool) -> None: ...
    @property
    def swing_kp(self) -> float:
        """swing.kp: Stiffness with which the foot in the air is held on its path: acceleration per error, in position and orientation. Unit: 1/s^2. Default: 3600 (0.276 s / T_c)^2."""
    @swing_kp.setter
    def swing_kp(self, value: float) -> None: ...
    @property
    def swing_kd(self) -> float:
        """swing.kd: Damping with which the foot in the air is held on its path: acceleration per velocity error, in position and orientation. Unit: 1/s. Default: 120 (0.276 s / T_c)."""
    @swing_kd.setter
    def swing_kd(self, value: float) -> None: ...
    @property
    def swing_ahead_acceleration(self) -> float:
        """swing.ahead_acceleration: Acceleration, forward or backward, that a foothold may ask of the foot in the air beyond its way by itself. More would turn the standing foot on the ground, and push the COM the other way. Unit: m/s^2. Default: 1.5 g."""
    @swing_ahead_acceleration.setter
    def swing_ahead_acceleration(self, value: float) -> None: ...
    @property
    def swing_aside_acceleration(self) -> float:
        """swing.aside_acceleration: Acceleration, sideways, that a foothold may ask of the foot in the air beyond its way by itself. Unit: m/s^2. Default: 4 g."""
    @swing_aside_acceleration.setter
    def swing_aside_acceleration(self, value: float) -> None: ...
    @property
    def com_state(self) -> typing.Literal["measured", "desired"]:
        """com.state: What counts as the COM's current state in the pendulum (16), (17): the 'measured' one, or the one that was 'desired' in the cycle before. One of 'measured', 'desired'. Default: 'measured'."""
    @com_state.setter
    def com_state(self, value: typing.Literal["measured", "desired"]) -> None: ...
    @property
    def feed_forward(self) -> bool:
        """com.feed_forward: Whether the pendulum's acceleration is added to the COM's commanded acceleration (8). Without it the COM is one cycle late and takes stiffer gains. Default: True."""
    @feed_forward.setter
    def feed_forward(self, value: bool) -> None: ...
    @property
    def com_x_kp(self) -> float:
        """com.kp_x: Stiffness of the COM's motion forward: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @com_x_kp.setter
    def com_x_kp(self, value: float) -> None: ...
    @property
    def com_x_kd(self) -> float:
        """com.kd_x: Damping of the COM's motion forward: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @com_x_kd.setter
    def com_x_kd(self, value: float) -> None: ...
    @property
    def com_y_kp(self) -> float:
        """com.kp_y: Stiffness of the COM's motion sideways: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @com_y_kp.setter
    def com_y_kp(self, value: float) -> None: ...
    @property
    def com_y_kd(self) -> float:
        """com.kd_y: Damping of the COM's motion sideways: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @com_y_kd.setter
    def com_y_kd(self, value: float) -> None: ...
    @property
    def com_z_kp(self) -> float:
        """com.kp_z: Stiffness of the COM's height: acceleration per position error in (8). Unit: 1/s^2. Default: 200 (0.276 s / T_c)^2."""
    @com_z_kp.setter
    def com_z_kp(self, value: float) -> None: ...
    @property
    def com_z_kd(self) -> float:
        """com.kd_z: Damping of the COM's height: acceleration per velocity error in (8). Unit: 1/s. Default: 28 (0.276 s / T_c)."""
    @com_z_kd.setter
    def com_z_kd(self, value: float) -> None: ...
    @property
    def com_lead(self) -> float:
        """com.lead: How far the COM rides ahead of the middle between the feet, with tied footsteps. So a foot that has just landed is not loaded on its heel, where the contact settles slowly. Unit: m. Default: 0.0134 z_c."""
    @com_lead.setter
    def com_lead(self, value: float) -> None: ...
    @property
    def least_knee(self) -> float:
        """com.least_knee: Smallest knee angle that the plan allows, so that no leg becomes straight. It leaves room for what the plan does not know: swing leg and pelvis move the hips against the COM. Unit: rad. Default: 0.3."""
    @least_knee.setter
    def least_knee(self, value: float) -> None: ...
    @property
    def crouch_limit(self) -> float:
        """com.crouch_limit: How far the COM may come down so that the legs reach far enough for long steps. Unit: m. Default: 0.1 z_c."""
    @crouch_limit.setter
    def crouch_limit(self, value: float) -> None: ...
    @property
    def crouch_margin(self) -> float:
        """com.crouch_margin: For long steps the COM comes down until the legs reach this many times as far as the feet are from under the hips in double support. Default: 1.2."""
    @crouch_margin.setter
    def crouch_margin(self, value: float) -> None: ...
    @property
    def crouch_time(self) -> float:
        """com.crouch_time: Time constant with which the COM comes down for long steps and rises after them. Unit: s. Default: 0.5 T_c."""
    @crouch_time.setter
    def crouch_time(self, value: float) -> None: ...
    @property
    def zmp_modification(self) -> bool:
        """zmp.modification: Whether the estimated ZMP is kept inside its bounds (III-B, III-C). With false the planned velocity is tracked blindly. Default: True."""
    @zmp_modification.setter
    def zmp_modification(self, value: bool) -> None: ...
    @property
    def iteration(self) -> typing.Literal["closed_form", "loop", "none"]:
        """zmp.iteration: How the reference ZMP is found that puts the estimated ZMP where it is desired: in 'closed_form', or by the 'loop' that III-B prints. With 'none' the pendulum's ZMP is taken as it is, and the estimate changes nothing. One of 'closed_form', 'loop', 'none'. Default: 'closed_form'."""
    @iteration.setter
    def iteration(self, value: typing.Literal["closed_form", "loop", "none"]) -> None: ...
    @property
    def zmp_threshold(self) -> float:
        """zmp.threshold: The reference ZMP is good enough once the estimated ZMP is this near to the desired one (section IV). Unit: m. Default: 0.001."""
    @zmp_threshold.setter
    def zmp_threshold(self, value: float) -> None: ...
    @property
    def max_iterations(self) -> int:
        """zmp.max_iterations: Most passes of the loop of III-B in one control cycle, which then goes on with what it has. Default: 200."""
    @max_iterations.setter
    def max_iterations(self, value: int) -> None: ...
    @property
    def sole_fraction(self) -> float:
        """zmp.sole_fraction: Share of the sole's length and width that the ZMP may use. The rest is a margin: a foot whose ZMP is at its edge tips. Default: 0.72."""
    @sole_fraction.setter
    def sole_fraction(self, value: float) -> None: ...
    @property
    def sole_exponent(self) -> float:
        """zmp.sole_exponent: How much less of the sole's length the ZMP uses above cadence_speed: (cadence_speed / speed)^sole_exponent of it. At the sole's ends the contact of a fast walk chatters. Default: 0.5."""
    @sole_exponent.setter
    def sole_exponent(self, value: float) -> None: ...
    @property
    def ankle_torque_fraction(self) -> float:
        """zmp.ankle_torque_fraction: Share of an ankle's torque limit that may hold the ZMP away from the ankle. Where ankles are weak this, not the sole, bounds the ZMP. Default: 0.9."""
    @ankle_torque_fraction.setter
    def ankle_torque_fraction(self, value: float) -> None: ...
    @property
    def bound_lateral(self) -> bool:
        """zmp.bound_lateral: Whether the ZMP is kept inside its bounds sideways too. The paper bounds it forward only. Default: True."""
    @bound_lateral.setter
    def bound_lateral(self, value: bool) -> None: ...
    @property
    def lateral_law(self) -> typing.Literal["orbit", "paper"]:
        """zmp.lateral_law: Law by which the reference ZMP is shifted sideways from the middle of the sole that carries it (III-D). One of 'orbit', which shifts it so that the sway repeats; 'paper', which leaves it in the middle, so that an error at the start never decays. Default: 'orbit'."""
    @lateral_law.setter
    def lateral_law(self, value: typing.Literal["orbit", "paper"]) -> None: ...
    @property
    def lateral_reach(self) -> float:
        """zmp.lateral_shift: Largest sideways shift of the reference ZMP that the lateral law may ask for, as a share of half the sole's width. Default: 1.6."""
    @lateral_reach.setter
    def lateral_reach(self, value: float) -> None: ...
    @property
    def whole_sole_fraction(self) -> float:
        """zmp.whole_fraction: Share of the sole's length and width that the ZMP may use when the robot has been pushed. It takes the place of sole_fraction as the DCM (COM + T_c times its velocity) leaves its plan. Default: 0.95."""
    @whole_sole_fraction.setter
    def whole_sole_fraction(self, value: float) -> None: ...
    @property
    def corner_cut(self) -> float:
        """zmp.corner_cut: Share of the sole's length that the ZMP gives up where it is at the sole's side: in a corner of the sole it would tip the foot. Default: 0.3."""
    @corner_cut.setter
    def corner_cut(self, value: float) -> None: ...
    @property
    def tracker(self) -> typing.Literal["smooth", "bang_bang"]:
        """tracking.law: Law by which the COM's velocity follows the planned one. One of 'smooth', which accelerates in proportion to the error; 'bang_bang', which drives the ZMP to its bounds until the error is gone, as III-C is printed. Default: 'smooth'."""
    @tracker.setter
    def tracker(self, value: typing.Literal["smooth", "bang_bang"]) -> None: ...
    @property
    def tracker_gain(self) -> float:
        """tracking.gain: How fast the smooth law makes up lost way: speed that it adds per metre behind the plan. Unit: 1/s. Default: 1.38 / T_c."""
    @tracker_gain.setter
    def tracker_gain(self, value: float) -> None: ...
    @property
    def tracker_time(self) -> float:
        """tracking.time: Time constant with which the smooth law removes an error of the speed. Unit: s. Default: 0.18 T_c."""
    @tracker_time.setter
    def tracker_time(self, value: float) -> None: ...
    @property
    def tracker_reach(self) -> float:
        """tracking.catch_up_speed: Largest speed that the smooth law adds or takes away to make up lost or gained way. Feet cannot make up a long way in one step. Unit: m/s. Default: 0.03 sqrt(g z_c)."""
    @tracker_reach.setter
    def tracker_reach(self, value: float) -> None: ...
    @property
    def tracker_deadband(self) -> float:
        """tracking.deadband: How far the COM may be ahead of its plan or behind it before the bang-bang law drives it back. A drive ends a little beyond the plan, since time is discrete; without a deadband that would start the next drive. Unit: m. Default: 0.0002."""
    @tracker_deadband.setter
    def tracker_deadband(self, value: float) -> None: ...
    @property
    def regain_from(self) -> float:
        """tracking.regain_from: How far the COM must be behind its plan, or ahead of it, before steps become longer or shorter to make up for it. A push can cost half a metre. Only with tied footsteps. Unit: m. Default: 0.08 z_c."""
    @regain_from.setter
    def regain_from(self, value: float) -> None: ...
    @property
    def regain_gain(self) -> float:
        """tracking.regain_gain: Speed that those steps add per metre beyond regain_from. Unit: 1/s. Default: 0.14 / T_c."""
    @regain_gain.setter
    def regain_gain(self, value: float) -> None: ...
    @property
    def regain_speed(self) -> float:
        """tracking.regain_speed: Largest speed that those steps add or take away. Unit: m/s. Default: 0.045 sqrt(g z_c)."""
    @regain_speed.setter
    def regain_speed(self, value: float) -> None: ...
    @property
    def rate_limit(self) -> bool:
        """rate.limit: Whether the planned velocity changes no faster than steps can follow. With false profiles and commands are taken as they are. Default: True."""
    @rate_limit.setter
    def rate_limit(self, value: bool) -> None: ...
    @property
    def forward_jump(self) -> float:
        """rate.forward_jump: Change of the forward velocity v_x that is taken up at once. A larger one follows at forward_acceleration or forward_deceleration. Unit: m/s. Default: 0.036 sqrt(g z_c)."""
    @forward_jump.setter
    def forward_jump(self, value: float) -> None: ...
    @property
    def sideways_jump(self) -> float:
        """rate.sideways_jump: Change of the sideways velocity v_y that is taken up at once. A larger one follows at sideways_acceleration. Unit: m/s. Default: 0.0."""
    @sideways_jump.setter
    def sideways_jump(self, value: float) -> None: ...
    @property
    def turning_jump(self) -> float:
        """rate.turning_jump: Change of the turning velocity w_z that is taken up at once. A larger one follows at turning_acceleration. Unit: rad/s. Default: 0.07 / T_c."""
    @turning_jump.setter
    def turning_jump(self, value: float) -> None: ...
    @property
    def forward_acceleration(self) -> float:
        """rate.forward_acceleration: Rate at which the forward velocity v_x moves away from zero. Unit: m/s^2. Default: 0.02 g."""
    @forward_acceleration.setter
    def forward_acceleration(self, value: float) -> None: ...
    @property
    def forward_deceleration(self) -> float:
        """rate.forward_deceleration: Rate at which the forward velocity v_x goes back to zero. Unit: m/s^2. Default: 0.056 g."""
    @forward_deceleration.setter
    def forward_deceleration(self, value: float) -> None: ...
    @property
    def sideways_acceleration(self) -> float:
        """rate.sideways_acceleration: Rate at which the sideways velocity v_y changes. Unit: m/s^2. Default: 0.025 g."""
    @sideways_acceleration.setter
    def sideways_acceleration(self, value: float) -> None: ...
    @property
    def turning_acceleration(self) -> float:
        """rate.turning_acceleration: Rate at which the turning velocity w_z changes. Unit: rad/s^2. Default: 0.08 / T_c^2."""
    @turning_acceleration.setter
    def turning_acceleration(self, value: float) -> None: ...
    @property
    def trunk_kp(self) -> float:
        """trunk.kp: Stiffness of the trunk's orientation: angular acceleration per angle of error. Unit: 1/s^2. Default: 300 (0.276 s / T_c)^2."""
    @trunk_kp.setter
    def trunk_kp(self, value: float) -> None: ...
    @property
    def trunk_kd(self) -> float:
        """trunk.kd: Damping of the trunk's orientation: angular acceleration per error of angular velocity. Unit: 1/s. Default: 35 (0.276 s / T_c)."""
    @trunk_kd.setter
    def trunk_kd(self, value: float) -> None: ...
    @property
    def trunk_yields(self) -> bool:
        """trunk.yields: Whether the trunk of a robot that has been pushed comes back upright slowly. A trunk that is held stiffly takes the ZMP away from where it would hold the DCM (COM + T_c times its velocity), and turns the standing foot. Default: True."""
    @trunk_yields.setter
    def trunk_yields(self, value: bool) -> None: ...
    @property
    def posture_task(self) -> bool:
        """posture.task: Whether the joints outside the legs are controlled. With false their motion is left to the torque of least norm. Default: True."""
    @posture_task.setter
    def posture_task(self, value: bool) -> None: ...
    @property
    def posture_kp(self) -> float:
        """posture.kp: Stiffness of the joints outside the legs: acceleration per angle of error. Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @posture_kp.setter
    def posture_kp(self, value: float) -> None: ...
    @property
    def posture_kd(self) -> float:
        """posture.kd: Damping of the joints outside the legs: acceleration per error of joint velocity. Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @posture_kd.setter
    def posture_kd(self, value: float) -> None: ...
    @property
    def motion_blend(self) -> float:
        """posture.motion_blend: Time in which a new joint motion takes over from the one before it. Unit: s. Default: 1.8 T_c."""
    @motion_blend.setter
    def motion_blend(self, value: float) -> None: ...
    @property
    def momentum_arms(self) -> float:
        """arms.momentum: Share of the yaw momentum of legs and trunk that the arms cancel by swinging, 0 to 1. Joints that a motion names do not swing. Default: 0.0."""
    @momentum_arms.setter
    def momentum_arms(self, value: float) -> None: ...
    @property
    def momentum_kp(self) -> float:
        """arms.kp: Stiffness of the spring that brings swinging arms back to their posture: acceleration per angle. Unit: 1/s^2. Default: 20 (0.276 s / T_c)^2."""
    @momentum_kp.setter
    def momentum_kp(self, value: float) -> None: ...
    @property
    def momentum_kd(self) -> float:
        """arms.kd: Rate at which swinging arms bring the robot's yaw momentum to zero. Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @momentum_kd.setter
    def momentum_kd(self, value: float) -> None: ...
    @property
    def arms_reserve(self) -> float:
        """arms.reserve: Share of the yaw momentum that the arms cancel, where this is more than momentum, while the yaw friction of a sole holds the torque back, so that the foot does not spin. With 0 they never help. Default: 1.0."""
    @arms_reserve.setter
    def arms_reserve(self, value: float) -> None: ...
    @property
    def arms_reserve_time(self) -> float:
        """arms.reserve_time: Time in which the arms return to their posture once the soles hold the yaw moment again. They come to help in a tenth of it. Unit: s. Default: 2 T_c."""
    @arms_reserve_time.setter
    def arms_reserve_time(self, value: float) -> None: ...
    @property
    def wrench_distribution(self) -> bool:
        """contact.wrench_distribution: Whether two standing feet share the load by the place of the ZMP between them. With false the torque of least norm decides, which ignores that feet cannot pull. Default: True."""
    @wrench_distribution.setter
    def wrench_distribution(self, value: bool) -> None: ...
    @property
    def load_alone(self) -> float:
        """contact.load_alone: In double support one foot carries everything while the ZMP is this near to its centre line, in half sole widths. A foot that has just landed would chatter under a light load. Default: 0.7."""
    @load_alone.setter
    def load_alone(self, value: float) -> None: ...
    @property
    def contact_damping(self) -> float:
        """contact.damping: Damping of the velocity of a standing foot that does not carry the ZMP. Without a load it would drift off the ground. Unit: 1/s. Default: 100.0."""
    @contact_damping.setter
    def contact_damping(self, value: float) -> None: ...
    @property
    def control_dt(self) -> float:
        """control.dt: Control period: a new torque is computed this often and held in between. It must be a multiple of the model's time step. Unit: s. Default: the model's time step."""
    @control_dt.setter
    def control_dt(self, value: float) -> None: ...
    @property
    def textbook(self) -> bool:
        """control.textbook: Whether equations (1) to (13) are computed as printed instead of on the direct path. It is slower and gives the same numbers. Default: False."""
    @textbook.setter
    def textbook(self, value: bool) -> None: ...
    @property
    def singular_damping(self) -> float:
        """control.singular_damping: Damping that keeps the joints' motion bounded where a leg is straight. Default: 0.001."""
    @singular_damping.setter
    def singular_damping(self, value: float) -> None: ...
    @property
    def singular_pivot(self) -> float:
        """control.singular_pivot: Smallest pivot of a leg's equations below which that leg counts as straight. Default: 0.01."""
    @singular_pivot.setter
    def singular_pivot(self, value: float) -> None: ...
    @property
    def singular_task(self) -> float:
        """control.singular_task: How far a task of your own may be from impossible before it is met in part only: the motion that it asks for is damped in directions in which the joints outside the legs move it by less than this share of its size. So it stays bounded where an arm is stretched out. With 0 nothing is damped. Default: 0.005."""
    @singular_task.setter
    def singular_task(self, value: float) -> None: ...
    @property
    def friction_velocity(self) -> float:
        """control.friction_velocity: Joint speed below which dry friction is taken as proportional to the speed, so that it does not jump where a joint turns around. Unit: rad/s. Default: 0.02."""
    @friction_velocity.setter
    def friction_velocity(self, value: float) -> None: ...
    @property
    def kernel(self) -> str:
        """control.kernel: Build of the inner loops: 'auto' takes the best that this processor runs, and build_info()['kernels'] names those that there are. They agree to rounding. Default: 'auto'."""
    @kernel.setter
    def kernel(self, value: str) -> None: ...
    @property
    def torque_limits(self) -> dict[str, float]:
        """control.torque_limits: Torque limits by joint name, in place of the robot's own. A motor still gives no more than the model lets through. Unit: N m. Default: {}."""
    @torque_limits.setter
    def torque_limits(self, value: typing.Mapping[str, float]) -> None: ...
    @property
    def keep_limits(self) -> bool:
        """limits.keep: Whether the nearest torque that keeps the limits is found where the closed form's torque would break one: the tasks give way, first the swing foot, then the trunk, the COM's height, and last its horizontal acceleration. With false torques are cut to their limits, and nothing else is kept. Default: True."""
    @keep_limits.setter
    def keep_limits(self, value: bool) -> None: ...
    @property
    def friction(self) -> float:
        """limits.friction: Friction of the soles: tangential force per normal force that they can hold. Default: that of the soles in the model."""
    @friction.setter
    def friction(self, value: float) -> None: ...
    @property
    def feel_slip(self) -> bool:
        """limits.feel_slip: Whether a sole that slides while it carries lowers the friction that is believed, and with it the planned speed. With true the robot walks on over ice; but soles that slide a little as they land, as they do where the measured attitude is off by 2 degrees, pass for slipping ones, and it slows down. Default: False."""
    @feel_slip.setter
    def feel_slip(self, value: bool) -> None: ...
    @property
    def twist_share(self) -> float:
        """limits.twist: Moment about the vertical that a sole may give, as a share of what its friction holds while it turns about its centre. With more than 1 the foot turns a little where it must. Default: 1.0."""
    @twist_share.setter
    def twist_share(self, value: float) -> None: ...
    @property
    def range_margin(self) -> float:
        """limits.range_margin: How far from the ends of its range a joint comes to rest. Unit: rad. Default: 0.0."""
    @range_margin.setter
    def range_margin(self, value: float) -> None: ...
    @property
    def range_rate(self) -> float:
        """limits.range_rate: How fast a joint may still move towards the end of its range: it comes to rest there as a critically damped joint of this damping does. A small rate brakes early. Unit: 1/s. Default: 120 (0.276 s / T_c)."""
    @range_rate.setter
    def range_rate(self, value: float) -> None: ...
    @property
    def disturbance_observer(self) -> bool:
        """observer.on: Whether the walk makes up for steady forces, wrong masses, and noise or bias of the measured attitude. A walk that knows everything keeps its bits. Default: True."""
    @disturbance_observer.setter
    def disturbance_observer(self, value: bool) -> None: ...
    @property
    def observer_time(self) -> float:
        """observer.time: Time constant with which a disturbance is found: an acceleration of the COM that the command does not explain. Where the measured speed is noisy, it grows up to four times. Unit: s. Default: 0.18 T_c."""
    @observer_time.setter
    def observer_time(self, value: float) -> None: ...
    @property
    def observer_speed_noise(self) -> float:
        """observer.speed_noise: Change of the COM's speed from cycle to cycle that the command does not explain, as root of its mean square, up to which the speed counts as measured without noise. Unit: m/s. Default: 0.0092 sqrt(g z_c)."""
    @observer_speed_noise.setter
    def observer_speed_noise(self, value: float) -> None: ...
    @property
    def observer_tolerance(self) -> float:
        """observer.tolerance: A disturbance is made up for where it is larger than this, and less by this: contacts that give way a little are none. Unit: m/s^2. Default: 0.015 g."""
    @observer_tolerance.setter
    def observer_tolerance(self, value: float) -> None: ...
    @property
    def observer_force_most(self) -> float:
        """observer.force_most: Most that is made up for of a steady horizontal disturbance, along either axis. Unit: m/s^2. Default: 0.13 g."""
    @observer_force_most.setter
    def observer_force_most(self, value: float) -> None: ...
    @property
    def observer_weight_most(self) -> float:
        """observer.weight_most: Most that the robot is taken to be heavier or lighter than its model says, as a share of its mass. Default: 0.35."""
    @observer_weight_most.setter
    def observer_weight_most(self, value: float) -> None: ...
    @property
    def observer_push(self) -> float:
        """observer.push: A horizontal disturbance that is larger than this is a push and not steady: what was found before it is held. Unit: m/s^2. Default: 0.16 g."""
    @observer_push.setter
    def observer_push(self, value: float) -> None: ...
    @property
    def attitude_time(self) -> float:
        """observer.attitude_time: Time constant with which a noisy attitude of the base corrects the one that its angular velocity leads to. Unit: s. Default: 1.1 T_c."""
    @attitude_time.setter
    def attitude_time(self, value: float) -> None: ...
    @property
    def attitude_noise(self) -> float:
        """observer.attitude_noise: Angle between the measured attitude and the one that the angular velocity leads to from the cycle before, as root of its mean square, up to which the attitude is taken as it is measured. Unit: rad. Default: 0.001."""
    @attitude_noise.setter
    def attitude_noise(self, value: float) -> None: ...
    @property
    def attitude_bias_time(self) -> float:
        """observer.bias_time: Time constant with which a bias of the measured attitude is found. Unit: s. Default: 1.8 T_c."""
    @attitude_bias_time.setter
    def attitude_bias_time(self, value: float) -> None: ...
    @property
    def attitude_bias_most(self) -> float:
        """observer.bias_most: Most that is made up for of a bias of the measured attitude. Unit: rad. Default: 0.09."""
    @attitude_bias_most.setter
    def attitude_bias_most(self, value: float) -> None: ...
    @property
    def attitude_sole_tilt(self) -> float:
        """observer.sole_tilt: Tilt of the standing sole from level that shows no bias yet: contacts give way a little. Unit: rad. Default: 0.004."""
    @attitude_sole_tilt.setter
    def attitude_sole_tilt(self, value: float) -> None: ...
    @property
    def command_limit(self) -> bool:
        """command.limit: Whether commands and profiles are kept within what the torques of the legs and the friction under the soles give. With false only the reach of the legs limits them. Default: True."""
    @command_limit.setter
    def command_limit(self, value: bool) -> None: ...
    @property
    def command_share(self) -> float:
        """command.share: Share of those torques and that friction that a commanded velocity may use. More than 1 allows faster walks, which cut torques and slide. Default: 1.0."""
    @command_share.setter
    def command_share(self, value: float) -> None: ...
    @property
    def fall_height(self) -> float:
        """fall.height: The robot has fallen where its COM is less high over the support foot than this share of its height at the start. Default: 0.8."""
    @fall_height.setter
    def fall_height(self, value: float) -> None: ...
    @property
    def fall_tilt(self) -> float:
        """fall.tilt: The robot has fallen where its trunk tilts by more than this. Unit: rad. Default: 0.8."""
    @fall_tilt.setter
    def fall_tilt(self, value: float) -> None: ...
    @property
    def fall_foot_tilt(self) -> float:
        """fall.foot_tilt: A fall is foreseen where the only foot that stands tilts by more than this, as it tips over its edge. Unit: rad. Default: 0.45."""
    @fall_foot_tilt.setter
    def fall_foot_tilt(self, value: float) -> None: ...
    @property
    def fall_foresee(self) -> bool:
        """fall.foresee: Whether a fall is foreseen: it is certain once no foothold within reach, and no time of landing, can catch the DCM (COM + T_c times its velocity) any more. Default: True."""
    @fall_foresee.setter
    def fall_foresee(self, value: bool) -> None: ...
    @property
    def fall_crouch(self) -> bool:
        """fall.crouch: Whether the robot crouches once a fall is foreseen: the legs bend and every joint is damped, until the walk is started anew. With false it walks on as if nothing were foreseen. Default: True."""
    @fall_crouch.setter
    def fall_crouch(self, value: bool) -> None: ...
    @property
    def fall_margin(self) -> float:
        """fall.margin: How far the DCM must be beyond what any foothold within reach can catch before the fall counts as certain. Trunk, arms and what the pendulum does not know may bring back that much. Unit: m. Default: 0.03 z_c."""
    @fall_margin.setter
    def fall_margin(self, value: float) -> None: ...
    @property
    def fall_confirm_time(self) -> float:
        """fall.confirm_time: How long the DCM must be that far off without a break before the fall counts as certain: a noisy measurement alone fells nobody. Unit: s. Default: 0.04 T_c."""
    @fall_confirm_time.setter
    def fall_confirm_time(self, value: float) -> None: ...

class GaitSettings:
    """
    When a foot is lifted and set down, and when the robot stands.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> GaitSettings: ...
    def __deepcopy__(self, arg0: dict) -> GaitSettings: ...
    def __eq__(self, arg0: GaitSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def T_ds(self) -> float:
        """Double support time of a step: how long both feet stand between two swings. Unit: s. Default: 0.2 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m)."""
    @T_ds.setter
    def T_ds(self, value: float) -> None: ...
    @property
    def T_ss(self) -> float:
        """Single support time of a step: how long one foot is in the air. Unit: s. Default: 0.8 of a step's period, which is 0.8 s sqrt(z_c / 0.747 m)."""
    @T_ss.setter
    def T_ss(self, value: float) -> None: ...
    @property
    def T_ds_first(self) -> float:
        """Length of the first double support, in which the COM leaves its rest. With the default its sway is the steady one from the first step on. Unit: s. Default: the time in which a COM at rest takes up the sway of the steady walk."""
    @T_ds_first.setter
    def T_ds_first(self, value: float) -> None: ...
    @property
    def first_swing(self) -> typing.Literal["right", "left"]:
        """Foot that takes the first step. One of 'right', 'left'. Default: 'right'."""
    @first_swing.setter
    def first_swing(self, value: typing.Literal["right", "left"]) -> None: ...
    @property
    def cadence_speed(self) -> float:
        """Speed up to which every step takes T_ss + T_ds, and a faster walk takes longer steps. Above it the steps come faster as well. Unit: m/s. Default: 0.1 sqrt(g z_c)."""
    @cadence_speed.setter
    def cadence_speed(self, value: float) -> None: ...
    @property
    def cadence_exponent(self) -> float:
        """How much faster steps come above cadence_speed: a step takes (cadence_speed / speed)^cadence_exponent of T_ss + T_ds. With 0 all steps take the same time. Default: 0.4, or 0 where a list sets the lengths of the steps."""
    @cadence_exponent.setter
    def cadence_exponent(self, value: float) -> None: ...
    @property
    def cadence_double(self) -> float:
        """How much the double support's share of a step shrinks above cadence_speed: as (cadence_speed / speed)^cadence_double. With 0 the share stays. Default: 0.5."""
    @cadence_double.setter
    def cadence_double(self, value: float) -> None: ...
    @property
    def cadence_sideways(self) -> float:
        """Weight of the sideways velocity in the speed that is compared with cadence_speed: 1 m/s sideways counts as this many m/s forward. Default: 3.0."""
    @cadence_sideways.setter
    def cadence_sideways(self, value: float) -> None: ...
    @property
    def cadence_turning(self) -> float:
        """Weight of turning in the speed that is compared with cadence_speed: 1 rad/s counts as this many m/s forward. Unit: m/rad. Default: 0.54 z_c."""
    @cadence_turning.setter
    def cadence_turning(self, value: float) -> None: ...
    @property
    def stand(self) -> bool:
        """Whether the robot stands still, feet side by side, while the planned velocity is zero. With false it steps on the spot. Default: True."""
    @stand.setter
    def stand(self, value: bool) -> None: ...
    @property
    def stand_gain(self) -> float:
        """How hard a standing robot is brought back over the middle between its feet: the ZMP goes beyond the DCM (COM + T_c times its velocity) by this many times the DCM's distance from the middle. Default: 1.0."""
    @stand_gain.setter
    def stand_gain(self, value: float) -> None: ...
    @property
    def closing_distance(self) -> float:
        """A walk ends with a step that sets the foot beside the other one. That step is taken once the DCM (COM + T_c times its velocity) will be this near to the standing foot at its end. Unit: m. Default: 0.1 z_c."""
    @closing_distance.setter
    def closing_distance(self, value: float) -> None: ...
    @property
    def closing_turn(self) -> float:
        """A walk ends with a step that sets the foot beside the other one. That step is taken only where the headings of the path and of the standing foot differ by no more than this. Unit: rad. Default: 0.05."""
    @closing_turn.setter
    def closing_turn(self, value: float) -> None: ...
    @property
    def touch_down(self) -> typing.Literal["felt", "time", "contact"]:
        """What ends a step. 'felt': by time, but a foot that meets the ground well before its time stays there, and once feet have found the ground uneven it is felt for; then height and swing follow the ground. 'time' alone; or 'contact': each step ends when the swing foot is felt to touch. A foot whose contact is not known, or was never felt, ends its step by time. One of 'felt', 'time', 'contact'. Default: 'felt'."""
    @touch_down.setter
    def touch_down(self, value: typing.Literal["felt", "time", "contact"]) -> None: ...
    @property
    def touch_down_share(self) -> float:
        """Share of the single support before which a contact of the swing foot does not end the step: a foot that has just lifted may scuff the ground. Not where touch_down is 'time'. Default: 0.5."""
    @touch_down_share.setter
    def touch_down_share(self, value: float) -> None: ...
    @property
    def touch_down_time(self) -> float:
        """How long a swing foot that meets no ground at its planned time goes on down, until the step ends by time. Not where touch_down is 'time'. Unit: s. Default: 0.18 T_c."""
    @touch_down_time.setter
    def touch_down_time(self, value: float) -> None: ...
    @property
    def touch_down_speed(self) -> float:
        """Speed at which a swing foot comes down onto the ground where touch_down is 'contact', and on ground that has been felt to be uneven. A foot that meets none at its planned time goes on at this speed, ever slower: within touch_down_time by two thirds of touch_down_speed times touch_down_time. By time, a foot lands at rest. Unit: m/s. Default: 0.037 sqrt(g z_c)."""
    @touch_down_speed.setter
    def touch_down_speed(self, value: float) -> None: ...

class StepsSettings:
    """
    Where the feet are set down.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> StepsSettings: ...
    def __deepcopy__(self, arg0: dict) -> StepsSettings: ...
    def __eq__(self, arg0: StepsSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def mode(self) -> typing.Literal["tied", "absolute", "paper", "printed", "list"]:
        """What decides where a foot lands: 'tied' follows the COM, which keeps the walk balanced; 'absolute' takes the places of the plan; 'paper' and 'printed' take the step lengths of section IV, corrected and as printed; 'list' takes steps.lengths. Python and files take a list of lengths here as well. One of 'tied', 'absolute', 'paper', 'printed', 'list'. Default: 'tied'."""
    @mode.setter
    def mode(
        self, value: typing.Literal["tied", "absolute", "paper", "printed", "list"] | typing.Sequence[float]
    ) -> None: ...
    @property
    def lengths(self) -> list[float]:
        """How far each step lands ahead of the standing foot, one number per step; the last one repeats. Tied footsteps do not use it. Unit: m. Default: []."""
    @lengths.setter
    def lengths(self, value: typing.Sequence[float]) -> None: ...
    @property
    def width(self) -> float:
        """Distance of the two feet from each other, sideways. Unit: m. Default: as the feet stand at the start."""
    @width.setter
    def width(self, value: float) -> None: ...
    @property
    def clearance(self) -> float:
        """Least gap that a step leaves between the edges of the two feet, sideways. Unit: m. Default: 0.03 z_c."""
    @clearance.setter
    def clearance(self, value: float) -> None: ...
    @property
    def shift(self) -> float:
        """How far a tied foothold moves from its nominal place to keep the robot balanced, whatever the foot in the air does. A longer way, and any way of a robot that has been pushed, is bounded by the reach of the leg and by where the foot in the air can still get to. Unit: m. Default: 0.25 z_c."""
    @shift.setter
    def shift(self, value: float) -> None: ...
    @property
    def filter_time(self) -> float:
        """Time constant of the low-pass through which a tied foothold moves while the foot is in the air. Unit: s. Default: 0.18 T_c."""
    @filter_time.setter
    def filter_time(self, value: float) -> None: ...
    @property
    def give(self) -> float:
        """A COM that is faster or slower than planned needs another foothold or another ZMP. Up to this share of its bounds the ZMP over the next foot makes up for it; only the rest moves a tied foothold. With 0 each long step would be followed by a short one. Default: 0.3."""
    @give.setter
    def give(self, value: float) -> None: ...
    @property
    def freeze(self) -> float:
        """Share of the single support after which a tied foothold stays where it is, so that the foot lands calmly. Default: 0.7."""
    @freeze.setter
    def freeze(self, value: float) -> None: ...
    @property
    def capture_distance(self) -> float:
        """How far the DCM (COM + T_c times its velocity) may be from its planned place when the next foot takes over, with tied footsteps. Beyond that, or where the ZMP over that foot could not hold it, the tracked speed yields, so that the next step still catches the robot. Unit: m. Default: 0.07 z_c."""
    @capture_distance.setter
    def capture_distance(self, value: float) -> None: ...
    @property
    def capture_speed(self) -> float:
        """Most that the tracked speed yields, either way, to keep the DCM within capture_distance of its plan. Unit: m/s. Default: 0.2 sqrt(g z_c)."""
    @capture_speed.setter
    def capture_speed(self, value: float) -> None: ...
    @property
    def timing(self) -> bool:
        """Whether a robot that has been pushed changes the time of its step, uses the whole sole, and steps out of a stand to catch itself. Only with tied footsteps. Default: True."""
    @timing.setter
    def timing(self, value: bool) -> None: ...
    @property
    def ahead_most(self) -> float:
        """How far ahead of the standing foot, or behind it, a foot may be set down to catch the robot. Unit: m. Default: 0.6 z_c."""
    @ahead_most.setter
    def ahead_most(self, value: float) -> None: ...
    @property
    def aside_most(self) -> float:
        """How far beside the standing foot a foot may be set down to catch the robot. Unit: m. Default: 0.67 z_c."""
    @aside_most.setter
    def aside_most(self, value: float) -> None: ...
    @property
    def least_time(self) -> float:
        """Shortest single support of a step that catches the robot. Unit: s. Default: 1.1 T_c."""
    @least_time.setter
    def least_time(self, value: float) -> None: ...
    @property
    def wait_time(self) -> float:
        """How much longer than planned a foot may stay in the air, while the ZMP brings the DCM (COM + T_c times its velocity) back over the standing foot. Unit: s. Default: 3 T_c."""
    @wait_time.setter
    def wait_time(self, value: float) -> None: ...

class SwingSettings:
    """
    How the foot in the air moves.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> SwingSettings: ...
    def __deepcopy__(self, arg0: dict) -> SwingSettings: ...
    def __eq__(self, arg0: SwingSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def height(self) -> float:
        """Height to which a step lifts the foot. Unit: m. Default: 0.0535 z_c, or less (down to 0.01 z_c) where the knee's rotor and damping would take over 0.6 of its torque at the walk's top speed."""
    @height.setter
    def height(self, value: float) -> None: ...
    @property
    def feed_forward(self) -> bool:
        """Whether the acceleration of the planned swing is added to that which corrects the foot's error. Without it the foot lags behind its path. Default: True."""
    @feed_forward.setter
    def feed_forward(self, value: bool) -> None: ...
    @property
    def kp(self) -> float:
        """Stiffness with which the foot in the air is held on its path: acceleration per error, in position and orientation. Unit: 1/s^2. Default: 3600 (0.276 s / T_c)^2."""
    @kp.setter
    def kp(self, value: float) -> None: ...
    @property
    def kd(self) -> float:
        """Damping with which the foot in the air is held on its path: acceleration per velocity error, in position and orientation. Unit: 1/s. Default: 120 (0.276 s / T_c)."""
    @kd.setter
    def kd(self, value: float) -> None: ...
    @property
    def ahead_acceleration(self) -> float:
        """Acceleration, forward or backward, that a foothold may ask of the foot in the air beyond its way by itself. More would turn the standing foot on the ground, and push the COM the other way. Unit: m/s^2. Default: 1.5 g."""
    @ahead_acceleration.setter
    def ahead_acceleration(self, value: float) -> None: ...
    @property
    def aside_acceleration(self) -> float:
        """Acceleration, sideways, that a foothold may ask of the foot in the air beyond its way by itself. Unit: m/s^2. Default: 4 g."""
    @aside_acceleration.setter
    def aside_acceleration(self, value: float) -> None: ...

class ComSettings:
    """
    How the centre of mass (COM) is moved: forward, sideways and in height.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ComSettings: ...
    def __deepcopy__(self, arg0: dict) -> ComSettings: ...
    def __eq__(self, arg0: ComSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def state(self) -> typing.Literal["measured", "desired"]:
        """What counts as the COM's current state in the pendulum (16), (17): the 'measured' one, or the one that was 'desired' in the cycle before. One of 'measured', 'desired'. Default: 'measured'."""
    @state.setter
    def state(self, value: typing.Literal["measured", "desired"]) -> None: ...
    @property
    def feed_forward(self) -> bool:
        """Whether the pendulum's acceleration is added to the COM's commanded acceleration (8). Without it the COM is one cycle late and takes stiffer gains. Default: True."""
    @feed_forward.setter
    def feed_forward(self, value: bool) -> None: ...
    @property
    def kp_x(self) -> float:
        """Stiffness of the COM's motion forward: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @kp_x.setter
    def kp_x(self, value: float) -> None: ...
    @property
    def kd_x(self) -> float:
        """Damping of the COM's motion forward: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @kd_x.setter
    def kd_x(self, value: float) -> None: ...
    @property
    def kp_y(self) -> float:
        """Stiffness of the COM's motion sideways: acceleration per position error in (8). Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @kp_y.setter
    def kp_y(self, value: float) -> None: ...
    @property
    def kd_y(self) -> float:
        """Damping of the COM's motion sideways: acceleration per velocity error in (8). Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @kd_y.setter
    def kd_y(self, value: float) -> None: ...
    @property
    def kp_z(self) -> float:
        """Stiffness of the COM's height: acceleration per position error in (8). Unit: 1/s^2. Default: 200 (0.276 s / T_c)^2."""
    @kp_z.setter
    def kp_z(self, value: float) -> None: ...
    @property
    def kd_z(self) -> float:
        """Damping of the COM's height: acceleration per velocity error in (8). Unit: 1/s. Default: 28 (0.276 s / T_c)."""
    @kd_z.setter
    def kd_z(self, value: float) -> None: ...
    @property
    def lead(self) -> float:
        """How far the COM rides ahead of the middle between the feet, with tied footsteps. So a foot that has just landed is not loaded on its heel, where the contact settles slowly. Unit: m. Default: 0.0134 z_c."""
    @lead.setter
    def lead(self, value: float) -> None: ...
    @property
    def least_knee(self) -> float:
        """Smallest knee angle that the plan allows, so that no leg becomes straight. It leaves room for what the plan does not know: swing leg and pelvis move the hips against the COM. Unit: rad. Default: 0.3."""
    @least_knee.setter
    def least_knee(self, value: float) -> None: ...
    @property
    def crouch_limit(self) -> float:
        """How far the COM may come down so that the legs reach far enough for long steps. Unit: m. Default: 0.1 z_c."""
    @crouch_limit.setter
    def crouch_limit(self, value: float) -> None: ...
    @property
    def crouch_margin(self) -> float:
        """For long steps the COM comes down until the legs reach this many times as far as the feet are from under the hips in double support. Default: 1.2."""
    @crouch_margin.setter
    def crouch_margin(self, value: float) -> None: ...
    @property
    def crouch_time(self) -> float:
        """Time constant with which the COM comes down for long steps and rises after them. Unit: s. Default: 0.5 T_c."""
    @crouch_time.setter
    def crouch_time(self, value: float) -> None: ...

class ZmpSettings:
    """
    Where the ZMP may be, and how the reference ZMP is found that puts it there (III-B, III-D).
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ZmpSettings: ...
    def __deepcopy__(self, arg0: dict) -> ZmpSettings: ...
    def __eq__(self, arg0: ZmpSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def modification(self) -> bool:
        """Whether the estimated ZMP is kept inside its bounds (III-B, III-C). With false the planned velocity is tracked blindly. Default: True."""
    @modification.setter
    def modification(self, value: bool) -> None: ...
    @property
    def iteration(self) -> typing.Literal["closed_form", "loop", "none"]:
        """How the reference ZMP is found that puts the estimated ZMP where it is desired: in 'closed_form', or by the 'loop' that III-B prints. With 'none' the pendulum's ZMP is taken as it is, and the estimate changes nothing. One of 'closed_form', 'loop', 'none'. Default: 'closed_form'."""
    @iteration.setter
    def iteration(self, value: typing.Literal["closed_form", "loop", "none"]) -> None: ...
    @property
    def threshold(self) -> float:
        """The reference ZMP is good enough once the estimated ZMP is this near to the desired one (section IV). Unit: m. Default: 0.001."""
    @threshold.setter
    def threshold(self, value: float) -> None: ...
    @property
    def max_iterations(self) -> int:
        """Most passes of the loop of III-B in one control cycle, which then goes on with what it has. Default: 200."""
    @max_iterations.setter
    def max_iterations(self, value: int) -> None: ...
    @property
    def sole_fraction(self) -> float:
        """Share of the sole's length and width that the ZMP may use. The rest is a margin: a foot whose ZMP is at its edge tips. Default: 0.72."""
    @sole_fraction.setter
    def sole_fraction(self, value: float) -> None: ...
    @property
    def sole_exponent(self) -> float:
        """How much less of the sole's length the ZMP uses above cadence_speed: (cadence_speed / speed)^sole_exponent of it. At the sole's ends the contact of a fast walk chatters. Default: 0.5."""
    @sole_exponent.setter
    def sole_exponent(self, value: float) -> None: ...
    @property
    def ankle_torque_fraction(self) -> float:
        """Share of an ankle's torque limit that may hold the ZMP away from the ankle. Where ankles are weak this, not the sole, bounds the ZMP. Default: 0.9."""
    @ankle_torque_fraction.setter
    def ankle_torque_fraction(self, value: float) -> None: ...
    @property
    def bound_lateral(self) -> bool:
        """Whether the ZMP is kept inside its bounds sideways too. The paper bounds it forward only. Default: True."""
    @bound_lateral.setter
    def bound_lateral(self, value: bool) -> None: ...
    @property
    def lateral_law(self) -> typing.Literal["orbit", "paper"]:
        """Law by which the reference ZMP is shifted sideways from the middle of the sole that carries it (III-D). One of 'orbit', which shifts it so that the sway repeats; 'paper', which leaves it in the middle, so that an error at the start never decays. Default: 'orbit'."""
    @lateral_law.setter
    def lateral_law(self, value: typing.Literal["orbit", "paper"]) -> None: ...
    @property
    def lateral_shift(self) -> float:
        """Largest sideways shift of the reference ZMP that the lateral law may ask for, as a share of half the sole's width. Default: 1.6."""
    @lateral_shift.setter
    def lateral_shift(self, value: float) -> None: ...
    @property
    def whole_fraction(self) -> float:
        """Share of the sole's length and width that the ZMP may use when the robot has been pushed. It takes the place of sole_fraction as the DCM (COM + T_c times its velocity) leaves its plan. Default: 0.95."""
    @whole_fraction.setter
    def whole_fraction(self, value: float) -> None: ...
    @property
    def corner_cut(self) -> float:
        """Share of the sole's length that the ZMP gives up where it is at the sole's side: in a corner of the sole it would tip the foot. Default: 0.3."""
    @corner_cut.setter
    def corner_cut(self, value: float) -> None: ...

class TrackingSettings:
    """
    How the walk follows the planned velocity (III-C).
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> TrackingSettings: ...
    def __deepcopy__(self, arg0: dict) -> TrackingSettings: ...
    def __eq__(self, arg0: TrackingSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def law(self) -> typing.Literal["smooth", "bang_bang"]:
        """Law by which the COM's velocity follows the planned one. One of 'smooth', which accelerates in proportion to the error; 'bang_bang', which drives the ZMP to its bounds until the error is gone, as III-C is printed. Default: 'smooth'."""
    @law.setter
    def law(self, value: typing.Literal["smooth", "bang_bang"]) -> None: ...
    @property
    def gain(self) -> float:
        """How fast the smooth law makes up lost way: speed that it adds per metre behind the plan. Unit: 1/s. Default: 1.38 / T_c."""
    @gain.setter
    def gain(self, value: float) -> None: ...
    @property
    def time(self) -> float:
        """Time constant with which the smooth law removes an error of the speed. Unit: s. Default: 0.18 T_c."""
    @time.setter
    def time(self, value: float) -> None: ...
    @property
    def catch_up_speed(self) -> float:
        """Largest speed that the smooth law adds or takes away to make up lost or gained way. Feet cannot make up a long way in one step. Unit: m/s. Default: 0.03 sqrt(g z_c)."""
    @catch_up_speed.setter
    def catch_up_speed(self, value: float) -> None: ...
    @property
    def deadband(self) -> float:
        """How far the COM may be ahead of its plan or behind it before the bang-bang law drives it back. A drive ends a little beyond the plan, since time is discrete; without a deadband that would start the next drive. Unit: m. Default: 0.0002."""
    @deadband.setter
    def deadband(self, value: float) -> None: ...
    @property
    def regain_from(self) -> float:
        """How far the COM must be behind its plan, or ahead of it, before steps become longer or shorter to make up for it. A push can cost half a metre. Only with tied footsteps. Unit: m. Default: 0.08 z_c."""
    @regain_from.setter
    def regain_from(self, value: float) -> None: ...
    @property
    def regain_gain(self) -> float:
        """Speed that those steps add per metre beyond regain_from. Unit: 1/s. Default: 0.14 / T_c."""
    @regain_gain.setter
    def regain_gain(self, value: float) -> None: ...
    @property
    def regain_speed(self) -> float:
        """Largest speed that those steps add or take away. Unit: m/s. Default: 0.045 sqrt(g z_c)."""
    @regain_speed.setter
    def regain_speed(self, value: float) -> None: ...

class RateSettings:
    """
    How fast the planned velocity may change, whatever a profile or command asks for at once.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> RateSettings: ...
    def __deepcopy__(self, arg0: dict) -> RateSettings: ...
    def __eq__(self, arg0: RateSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def limit(self) -> bool:
        """Whether the planned velocity changes no faster than steps can follow. With false profiles and commands are taken as they are. Default: True."""
    @limit.setter
    def limit(self, value: bool) -> None: ...
    @property
    def forward_jump(self) -> float:
        """Change of the forward velocity v_x that is taken up at once. A larger one follows at forward_acceleration or forward_deceleration. Unit: m/s. Default: 0.036 sqrt(g z_c)."""
    @forward_jump.setter
    def forward_jump(self, value: float) -> None: ...
    @property
    def sideways_jump(self) -> float:
        """Change of the sideways velocity v_y that is taken up at once. A larger one follows at sideways_acceleration. Unit: m/s. Default: 0.0."""
    @sideways_jump.setter
    def sideways_jump(self, value: float) -> None: ...
    @property
    def turning_jump(self) -> float:
        """Change of the turning velocity w_z that is taken up at once. A larger one follows at turning_acceleration. Unit: rad/s. Default: 0.07 / T_c."""
    @turning_jump.setter
    def turning_jump(self, value: float) -> None: ...
    @property
    def forward_acceleration(self) -> float:
        """Rate at which the forward velocity v_x moves away from zero. Unit: m/s^2. Default: 0.02 g."""
    @forward_acceleration.setter
    def forward_acceleration(self, value: float) -> None: ...
    @property
    def forward_deceleration(self) -> float:
        """Rate at which the forward velocity v_x goes back to zero. Unit: m/s^2. Default: 0.056 g."""
    @forward_deceleration.setter
    def forward_deceleration(self, value: float) -> None: ...
    @property
    def sideways_acceleration(self) -> float:
        """Rate at which the sideways velocity v_y changes. Unit: m/s^2. Default: 0.025 g."""
    @sideways_acceleration.setter
    def sideways_acceleration(self, value: float) -> None: ...
    @property
    def turning_acceleration(self) -> float:
        """Rate at which the turning velocity w_z changes. Unit: rad/s^2. Default: 0.08 / T_c^2."""
    @turning_acceleration.setter
    def turning_acceleration(self, value: float) -> None: ...

class TrunkSettings:
    """
    How the trunk is kept upright and along the path.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> TrunkSettings: ...
    def __deepcopy__(self, arg0: dict) -> TrunkSettings: ...
    def __eq__(self, arg0: TrunkSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def kp(self) -> float:
        """Stiffness of the trunk's orientation: angular acceleration per angle of error. Unit: 1/s^2. Default: 300 (0.276 s / T_c)^2."""
    @kp.setter
    def kp(self, value: float) -> None: ...
    @property
    def kd(self) -> float:
        """Damping of the trunk's orientation: angular acceleration per error of angular velocity. Unit: 1/s. Default: 35 (0.276 s / T_c)."""
    @kd.setter
    def kd(self, value: float) -> None: ...
    @property
    def yields(self) -> bool:
        """Whether the trunk of a robot that has been pushed comes back upright slowly. A trunk that is held stiffly takes the ZMP away from where it would hold the DCM (COM + T_c times its velocity), and turns the standing foot. Default: True."""
    @yields.setter
    def yields(self, value: bool) -> None: ...

class PostureSettings:
    """
    How the joints outside the legs (waist, arms, head) are moved.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> PostureSettings: ...
    def __deepcopy__(self, arg0: dict) -> PostureSettings: ...
    def __eq__(self, arg0: PostureSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def task(self) -> bool:
        """Whether the joints outside the legs are controlled. With false their motion is left to the torque of least norm. Default: True."""
    @task.setter
    def task(self, value: bool) -> None: ...
    @property
    def kp(self) -> float:
        """Stiffness of the joints outside the legs: acceleration per angle of error. Unit: 1/s^2. Default: 100 (0.276 s / T_c)^2."""
    @kp.setter
    def kp(self, value: float) -> None: ...
    @property
    def kd(self) -> float:
        """Damping of the joints outside the legs: acceleration per error of joint velocity. Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @kd.setter
    def kd(self, value: float) -> None: ...
    @property
    def motion_blend(self) -> float:
        """Time in which a new joint motion takes over from the one before it. Unit: s. Default: 1.8 T_c."""
    @motion_blend.setter
    def motion_blend(self, value: float) -> None: ...

class ArmsSettings:
    """
    How the arms swing so that the robot does not turn about the vertical.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ArmsSettings: ...
    def __deepcopy__(self, arg0: dict) -> ArmsSettings: ...
    def __eq__(self, arg0: ArmsSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def momentum(self) -> float:
        """Share of the yaw momentum of legs and trunk that the arms cancel by swinging, 0 to 1. Joints that a motion names do not swing. Default: 0.0."""
    @momentum.setter
    def momentum(self, value: float) -> None: ...
    @property
    def kp(self) -> float:
        """Stiffness of the spring that brings swinging arms back to their posture: acceleration per angle. Unit: 1/s^2. Default: 20 (0.276 s / T_c)^2."""
    @kp.setter
    def kp(self, value: float) -> None: ...
    @property
    def kd(self) -> float:
        """Rate at which swinging arms bring the robot's yaw momentum to zero. Unit: 1/s. Default: 20 (0.276 s / T_c)."""
    @kd.setter
    def kd(self, value: float) -> None: ...
    @property
    def reserve(self) -> float:
        """Share of the yaw momentum that the arms cancel, where this is more than momentum, while the yaw friction of a sole holds the torque back, so that the foot does not spin. With 0 they never help. Default: 1.0."""
    @reserve.setter
    def reserve(self, value: float) -> None: ...
    @property
    def reserve_time(self) -> float:
        """Time in which the arms return to their posture once the soles hold the yaw moment again. They come to help in a tenth of it. Unit: s. Default: 2 T_c."""
    @reserve_time.setter
    def reserve_time(self, value: float) -> None: ...

class ContactSettings:
    """
    How the feet that stand carry the robot.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ContactSettings: ...
    def __deepcopy__(self, arg0: dict) -> ContactSettings: ...
    def __eq__(self, arg0: ContactSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def wrench_distribution(self) -> bool:
        """Whether two standing feet share the load by the place of the ZMP between them. With false the torque of least norm decides, which ignores that feet cannot pull. Default: True."""
    @wrench_distribution.setter
    def wrench_distribution(self, value: bool) -> None: ...
    @property
    def load_alone(self) -> float:
        """In double support one foot carries everything while the ZMP is this near to its centre line, in half sole widths. A foot that has just landed would chatter under a light load. Default: 0.7."""
    @load_alone.setter
    def load_alone(self, value: float) -> None: ...
    @property
    def damping(self) -> float:
        """Damping of the velocity of a standing foot that does not carry the ZMP. Without a load it would drift off the ground. Unit: 1/s. Default: 100.0."""
    @damping.setter
    def damping(self, value: float) -> None: ...

class ControlSettings:
    """
    How the torque is computed, how often, and within which limits.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ControlSettings: ...
    def __deepcopy__(self, arg0: dict) -> ControlSettings: ...
    def __eq__(self, arg0: ControlSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def dt(self) -> float:
        """Control period: a new torque is computed this often and held in between. It must be a multiple of the model's time step. Unit: s. Default: the model's time step."""
    @dt.setter
    def dt(self, value: float) -> None: ...
    @property
    def textbook(self) -> bool:
        """Whether equations (1) to (13) are computed as printed instead of on the direct path. It is slower and gives the same numbers. Default: False."""
    @textbook.setter
    def textbook(self, value: bool) -> None: ...
    @property
    def singular_damping(self) -> float:
        """Damping that keeps the joints' motion bounded where a leg is straight. Default: 0.001."""
    @singular_damping.setter
    def singular_damping(self, value: float) -> None: ...
    @property
    def singular_pivot(self) -> float:
        """Smallest pivot of a leg's equations below which that leg counts as straight. Default: 0.01."""
    @singular_pivot.setter
    def singular_pivot(self, value: float) -> None: ...
    @property
    def singular_task(self) -> float:
        """How far a task of your own may be from impossible before it is met in part only: the motion that it asks for is damped in directions in which the joints outside the legs move it by less than this share of its size. So it stays bounded where an arm is stretched out. With 0 nothing is damped. Default: 0.005."""
    @singular_task.setter
    def singular_task(self, value: float) -> None: ...
    @property
    def friction_velocity(self) -> float:
        """Joint speed below which dry friction is taken as proportional to the speed, so that it does not jump where a joint turns around. Unit: rad/s. Default: 0.02."""
    @friction_velocity.setter
    def friction_velocity(self, value: float) -> None: ...
    @property
    def kernel(self) -> str:
        """Build of the inner loops: 'auto' takes the best that this processor runs, and build_info()['kernels'] names those that there are. They agree to rounding. Default: 'auto'."""
    @kernel.setter
    def kernel(self, value: str) -> None: ...
    @property
    def torque_limits(self) -> dict[str, float]:
        """Torque limits by joint name, in place of the robot's own. A motor still gives no more than the model lets through. Unit: N m. Default: {}."""
    @torque_limits.setter
    def torque_limits(self, value: typing.Mapping[str, float]) -> None: ...

class LimitsSettings:
    """
    What a torque must keep to: the joints' torques and ranges, and what the soles can hold.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> LimitsSettings: ...
    def __deepcopy__(self, arg0: dict) -> LimitsSettings: ...
    def __eq__(self, arg0: LimitsSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def keep(self) -> bool:
        """Whether the nearest torque that keeps the limits is found where the closed form's torque would break one: the tasks give way, first the swing foot, then the trunk, the COM's height, and last its horizontal acceleration. With false torques are cut to their limits, and nothing else is kept. Default: True."""
    @keep.setter
    def keep(self, value: bool) -> None: ...
    @property
    def friction(self) -> float:
        """Friction of the soles: tangential force per normal force that they can hold. Default: that of the soles in the model."""
    @friction.setter
    def friction(self, value: float) -> None: ...
    @property
    def feel_slip(self) -> bool:
        """Whether a sole that slides while it carries lowers the friction that is believed, and with it the planned speed. With true the robot walks on over ice; but soles that slide a little as they land, as they do where the measured attitude is off by 2 degrees, pass for slipping ones, and it slows down. Default: False."""
    @feel_slip.setter
    def feel_slip(self, value: bool) -> None: ...
    @property
    def twist(self) -> float:
        """Moment about the vertical that a sole may give, as a share of what its friction holds while it turns about its centre. With more than 1 the foot turns a little where it must. Default: 1.0."""
    @twist.setter
    def twist(self, value: float) -> None: ...
    @property
    def range_margin(self) -> float:
        """How far from the ends of its range a joint comes to rest. Unit: rad. Default: 0.0."""
    @range_margin.setter
    def range_margin(self, value: float) -> None: ...
    @property
    def range_rate(self) -> float:
        """How fast a joint may still move towards the end of its range: it comes to rest there as a critically damped joint of this damping does. A small rate brakes early. Unit: 1/s. Default: 120 (0.276 s / T_c)."""
    @range_rate.setter
    def range_rate(self, value: float) -> None: ...

class ObserverSettings:
    """
    What the controller finds out about what it does not know: steady forces, wrong masses, a biased attitude, noise.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> ObserverSettings: ...
    def __deepcopy__(self, arg0: dict) -> ObserverSettings: ...
    def __eq__(self, arg0: ObserverSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def on(self) -> bool:
        """Whether the walk makes up for steady forces, wrong masses, and noise or bias of the measured attitude. A walk that knows everything keeps its bits. Default: True."""
    @on.setter
    def on(self, value: bool) -> None: ...
    @property
    def time(self) -> float:
        """Time constant with which a disturbance is found: an acceleration of the COM that the command does not explain. Where the measured speed is noisy, it grows up to four times. Unit: s. Default: 0.18 T_c."""
    @time.setter
    def time(self, value: float) -> None: ...
    @property
    def speed_noise(self) -> float:
        """Change of the COM's speed from cycle to cycle that the command does not explain, as root of its mean square, up to which the speed counts as measured without noise. Unit: m/s. Default: 0.0092 sqrt(g z_c)."""
    @speed_noise.setter
    def speed_noise(self, value: float) -> None: ...
    @property
    def tolerance(self) -> float:
        """A disturbance is made up for where it is larger than this, and less by this: contacts that give way a little are none. Unit: m/s^2. Default: 0.015 g."""
    @tolerance.setter
    def tolerance(self, value: float) -> None: ...
    @property
    def force_most(self) -> float:
        """Most that is made up for of a steady horizontal disturbance, along either axis. Unit: m/s^2. Default: 0.13 g."""
    @force_most.setter
    def force_most(self, value: float) -> None: ...
    @property
    def weight_most(self) -> float:
        """Most that the robot is taken to be heavier or lighter than its model says, as a share of its mass. Default: 0.35."""
    @weight_most.setter
    def weight_most(self, value: float) -> None: ...
    @property
    def push(self) -> float:
        """A horizontal disturbance that is larger than this is a push and not steady: what was found before it is held. Unit: m/s^2. Default: 0.16 g."""
    @push.setter
    def push(self, value: float) -> None: ...
    @property
    def attitude_time(self) -> float:
        """Time constant with which a noisy attitude of the base corrects the one that its angular velocity leads to. Unit: s. Default: 1.1 T_c."""
    @attitude_time.setter
    def attitude_time(self, value: float) -> None: ...
    @property
    def attitude_noise(self) -> float:
        """Angle between the measured attitude and the one that the angular velocity leads to from the cycle before, as root of its mean square, up to which the attitude is taken as it is measured. Unit: rad. Default: 0.001."""
    @attitude_noise.setter
    def attitude_noise(self, value: float) -> None: ...
    @property
    def bias_time(self) -> float:
        """Time constant with which a bias of the measured attitude is found. Unit: s. Default: 1.8 T_c."""
    @bias_time.setter
    def bias_time(self, value: float) -> None: ...
    @property
    def bias_most(self) -> float:
        """Most that is made up for of a bias of the measured attitude. Unit: rad. Default: 0.09."""
    @bias_most.setter
    def bias_most(self, value: float) -> None: ...
    @property
    def sole_tilt(self) -> float:
        """Tilt of the standing sole from level that shows no bias yet: contacts give way a little. Unit: rad. Default: 0.004."""
    @sole_tilt.setter
    def sole_tilt(self, value: float) -> None: ...

class CommandSettings:
    """
    Which velocities may be commanded.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> CommandSettings: ...
    def __deepcopy__(self, arg0: dict) -> CommandSettings: ...
    def __eq__(self, arg0: CommandSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def limit(self) -> bool:
        """Whether commands and profiles are kept within what the torques of the legs and the friction under the soles give. With false only the reach of the legs limits them. Default: True."""
    @limit.setter
    def limit(self, value: bool) -> None: ...
    @property
    def share(self) -> float:
        """Share of those torques and that friction that a commanded velocity may use. More than 1 allows faster walks, which cut torques and slide. Default: 1.0."""
    @share.setter
    def share(self, value: float) -> None: ...

class FallSettings:
    """
    What counts as a fall, when one is foreseen, and what the robot does then.
    """

    __hash__: typing.ClassVar[None] = None
    def __copy__(self) -> FallSettings: ...
    def __deepcopy__(self, arg0: dict) -> FallSettings: ...
    def __eq__(self, arg0: FallSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        The group's settings by name, as plain Python values.
        """
    @property
    def height(self) -> float:
        """The robot has fallen where its COM is less high over the support foot than this share of its height at the start. Default: 0.8."""
    @height.setter
    def height(self, value: float) -> None: ...
    @property
    def tilt(self) -> float:
        """The robot has fallen where its trunk tilts by more than this. Unit: rad. Default: 0.8."""
    @tilt.setter
    def tilt(self, value: float) -> None: ...
    @property
    def foot_tilt(self) -> float:
        """A fall is foreseen where the only foot that stands tilts by more than this, as it tips over its edge. Unit: rad. Default: 0.45."""
    @foot_tilt.setter
    def foot_tilt(self, value: float) -> None: ...
    @property
    def foresee(self) -> bool:
        """Whether a fall is foreseen: it is certain once no foothold within reach, and no time of landing, can catch the DCM (COM + T_c times its velocity) any more. Default: True."""
    @foresee.setter
    def foresee(self, value: bool) -> None: ...
    @property
    def crouch(self) -> bool:
        """Whether the robot crouches once a fall is foreseen: the legs bend and every joint is damped, until the walk is started anew. With false it walks on as if nothing were foreseen. Default: True."""
    @crouch.setter
    def crouch(self, value: bool) -> None: ...
    @property
    def margin(self) -> float:
        """How far the DCM must be beyond what any foothold within reach can catch before the fall counts as certain. Trunk, arms and what the pendulum does not know may bring back that much. Unit: m. Default: 0.03 z_c."""
    @margin.setter
    def margin(self, value: float) -> None: ...
    @property
    def confirm_time(self) -> float:
        """How long the DCM must be that far off without a break before the fall counts as certain: a noisy measurement alone fells nobody. Unit: s. Default: 0.04 T_c."""
    @confirm_time.setter
    def confirm_time(self, value: float) -> None: ...

class VelocityProfile:
    """
    Planned velocity of the COM over time, (v_x, v_y, w_z) in the heading frame [m/s, m/s, rad/s].
    """
    def __init__(
        self,
        t: collections.abc.Sequence[typing.SupportsFloat | typing.SupportsIndex],
        v: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        interpolation: str = "hold",
    ) -> None:
        """
        Args:
            t: knot times (n,) [s], from 0, increasing.
            v: velocities (n, 3).
            interpolation: 'hold' or 'linear'.

        Raises:
            InputError, DimensionError.
        """
    def __reduce__(self) -> typing.Any: ...
    def displacement(
        self, t0: typing.SupportsFloat | typing.SupportsIndex, t1: typing.SupportsFloat | typing.SupportsIndex
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Integral of the velocity from t0 to t1 (3,) [m, m, rad].
        """
    def travel(
        self, t0: typing.SupportsFloat | typing.SupportsIndex, t1: typing.SupportsFloat | typing.SupportsIndex
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Where a frame that moves with this velocity is at t1, seen from where it is at t0: (x, y, yaw) (3,).
        """
    def velocity(
        self, t: typing.SupportsFloat | typing.SupportsIndex
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Velocity (3,) at time t [s]; after the last knot it stays as there.
        """
    @property
    def interpolation(self) -> str: ...
    @property
    def max_speed(self) -> float:
        """
        Largest |(v_x, v_y)| [m/s].
        """
    @property
    def t(self) -> list[float]:
        """
        Knot times [s].
        """
    @property
    def v(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        Knot velocities (n, 3).
        """

class Foot:
    """
    One flat foot: body, sole frame and size, and the six joints of its leg, hip to ankle.
    """
    def __getstate__(
        self,
    ) -> tuple[
        str,
        str,
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"],
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"],
        float,
        float,
        list[str],
    ]: ...
    def __init__(
        self,
        *,
        body: str,
        sole_site: str = "",
        sole_pos: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        sole_quat: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"] = ...,
        length: typing.SupportsFloat | typing.SupportsIndex,
        width: typing.SupportsFloat | typing.SupportsIndex,
        leg_joints: collections.abc.Sequence[str],
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    @property
    def body(self) -> str:
        """
        body that carries the sole
        """
    @property
    def leg_joints(self) -> list[str]:
        """
        six joint names, hip to ankle
        """
    @property
    def length(self) -> float:
        """
        of the sole [m]
        """
    @property
    def sole_pos(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        sole centre in the body's frame (3,) [m]
        """
    @property
    def sole_quat(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"]:
        """
        sole axes in the body's frame (w, x, y, z)
        """
    @property
    def sole_site(self) -> str:
        """
        site at the sole's centre, or ''
        """
    @property
    def width(self) -> float:
        """
        of the sole [m]
        """

class RobotDescription:
    """
    Everything that the controller has to be told about a robot in a model. Bodies, joints and sites are named.
    """
    @staticmethod
    def __repr__(description: RobotDescription) -> str: ...
    @staticmethod
    def _repr_html_(description: RobotDescription) -> str: ...
    def __getstate__(
        self,
    ) -> tuple[
        str,
        str,
        Foot,
        Foot,
        dict[str, float],
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"],
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"],
        str,
        dict[str, float],
    ]: ...
    def __init__(
        self,
        *,
        name: str,
        root_joint: str,
        left: Foot,
        right: Foot,
        stand_joints: collections.abc.Mapping[str, typing.SupportsFloat | typing.SupportsIndex],
        stand_base_pos: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        stand_base_quat: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[4, 1]"] = ...,
        stand_keyframe: str = "",
        torque_limits: collections.abc.Mapping[str, typing.SupportsFloat | typing.SupportsIndex] = {},
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def check(self, model: typing.Any) -> None:
        """
        Raises ModelError unless this robot is in `model` and can walk.
        """
    def drives(self, model: typing.Any) -> dict:
        """
        By joint name: torque limit [N m], infinite without, and the way that the torque takes into MuJoCo (see WalkingController.torque_path).

        Raises:
            ModelError: as check().
        """
    def place(
        self, model: typing.Any, data: typing.Any, ground: typing.SupportsFloat | typing.SupportsIndex | None = None
    ) -> None:
        """
        Puts the robot into its start pose, at rest; only its own qpos and qvel change.

        Args:
            ground: height of the soles [m]; None has them where the description does (z = 0), or on the floor where that is higher.

        Raises:
            ModelError: as check().
        """
    def stand_ahead(self, model: typing.Any) -> float:
        """
        How far ahead of the middle between the soles' centres the COM stands with the default settings, so that the ZMP has room ahead and behind [m]; 0 where the soles alone bound it.

        Raises:
            ModelError: as check().
            InputError: soles and ankles leave no room for the ZMP.
        """
    @property
    def left(self) -> Foot:
        """
        the left foot, a `Foot`
        """
    @property
    def name(self) -> str:
        """
        what the robot is called in figures and traces
        """
    @property
    def right(self) -> Foot:
        """
        the right foot, a `Foot`
        """
    @property
    def root_joint(self) -> str:
        """
        the free joint; empty where the model does not name it
        """
    @property
    def stand_base_pos(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        base position, soles on z = 0 (3,) [m]
        """
    @property
    def stand_base_quat(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"]:
        """
        base orientation (w, x, y, z)
        """
    @property
    def stand_joints(self) -> dict[str, float]:
        """
        start posture by joint name [rad or m]
        """
    @property
    def stand_keyframe(self) -> str:
        """
        keyframe of the model that the start posture was read from; empty where it was given in numbers
        """
    @property
    def torque_limits(self) -> dict[str, float]:
        """
        by joint name, in place of the model's [N m]
        """

class LegParts:
    """
    A leg by MuJoCo's numbers: its foot's body, and its joints from hip to ankle.
    """
    def __init__(
        self,
        *,
        foot: typing.SupportsInt | typing.SupportsIndex,
        joints: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex],
        side: str = "",
        sole: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"] | None = None,
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def foot(self) -> int:
        """
        body that carries the sole
        """
    @property
    def joints(self) -> list[int]:
        """
        joints, hip to ankle
        """
    @property
    def side(self) -> str:
        """
        'left', 'right', or '' where it is not known yet
        """
    @property
    def sole(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"] | None:
        """
        length and width of the sole (2,) [m], or None where they are not known yet
        """

class RobotParts:
    """
    A robot by MuJoCo's numbers: what the rules about its tree look at.
    """
    def __init__(
        self,
        *,
        root_body: typing.SupportsInt | typing.SupportsIndex,
        legs: collections.abc.Sequence[LegParts],
        forward: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...,
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def forward(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        its level direction (3,), world; zero where it is not known yet
        """
    @property
    def legs(self) -> list[LegParts]:
        """
        two LegParts
        """
    @property
    def root_body(self) -> int:
        """
        outermost body of its tree
        """

class FrameState:
    """
    A frame on the robot, such as a sole's: origin at its centre, x forward, z up. World axes.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def J(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, n]"]:
        """
        (6, nv), linear rows first
        """
    @J.setter
    def J(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, n]"]) -> None: ...
    @property
    def R_WF(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        rotation (3, 3)
        """
    @R_WF.setter
    def R_WF(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]) -> None: ...
    @property
    def drift(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        Jdot dq (6,)
        """
    @drift.setter
    def drift(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...
    @property
    def p_WF(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        position (3,) [m]
        """
    @p_WF.setter
    def p_WF(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        linear, angular (6,) = J dq
        """
    @velocity.setter
    def velocity(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...

class Dynamics:
    """
    All that equations 1-15 need to know of a robot at one instant; plain arrays, no simulator.

    A ddq + b + g + J_c' f_c = S' tau, f_c the wrench of the robot on the ground.
    """
    def __copy__(self) -> Dynamics: ...
    def __init__(self, nv: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def A(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        inertia (nv, nv), row-major view
        """
    @A.setter
    def A(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"]) -> None: ...
    @property
    def J_com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, n]"]:
        """
        (3, nv)
        """
    @J_com.setter
    def J_com(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, n]"]) -> None: ...
    @property
    def R_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        base rotation (3, 3)
        """
    @R_WB.setter
    def R_WB(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]) -> None: ...
    @property
    def b(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        velocity terms and passive forces (nv,)
        """
    @b.setter
    def b(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m]
        """
    @com.setter
    def com(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def dcom(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m/s]
        """
    @dcom.setter
    def dcom(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def dq(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        velocities (nv,)
        """
    @dq.setter
    def dq(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def drift_com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Jdot dq of the COM (3,)
        """
    @drift_com.setter
    def drift_com(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def frames(self) -> list[FrameState]:
        """
        a list of FrameState: the frames that are watched (a copy)
        """
    @property
    def g(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        gravity (nv,)
        """
    @g.setter
    def g(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def gravity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        acceleration of gravity (3,) [m/s^2]
        """
    @gravity.setter
    def gravity(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def joints(self) -> int:
        """
        joints, nv - 6
        """
    @property
    def left(self) -> FrameState:
        """
        left sole
        """
    @property
    def mass(self) -> float:
        """
        [kg]
        """
    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def nv(self) -> int:
        """
        velocities: 6 of the base, and one of each joint
        """
    @property
    def omega_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        base angular velocity, world axes (3,)
        """
    @omega_WB.setter
    def omega_WB(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def p_WB(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        base position (3,)
        """
    @p_WB.setter
    def p_WB(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        joint positions (joints,)
        """
    @q.setter
    def q(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def right(self) -> FrameState:
        """
        right sole
        """

class Robot:
    """
    One robot in a MuJoCo model; it reads mjData into Dynamics.
    """
    def __init__(self, model: typing.Any, description: RobotDescription) -> None:
        """
        Raises:
            ModelError: the robot cannot walk.
        """
    def __reduce__(self) -> typing.Any: ...
    def read(self, data: typing.Any) -> Dynamics:
        """
        Dynamics of the state in `data` (a copy).

        Raises:
            InputError: the state is not finite.
        """
    @property
    def dof_address(self) -> int:
        """
        of the free joint in qvel
        """
    @property
    def joint_names(self) -> list[str]:
        """
        names of the joints, in the order of torques and joint velocities
        """
    @property
    def leg_joints(self) -> typing.Annotated[list[list[int]], "FixedSize(2)"]:
        """
        joint indices of the two legs, hip to ankle
        """
    @property
    def qpos_address(self) -> int:
        """
        of the free joint in qpos
        """
    @property
    def torque_limit(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (joints,) [N m]
        """
    @property
    def torque_path(self) -> dict:
        """
        how each joint's torque reaches MuJoCo, by joint name: "motor 'l_knee'", "qfrc_applied: position servo 'l_knee' is silenced", ...
        """

class JointMotion:
    """
    Scripted references of joints and trunk: a cubic spline with continuous acceleration.
    """
    def __init__(
        self,
        t: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        names: collections.abc.Sequence[str],
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
    ) -> None:
        """
        Args:
            t: knot times (n,) [s], from 0, increasing.
            names: joint of each column (m,).
            q: positions at the knots (n, m) [rad or m].

        Raises:
            InputError, DimensionError.
        """
    def __reduce__(self) -> typing.Any: ...
    def at(
        self, t: typing.SupportsFloat | typing.SupportsIndex
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        Position, velocity and acceleration (3, m) at time t [s]; the last position holds.
        """
    @property
    def duration(self) -> float:
        """
        Time of the last knot [s].
        """
    @property
    def names(self) -> list[str]:
        """
        Joint of each column.
        """
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        Positions at the knots (n, m) [rad or m].
        """
    @property
    def t(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Knot times (n,) [s].
        """

class ContactSpace:
    """
    How joint torques act on the ground through the standing feet: the contact space, eq. 2 and 9-13.
    """
    def __init__(
        self,
        A: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        g: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        J_c: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        drift_c: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None:
        """
        Args:
            A: inertia (nv, nv).
            b, g: velocity and gravity terms (nv,).
            J_c: (6 k, nv).
            drift_c: Jdot_c dq (6 k,).

        Raises:
            DimensionError.
        """
    def __reduce__(self) -> typing.Any: ...
    def wrench(
        self, tau: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Eq. 9: wrench of the robot on the ground (m,) for joint torque (joints,) [N m].
        """
    @property
    def Jbar_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        dynamically consistent inverse of J_c, eq. 13 (nv, m)
        """
    @property
    def Lambda_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        contact inertia, eq. 10 (m, m)
        """
    @property
    def N_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        contact null space, eq. 2 (nv, nv)
        """
    @property
    def mu_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        velocity forces in contact space, eq. 11 (m,)
        """
    @property
    def p_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        gravity in contact space, eq. 12 (m,)
        """

class TaskSpace:
    """
    Equations 1 and 3-7 as they are printed, (7) corrected: their definition, which is slow.
    """
    def __init__(
        self,
        contact: ContactSpace,
        b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        g: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        J: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        drift: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None:
        """
        Args:
            contact: ContactSpace of the same instant.
            b, g: (nv,).
            J: stacked task Jacobian (m, nv).
            drift: Jdot dq (m,).

        Raises:
            DimensionError; InputError: the tasks conflict.
        """
    def __reduce__(self) -> typing.Any: ...
    def force(
        self, f_star: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Eq. 1: task force (m,) for commanded acceleration (m,).
        """
    def torque(
        self, F: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Eq. 7: joint torque (joints,) for task force (m,).
        """
    @property
    def J_k(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        modified task Jacobian (m, joints)
        """
    @property
    def Jbar(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        dynamically consistent inverse of J, eq. 4 (nv, m)
        """
    @property
    def Lambda(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        task inertia under contact, eq. 3 (m, m)
        """
    @property
    def N_k(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        a joint torque that is multiplied by it leaves the tasks alone (joints, joints)
        """
    @property
    def V_n(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        torques that change nothing but the contact wrenches (joints, m_c - 6)
        """
    @property
    def mu(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        velocity forces in task space, eq. 5 (m,)
        """
    @property
    def p(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        gravity in task space, eq. 6 (m,)
        """

class Plane:
    """
    A plane in the world: the points p with normal . p = offset.
    """

    __hash__: typing.ClassVar[None] = None
    @staticmethod
    def through(
        p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        normal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = (0, 0, 1),
    ) -> Plane:
        """
        The plane through `p` (3,) [m] with that normal; level by default.
        """
    def __eq__(self, arg0: Plane) -> bool: ...
    def __getstate__(self) -> tuple[typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"], float]: ...
    def __init__(
        self,
        normal: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = (0, 0, 1),
        offset: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> None:
        """
        Level ground at z = 0 by default. A column zmp_plane gives both: Plane(row[:3], row[3]).

        Args:
            normal: (3,), pointing up, of any length.
            offset: normal . p of the plane's points p [m].

        Raises:
            InputError: a number is not finite, or the normal does not point up.
        """
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def distance(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> float:
        """
        Distance of `p` (3,) from the plane, positive above it [m].
        """
    def height(self, xy: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> float:
        """
        Height of the plane at world x and y `xy` (2,) [m].
        """
    def project(
        self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        The point of the plane that is nearest to `p` (3,) [m].
        """
    @property
    def normal(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        of length 1 (3,)
        """
    @property
    def offset(self) -> float:
        """
        distance from the world's origin along the normal [m]
        """

class Contact:
    """
    A foot on the ground: where its sole is, what it stands on, and how large and how rough it is.
    """
    def __init__(
        self,
        p_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        R_WF: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"],
        standing: bool = True,
        ground: Plane = ...,
        length: typing.SupportsFloat | typing.SupportsIndex = ...,
        width: typing.SupportsFloat | typing.SupportsIndex = ...,
        friction: typing.SupportsFloat | typing.SupportsIndex = ...,
    ) -> None:
        """
        Args:
            p_WF: sole centre (3,) [m].
            R_WF: sole axes (3, 3), x forward, z out of the ground.
            standing: False where the foot swings.
            ground: Plane under it.
            length, width: of the sole [m]; NaN: unknown.
            friction: tangential force per normal force that does not slip yet; NaN: unknown.
        """
    def __reduce__(self) -> typing.Any: ...
    def can_carry(self, f: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> bool:
        """
        True where the sole can give this wrench (6,), robot on ground: pressed, its centre of pressure on the sole, within friction.
        """
    def cop(
        self, f: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Centre of pressure of a wrench (6,) about the sole's centre, world axes: from that centre, sole axes (2,) [m].
        """
    def to_sole(
        self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        The point of the sole plane with world x and y `p` (2,), from the sole's centre, sole axes (2,) [m].
        """
    def to_world(
        self, p_F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        World x and y of the point of the sole that is `p_F` (2,) from its centre, sole axes (2,) [m].
        """
    @property
    def R_WF(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        sole axes (3, 3)
        """
    @R_WF.setter
    def R_WF(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]) -> None: ...
    @property
    def friction(self) -> float:
        """
        tangential force per normal force that does not slip yet
        """
    @friction.setter
    def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def ground(self) -> Plane:
        """
        Plane under it
        """
    @ground.setter
    def ground(self, arg0: Plane) -> None: ...
    @property
    def length(self) -> float:
        """
        of the sole along its x [m]
        """
    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def p_WF(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        sole centre (3,) [m]
        """
    @p_WF.setter
    def p_WF(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def standing(self) -> bool:
        """
        False where the foot swings
        """
    @standing.setter
    def standing(self, arg0: bool) -> None: ...
    @property
    def width(self) -> float:
        """
        of the sole along its y [m]
        """
    @width.setter
    def width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class KnownGround:
    """
    Ground that the user knows: a height for each place, from plane patches or from heights on a grid.

    Where patches overlap, the highest one counts. Between the points of a grid heights are bilinear. KnownGround() knows nothing.
    """
    @staticmethod
    def of_grid(
        corner: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        spacing: typing.SupportsFloat | typing.SupportsIndex,
        heights: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"],
    ) -> KnownGround:
        """
        Args:
            corner: world x and y of heights[0, 0] (2,) [m].
            spacing: between points [m].
            heights: rows along x, columns along y [m].

        Raises:
            InputError: fewer than two rows or columns, a spacing that is not positive, a number that is not finite.
        """
    @staticmethod
    def of_patches(patches: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, n]"]) -> KnownGround:
        """
        Args:
            patches: (n, 7), each (x_0, x_1, y_0, y_1, height, rise_x, rise_y): a rectangle along the world's axes [m], the
                height of its middle [m], and how much higher it becomes per metre along x and along y.

        Raises:
            InputError: a number is not finite, or a patch has no area.
        """
    def __init__(self) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def height(self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> float:
        """
        Height at world x and y `p` (2,) [m]; not-a-number where there is no ground.
        """
    def rise(
        self, p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        How much higher the ground becomes per metre along x and along y, at world x and y `p` (2,).
        """
    @property
    def corner(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        of a grid (2,) [m]
        """
    @property
    def heights(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        of a grid [m]; empty for patches
        """
    @property
    def known(self) -> bool:
        """
        whether anything is known
        """
    @property
    def patches(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        the patches as `of_patches` takes them, (n, 7); none of a grid
        """
    @property
    def spacing(self) -> float:
        """
        of a grid [m]
        """

class Task:
    """
    Something that the robot is to do while it walks.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def priority(self) -> int:
        """
        a task with a smaller number comes first
        """
    @priority.setter
    def priority(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    @property
    def weight(self) -> float:
        """
        share of its correction that is applied, 0 to 1
        """
    @weight.setter
    def weight(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class PoseReference:
    """
    Where a frame is to be and how it is to move there, in the frame that it is relative to.
    """
    def __init__(
        self,
        p: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"] = ...,
        R: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"] = ...,
        velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"] = ...,
        acceleration: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"] = ...,
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def R(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 3]"]:
        """
        orientation (3, 3)
        """
    @R.setter
    def R(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 3]"]) -> None: ...
    @property
    def acceleration(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        linear, angular (6,), fed forward [m/s^2, rad/s^2]
        """
    @acceleration.setter
    def acceleration(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...
    @property
    def p(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        position (3,) [m]
        """
    @p.setter
    def p(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        linear, angular (6,) [m/s, rad/s]
        """
    @velocity.setter
    def velocity(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...

class FrameTask(Task):
    """
    The frame of a body or a site follows a pose.
    """
    def __init__(
        self,
        frame: str,
        part: str = "pose",
        relative_to: str = "world",
        kp: typing.SupportsFloat | typing.SupportsIndex = 400.0,
        kd: typing.SupportsFloat | typing.SupportsIndex = 40.0,
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def follow(self, reference: collections.abc.Callable[[float], PoseReference]) -> None:
        """
        The reference is a function of the time since the task began [s] that returns a PoseReference.
        """
    def set(self, reference: PoseReference) -> None:
        """
        From the next cycle on, the reference is this one.
        """
    @property
    def reference(self) -> PoseReference:
        """
        the reference of the last cycle
        """

class JointTask(Task):
    """
    Joints outside the legs follow references.
    """
    def __init__(
        self,
        joints: collections.abc.Sequence[str],
        kp: typing.SupportsFloat | typing.SupportsIndex = 400.0,
        kd: typing.SupportsFloat | typing.SupportsIndex = 40.0,
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def follow(self, motion: JointMotion) -> None:
        """
        The references follow `motion` from when the task begins.
        """
    def set(
        self,
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        dq: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        ddq: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None:
        """
        From the next cycle on, the references are these, each (m,) [rad or m].
        """

class MomentumTask(Task):
    """
    Keeps the angular momentum about the COM small: it is brought to that of one body which turns as the walk turns.
    """
    def __init__(self, axes: str = "yaw", kd: typing.SupportsFloat | typing.SupportsIndex = 20.0) -> None: ...
    def __reduce__(self) -> typing.Any: ...

class TaskState:
    """
    The robot at one instant, as a task of your own gets it. It may be used only while its compute(state) runs.
    """
    def __reduce__(self) -> typing.Any: ...
    def frame(self, name: str) -> FrameState:
        """
        FrameState of a body or site: p_WF, R_WF, velocity, J (6, nv), drift (6,). The first compute(state), when the task is
        added, chooses which frames every cycle reads.

        Raises:
            InputError: there is none of that name, or it was not asked for in the first compute.
        """
    @property
    def dynamics(self) -> Dynamics:
        """
        Dynamics: q, dq, com, J_com, drift_com, A, b, ...
        """
    @property
    def heading(self) -> float:
        """
        heading of the walk in the world [rad]
        """
    @property
    def heading_rate(self) -> float:
        """
        planned rate at which the heading turns [rad/s]
        """
    @property
    def t(self) -> float:
        """
        time since the walk was reset [s]
        """

class PythonTask(Task):
    """
    A Python object with compute(state) as a task.
    """
    def __init__(self, task: typing.Any) -> None: ...
    def __reduce__(self) -> typing.Any: ...

class TaskAccelerations:
    """
    Commanded accelerations f* of the walk's own tasks.
    """
    def __init__(
        self,
        com: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        trunk: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        swing: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"],
        posture: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        of the COM (3,) [m/s^2]
        """
    @com.setter
    def com(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def posture(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        of the joints (joints,); entries of leg joints are not used
        """
    @posture.setter
    def posture(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def swing(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        of the swing sole (6,), linear then angular, world axes
        """
    @swing.setter
    def swing(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...
    @property
    def trunk(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        of the trunk's orientation (3,), world axes [rad/s^2]
        """
    @trunk.setter
    def trunk(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...

class WholeBodyResult:
    """
    Torque, motion and contact wrenches.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def damped(self) -> bool:
        """
        whether the motion was damped, since a leg was nearly straight
        """
    @property
    def ddq(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (nv,)
        """
    @property
    def f_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
        """
        robot on ground, left then right (12,), NaN in the air
        """
    @property
    def tau(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (joints,) [N m]
        """

class WholeBodyController:
    """
    Computes the joint torques of a biped that give COM, trunk, swing foot and posture their commanded accelerations while the standing feet keep still (eq. 1-7).

    Everything is affine in the COM's horizontal acceleration: after one prepare(), zmp() and solve() cost next to nothing for each acceleration.
    """
    def __init__(
        self,
        nv: typing.SupportsInt | typing.SupportsIndex,
        legs: typing.Annotated[
            collections.abc.Sequence[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]],
            "FixedSize(2)",
        ],
        *,
        textbook: bool = False,
        posture_task: bool = True,
        wrench_distribution: bool = True,
        contact_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> None:
        """
        Args:
            nv: velocity coordinates.
            legs: joint indices of the two legs, six each.
            textbook: equations as printed instead of the direct path; the same numbers.

        Raises:
            DimensionError.
        """
    def __reduce__(self) -> typing.Any: ...
    def prepare(
        self,
        dynamics: typing.Any,
        standing: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(2)"],
        support: str,
        f_star: TaskAccelerations,
        ground: typing.Annotated[collections.abc.Sequence[Plane], "FixedSize(2)"] = ...,
    ) -> None:
        """
        Takes one instant.

        Args:
            dynamics: Dynamics.
            standing: (left, right).
            support: 'left' or 'right', about which the ZMP is taken.
            f_star: TaskAccelerations; com's x and y are not used here.
            ground: Plane under the left and the right foot; level by default.

        Raises:
            InputError: no foot stands. DimensionError.
        """
    def solve(self, f_xy: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> WholeBodyResult:
        """
        Torque for horizontal COM acceleration (2,) [m/s^2].
        """
    def yaw_moment(self, f_xy: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> float:
        """
        Vertical moment of the ground on the robot about its COM, d/dt L_z, for COM acceleration (2,) [N m].
        """
    def zmp(
        self, f_xy: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        World x and y of the ZMP on zmp_plane (2,) [m] for horizontal COM acceleration (2,) [m/s^2]; affine on a level plane.
        """
    @property
    def feet(self) -> typing.Annotated[list[Contact], "FixedSize(2)"]:
        """
        Contact of the left and the right foot, as prepared
        """
    @property
    def zmp_plane(self) -> Plane:
        """
        plane on which the ZMP is taken
        """
    @property
    def zmp_slope(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 2]"]:
        """
        d zmp / d f_xy (2, 2) [s^2], on a tilted plane at f_xy = 0
        """

class ZmpEstimate:
    """
    What a torque will do to the ground.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def f_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
        """
        robot on ground, left then right (12,), NaN in the air
        """
    @property
    def in_contact(self) -> bool:
        """
        Whether the ground carries: without load there is no ZMP.
        """
    @property
    def zmp(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        world x and y, on the common plane of the feet (2,) [m]
        """

class ZmpEstimator:
    """
    Estimates the ZMP that a torque will produce, before it is sent (eq. 9-15), with one or two standing feet.
    """
    def __init__(self, nv: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    def estimate(self, tau: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]) -> ZmpEstimate:
        """
        ZMP and wrenches that the joint torque (joints,) [N m] will produce.
        """
    def update(
        self,
        A: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        b: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        g: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        J_c: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]", "flags.c_contiguous"],
        drift_c: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        standing: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(2)"],
        soles: typing.Annotated[
            collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]], "FixedSize(2)"
        ],
        support: str,
        ground: typing.Annotated[collections.abc.Sequence[Plane], "FixedSize(2)"] = ...,
    ) -> None:
        """
        Takes the state of one instant; after that, `estimate` works for any torque.

        Args:
            A (nv, nv), b, g (nv,): inertia, velocity and gravity terms.
            J_c (6 k, nv), drift_c (6 k,): of the k standing feet, left before right.
            standing: (left, right).
            soles: sole centres in W (2, 3) [m].
            support: foot whose sole centre the plane of the ZMP contains.
            ground: Plane under the left and the right foot; level by default.

        Raises:
            DimensionError, InputError.
        """
    @property
    def zmp_plane(self) -> Plane:
        """
        plane on which the ZMP is taken: common_plane of the feet
        """

class ReferenceResult:
    """
    What III-B ends with: the reference ZMP for the pendulum, and how good it is.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def converged(self) -> bool: ...
    @property
    def passes(self) -> int: ...
    @property
    def zmp_est(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        estimated ZMP that it leads to (2,) [m]
        """
    @property
    def zmp_ref(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        reference ZMP (2,) [m]
        """

class LinearInvertedPendulum:
    """
    The linear inverted pendulum: a point mass at height z_c over a ZMP at r, x'' = (x - r) / T_c^2 with T_c = sqrt(z_c / g).

    Usage:
        >>> LinearInvertedPendulum(0.747).step(0.001, 0.0, 0.25, -0.09)
    """
    def __init__(
        self,
        z_c: typing.SupportsFloat | typing.SupportsIndex,
        gravity: typing.SupportsFloat | typing.SupportsIndex = 9.81,
    ) -> None:
        """
        Args:
            z_c: COM height [m].
            gravity: [m/s^2].

        Raises:
            InputError.
        """
    def __reduce__(self) -> typing.Any: ...
    def acceleration(
        self, x: typing.SupportsFloat | typing.SupportsIndex, r: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Acceleration of the mass: (x - r) / T_c^2 [m/s^2].
        """
    def dcm(
        self, x: typing.SupportsFloat | typing.SupportsIndex, v: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Divergent component of motion (DCM), x + T_c v [m]: put the ZMP there, and the mass comes to rest over it.
        """
    def first_double_support(
        self, period: typing.SupportsFloat | typing.SupportsIndex, T_ss: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Length of the first double support with which a COM at rest between the feet gets onto the lateral orbit [s].
        """
    def orbit_inset(
        self, width: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        How far inside the foot that takes over next the DCM of the lateral orbit is, when the COM is half way between the feet [m].
        """
    def orbit_offset(
        self, drift: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        How much further along that DCM is, where the middle between the feet moves sideways by `drift` in a step [m].
        """
    def orbit_velocity(
        self, drift: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Lateral velocity of that orbit in the middle of a single support [m/s].
        """
    def reference_for(
        self, x: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Reference ZMP that gives the acceleration a: r = x - T_c^2 a [m].
        """
    def reference_to_reach(
        self,
        xi: typing.SupportsFloat | typing.SupportsIndex,
        xi_end: typing.SupportsFloat | typing.SupportsIndex,
        time: typing.SupportsFloat | typing.SupportsIndex,
    ) -> float:
        """
        Constant reference ZMP that brings the DCM from xi to xi_end in time [s].
        """
    def step(
        self,
        dt: typing.SupportsFloat | typing.SupportsIndex,
        x: typing.SupportsFloat | typing.SupportsIndex,
        v: typing.SupportsFloat | typing.SupportsIndex,
        r: typing.SupportsFloat | typing.SupportsIndex,
    ) -> tuple[float, float]:
        """
        Eq. 16 (corrected): (x_d, v_d) after dt [s] under reference ZMP r [m].
        """
    def step_lateral(
        self,
        dt: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.SupportsFloat | typing.SupportsIndex,
        w: typing.SupportsFloat | typing.SupportsIndex,
    ) -> tuple[float, float]:
        """
        Eq. 17: (y_d, w_d) after dt [s] under a reference ZMP at zero.
        """
    def velocity_after(
        self,
        T: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.SupportsFloat | typing.SupportsIndex,
        w: typing.SupportsFloat | typing.SupportsIndex,
    ) -> float:
        """
        Eq. 18: velocity w(T) after T [s] under a reference ZMP at zero [m/s].
        """
    @property
    def Tc(self) -> float:
        """
        time constant T_c [s]
        """
    @property
    def omega(self) -> float:
        """
        1 / T_c [rad/s]
        """

class VelocityTracker:
    """
    Lets the velocity of the COM follow the planned one, along one axis (III-C).
    """
    def __init__(
        self,
        law: str = "smooth",
        gain: typing.SupportsFloat | typing.SupportsIndex = 5.0,
        time: typing.SupportsFloat | typing.SupportsIndex = 0.05,
        deadband: typing.SupportsFloat | typing.SupportsIndex = 0.0002,
        catch_up_speed: typing.SupportsFloat | typing.SupportsIndex = ...,
    ) -> None:
        """
        Args:
            law: a value of the setting tracking.law: 'smooth', or 'bang_bang' as the paper has it.
            gain: [1/s].
            time: [s].
            deadband: [m].
            catch_up_speed: largest |gain I| [m/s].

        Raises:
            InputError.
        """
    def __reduce__(self) -> typing.Any: ...
    def acceleration(
        self,
        v_plan: typing.SupportsFloat | typing.SupportsIndex,
        v: typing.SupportsFloat | typing.SupportsIndex,
        ahead: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> float:
        """
        Acceleration that the law asks of the pendulum [m/s^2]: (v_plan - gain (I - ahead) - v) / time in the smooth law.

        Args:
            v_plan, v: planned and current velocity [m/s].
            ahead: value that the integral I is meant to have now [m].
        """
    def advance(
        self,
        v_des: typing.SupportsFloat | typing.SupportsIndex,
        v_plan: typing.SupportsFloat | typing.SupportsIndex,
        dt: typing.SupportsFloat | typing.SupportsIndex,
    ) -> None:
        """
        Adds one cycle to the integral.
        """
    def reset(self) -> None: ...
    @property
    def drive(self) -> int:
        """
        where the law holds the ZMP: -1 on its lower bound, +1 on its upper one, 0 on neither
        """
    @property
    def integral(self) -> float:
        """
        integral of v_des - v_plan [m]
        """

class GaitOutput:
    """
    What the gait asks for in one cycle.
    """
    def __reduce__(self) -> typing.Any: ...
    @property
    def at_rest(self) -> bool:
        """
        whether the robot stands and is not asked to walk
        """
    @property
    def foothold(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        where the swing foot is to land (x, y, yaw) [m, m, rad]; NaN in double support
        """
    @property
    def heading(self) -> float:
        """
        heading of the path in the world [rad]
        """
    @property
    def phase(self) -> int:
        """
        0 double, 1 single support
        """
    @property
    def phase_duration(self) -> float:
        """
        length of the phase [s]; events change it
        """
    @property
    def phase_time(self) -> float:
        """
        time since the phase began [s]
        """
    @property
    def standing(self) -> typing.Annotated[list[bool], "FixedSize(2)"]:
        """
        whether each foot stands (left, right)
        """
    @property
    def step(self) -> int: ...
    @property
    def support(self) -> int:
        """
        foot that carries the ZMP: +1 left, -1 right
        """
    @property
    def swing_acceleration(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired acceleration of the swing sole (3,) [m/s^2]
        """
    @property
    def swing_position(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired place of the swing sole (3,) [m]
        """
    @property
    def swing_velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired velocity of the swing sole (3,) [m/s]
        """
    @property
    def v_plan(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        planned velocity (v_x, v_y, w_z) in the heading frame
        """
    @property
    def w_T(self) -> float:
        """
        w(T) of eq. 18 while a switch of the support is awaited, else NaN [m/s]
        """
    @property
    def zmp_lateral(self) -> float:
        """
        reference ZMP from the support sole's centre, along the y axis of the heading frame [m]
        """

class GaitGenerator:
    """
    The gait: it decides from time and COM which foot stands, when the support switches, where feet land and how the swing foot moves there.
    """
    def __init__(
        self,
        *,
        com_height: typing.SupportsFloat | typing.SupportsIndex,
        gravity: typing.SupportsFloat | typing.SupportsIndex = 9.81,
        timestep: typing.SupportsFloat | typing.SupportsIndex = 0.001,
        foot_distance: typing.SupportsFloat | typing.SupportsIndex,
        sole_width: typing.SupportsFloat | typing.SupportsIndex,
        sole_length: typing.SupportsFloat | typing.SupportsIndex = 0.25,
        profile: VelocityProfile,
        settings: WalkSettings = ...,
    ) -> None:
        """
        Args:
            com_height: z_c [m].
            gravity: [m/s^2].
            timestep: control period [s].
            foot_distance, sole_width, sole_length: [m].
            profile: VelocityProfile.
            settings: WalkSettings.

        Raises:
            InputError.
        """
    def __reduce__(self) -> typing.Any: ...
    def command(self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        """
        Commands a velocity: from the next cycle on the plan goes towards (v_x, v_y, w_z), whatever the profile says.
        """
    def reset(
        self,
        com: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        dcom: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        soles: typing.Annotated[
            collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]], "FixedSize(2)"
        ],
    ) -> None:
        """
        Starts a walk from two standing feet: COM (2,), its velocity (2,), sole centres (2, 3).
        """
    def retime(self, remaining: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Lets the phase of the last cycle end `remaining` [s] after that cycle, however long it was to take.

        Raises:
            InputError: `remaining` is not finite and > 0.
        """
    def update(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        com: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        dcom: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        soles: typing.Annotated[
            collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]], "FixedSize(2)"
        ],
        contact: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"] = ...,
    ) -> GaitOutput:
        """
        Goes on by one cycle, at time t [s]. `contact` (2,) says whether the left and the right foot touch the ground: 1 yes, 0 no, NaN unknown; it ends a step where the setting touch_down is 'contact'.
        """
    @property
    def settings(self) -> WalkSettings:
        """
        settings in force
        """

class State:
    """
    What a control cycle knows of the robot: measured, estimated, or read from a simulator. Plain numbers.

    `controller.state(data)` makes one from a simulator's data; with numbers from elsewhere, fill one in yourself.
    """
    def __copy__(self) -> State: ...
    def __init__(
        self,
        time: typing.SupportsFloat | typing.SupportsIndex,
        q: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
        dq: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None:
        """
        Args:
            time: [s].
            q: base position (3) [m], base quaternion (w, x, y, z), joint positions [rad]: (nv + 1,).
            dq: base velocity in the world's axes (3) [m/s], base angular velocity in the base's axes (3) [rad/s],
                joint velocities [rad/s]: (nv,).

        Raises:
            DimensionError: q does not have one number more than dq.

        Usage:
            >>> out = controller.update(State(t, q, dq))
        """
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    @property
    def contact(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        1 where a foot touches the ground, 0 where it does not, NaN where it is unknown; left and right (2,)
        """
    @contact.setter
    def contact(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"]) -> None: ...
    @property
    def dq(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        base velocity (world's axes), base angular velocity (base's axes), joints (nv,)
        """
    @dq.setter
    def dq(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def external(self) -> typing.Any:
        """
        known forces on the robot, {body or site: (6,) force and moment at its frame's origin, world's axes [N, N m]},
        or None
        """
    @external.setter
    def external(self, arg0: typing.Any) -> None: ...
    @property
    def q(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        base position, base quaternion (w, x, y, z), joints (nv + 1,)
        """
    @q.setter
    def q(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def time(self) -> float:
        """
        [s]
        """
    @time.setter
    def time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def wrench(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 6]"]:
        """
        wrench of each foot on the ground, left and right, force then moment at the sole's centre, world's axes (2, 6)
        [N, N m]; NaN where it is not known
        """
    @wrench.setter
    def wrench(self, arg1: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 6]"]) -> None: ...

class CycleOutput:
    """
    Everything one control cycle decided.

    Each number is a column of a Trace too: `Trace.columns()` is the table of them. Frames are W, the world; H, turned into the
    heading of the walk; S, the axes of the support sole.
    """
    def __copy__(self) -> CycleOutput: ...
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    @property
    def at_rest(self) -> bool:
        """
        Whether the robot stands and is not asked to walk.
        """
    @property
    def attitude_bias(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Rotation vector of the bias that was found in the measured attitude and is taken out of it.

        (3,): x y z [rad], frame B.
        """
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Measured position of the centre of mass (COM).

        (3,): x y z [m], frame W.
        """
    @property
    def com_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Position of the COM that the next cycle should find; eq. (16) gives its x and y.

        (3,): x y z [m], frame W.
        """
    @property
    def command(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Live velocity command that is in force; it is NaN while the velocity profile leads.

        (3,): x y yaw [m/s, rad/s], frame H.
        """
    @property
    def command_limit(self) -> int:
        """
        What keeps the live command down: 0 nothing, 1 the reach of the legs, 2 torque of a hip, 3 of a knee, 4 friction against turning on the sole, 5 friction against sliding.
        """
    @property
    def damped(self) -> bool:
        """
        Whether the motion was damped because a leg is nearly straight.
        """
    @property
    def dcom(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Measured velocity of the COM.

        (3,): x y z [m/s], frame W.
        """
    @property
    def dcom_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Velocity of the COM that the next cycle should find; eq. (16) gives its x and y.

        (3,): x y z [m/s], frame W.
        """
    @property
    def disturbance(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Steady acceleration of the COM that the command does not explain and that is made up for: x and y as a force, z as a mass that differs from the model's.

        (3,): x y z [m/s^2], frame W.
        """
    @property
    def f_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
        """
        Wrench of the robot on the ground that is expected under each foot, at the centre of its sole; f_z < 0 where the foot carries, and a foot in the air has NaN.

        (12,): left_fx left_fy left_fz left_mx left_my left_mz right_fx right_fy right_fz right_mx right_my right_mz [N, N m], frame W.
        """
    @property
    def fall_cause(self) -> str:
        """
        Why the robot fell; it is empty where the robot did not.
        """
    @property
    def fall_foreseen(self) -> bool:
        """
        Whether a fall is foreseen; it stays so until the walk is started anew.
        """
    @property
    def fall_gap(self) -> float:
        """
        How far the DCM (COM + T_c times its velocity) is beyond what any foothold within reach can catch; it is 0 where one can, and NaN where falls are not foreseen.

        [m].
        """
    @property
    def fell(self) -> bool:
        """
        Whether the robot has fallen, which ends the walk.
        """
    @property
    def foot_left(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[7, 1]"]:
        """
        Pose of the left sole: position of its centre, and unit quaternion of its axes.

        (7,): x y z qw qx qy qz [m], frame W.
        """
    @property
    def foot_right(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[7, 1]"]:
        """
        Pose of the right sole: position of its centre, and unit quaternion of its axes.

        (7,): x y z qw qx qy qz [m], frame W.
        """
    @property
    def foothold(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Place and direction in which the swing foot is to land; it is NaN in double support.

        (3,): x y yaw [m, rad], frame W.
        """
    @property
    def foreseen_cause(self) -> str:
        """
        Why a fall is foreseen; it is empty where none is.
        """
    @property
    def foreseen_time(self) -> float:
        """
        Since when a fall is foreseen [s]; it is NaN where none is.
        """
    @property
    def fresh(self) -> bool:
        """
        Whether this call computed the torque and did not hold an earlier one.
        """
    @property
    def friction(self) -> float:
        """
        Friction that the feet are believed to have; it falls where a foot slips, and recovers slowly.
        """
    @property
    def ground(self) -> float:
        """
        Height of the ground that the walk follows: that of the soles at the start until the ground is felt to be uneven.

        [m], frame W.
        """
    @property
    def heading(self) -> float:
        """
        Direction in which the path leads, as an angle from the world's x axis.

        [rad], frame W.
        """
    @property
    def iterations(self) -> int:
        """
        Number of passes of III-B; it is 0 where the ZMP is left alone.
        """
    @property
    def limit_ranges(self) -> int:
        """
        Joints whose range held the torque back, as a sum: 2^j for joint j, from 0 on.
        """
    @property
    def limit_soles(self) -> int:
        """
        Limits of the soles that held the torque back, as a sum: 1 load, 2 friction, 4 centre of pressure, 8 yaw friction of the left sole, and 16 times these of the right one.
        """
    @property
    def limit_torques(self) -> int:
        """
        Joints whose torque limit held the torque back, as a sum: 2^j for joint j, from 0 on.
        """
    @property
    def phase(self) -> int:
        """
        Phase of the step: 0 is double support, 1 is single support.
        """
    @property
    def phase_time(self) -> float:
        """
        Time since the phase began.

        [s].
        """
    @property
    def saturated(self) -> bool:
        """
        Whether a torque was cut to its limit, because no motion keeps the limits or because keep_limits is off.
        """
    @property
    def step(self) -> int:
        """
        Number of the step, from 0 on; a step is a double support and the single support after it.
        """
    @property
    def support(self) -> int:
        """
        Foot that carries the ZMP: +1 is the left foot, -1 the right foot.
        """
    @property
    def t(self) -> float:
        """
        Time in the simulation of the state that this cycle read.

        [s].
        """
    @property
    def tau(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Torque that is sent to each joint.

        (joints,) [N m].
        """
    @property
    def torque_ratio(self) -> float:
        """
        Largest ratio of a joint's torque to its limit, before limits are kept or torques cut.
        """
    @property
    def uneven(self) -> bool:
        """
        Whether the ground has been felt to be uneven.
        """
    @property
    def v_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Desired velocity: horizontal velocity of the COM that the next cycle should find, and the planned turning rate.

        (3,): x y yaw [m/s, rad/s], frame H.
        """
    @property
    def v_error_integral(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Integral over time of v_des minus v_plan, which velocity tracking (III-C) brings back to zero; it is taken along x alone and is zero in the other two.

        (3,): x y yaw [m, rad], frame H.
        """
    @property
    def v_plan(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        Planned velocity: that of the command or the profile, changed no faster than the steps can follow.

        (3,): x y yaw [m/s, rad/s], frame H.
        """
    @property
    def w_T(self) -> float:
        """
        Lateral velocity that the COM would have in the middle of the next single support if the ZMP switched feet now (eq. 18); it is NaN while no switch is awaited.

        [m/s], frame H.
        """
    @property
    def zmp_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Desired ZMP: the bound that III-B brings the ZMP to, or the estimate itself where the ZMP is left alone.

        (2,): x y [m], frame W.
        """
    @property
    def zmp_est(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        ZMP that the torque of this cycle will produce, estimated before it is sent (eq. 14, 15).

        (2,): x y [m], frame W.
        """
    @property
    def zmp_first(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Estimated ZMP of the first pass of III-B, whose reference is the desired ZMP; it is NaN where the ZMP is left alone.

        (2,): x y [m], frame W.
        """
    @property
    def zmp_lower(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Corner of the designed bounds of the ZMP that lies at their lower end along both axes of the support sole.

        (2,): x y [m], frame W.
        """
    @property
    def zmp_modified(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        What III-B does along each axis of the support sole: -1 brings the ZMP to the lower bound, +1 to the upper bound, 0 leaves it alone.

        (2,): x y, frame S.
        """
    @property
    def zmp_plane(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[4, 1]"]:
        """
        Plane that every zmp_* lies on, as the points p with n . p = d: its unit normal n, which has no unit, and d.

        (4,): nx ny nz d [m], frame W.
        """
    @property
    def zmp_ref(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Reference ZMP: the ZMP that the pendulum of eq. (16) is given.

        (2,): x y [m], frame W.
        """
    @property
    def zmp_slope(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Derivative of the estimated ZMP with respect to the reference ZMP, along each axis of the support sole.

        (2,): x y, frame S.
        """
    @property
    def zmp_upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        Corner of the designed bounds of the ZMP that lies at their upper end along both axes of the support sole.

        (2,): x y [m], frame W.
        """

class WalkingController:
    """
    The walking controller: update(data) takes the state of the robot and gives the joint torques.

    Each cycle takes eq. (16) for the desired COM state, (1)-(8) for the torque, (9)-(15) for the ZMP that it will produce, and III-B to correct it.
    """
    def __init__(
        self,
        model: typing.Any,
        description: RobotDescription,
        settings: WalkSettings = ...,
        profile: VelocityProfile = ...,
    ) -> None:
        """
        Args:
            model: mujoco.MjModel; kept alive.
            description: RobotDescription.
            settings: WalkSettings.
            profile: VelocityProfile; the paper's by default.

        Raises:
            ModelError: the robot cannot be walked.
            InputError: a setting breaks a rule, or the profile is faster than the legs reach.
        """
    def __reduce__(self) -> typing.Any: ...
    def add(self, task: Task, blend: typing.SupportsFloat | typing.SupportsIndex = ...) -> None:
        """
        Adds a task that the robot fulfils while it walks; see the package's WalkingController.
        """
    def command(
        self,
        vx: typing.SupportsFloat | typing.SupportsIndex,
        vy: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        wz: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> None:
        """
        Commands a velocity: from the next cycle on the robot walks with (vx, vy, wz) in the heading frame instead of the profile's
        velocity, until reset().

        It may be called from any thread, at any time. A velocity that reach, torques or friction do not allow is scaled down (`within_limits`), and the
        robot takes it up no faster than the settings forward_jump, forward_acceleration, ... allow.

        Args:
            vx, vy: [m/s].
            wz: [rad/s].

        Raises:
            InputError: not finite.
        """
    def knee_share(self, speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Share of the knee's torque limit that its own rotor and damping take as the foot lifts, at a walking speed [m/s].
        """
    def know(self, ground: KnownGround) -> None:
        """
        Tells the ground that the robot walks on. It counts from the next reset on, and heights count from those of the soles there.

        Args:
            ground: KnownGround; KnownGround() takes back what was told.
        """
    def move(self, motion: JointMotion) -> None:
        """
        Lets joints outside the legs, and the trunk, follow `motion` from now on; see the package's WalkingController.
        """
    def plan(
        self,
        duration: typing.SupportsFloat | typing.SupportsIndex = 3.2,
        dt: typing.SupportsFloat | typing.SupportsIndex = 0.01,
    ) -> dict:
        """
        Computes footsteps, COM and ZMP ahead of time, for a robot that follows them exactly, from the state of the last reset.

        Args:
            duration: [s].
            dt: time step of the plan [s].

        Returns:
            dict: t (T,) [s], com, dcom, zmp (T, 2) [m, m/s], W; support (T,), +1 left, -1 right; steps, a list of dicts
            foot, lift_off, touch_down [s], place (x, y, yaw).

        Raises:
            InputError.
        """
    def plan_mismatch(self, duration: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Largest difference between the speed of the footsteps and the planned one within `duration` [s], in m/s; 0 where the steps follow the plan.
        """
    def reach_share(self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> float:
        """
        Share of the legs' reach that walking with velocity (v_x, v_y, w_z) uses; the robot can walk where it is at most 1.
        """
    def remove(self, task: Task, blend: typing.SupportsFloat | typing.SupportsIndex = ...) -> None:
        """
        Takes a task away; see the package's WalkingController.
        """
    @typing.overload
    def reset(self, state: State) -> None:
        """
        Starts a walk from a State, and moves nothing yet.
        """
    @typing.overload
    def reset(self, data: typing.Any) -> None:
        """
        Starts a walk from the state in `data`, and moves nothing yet.

        Raises:
            InputError: the state is not finite.
        """
    def retime(self, remaining: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Lets the present phase, single or double support, end `remaining` [s] after the last cycle; the swing foot goes on from where
        it is without a jump. Call it between cycles.

        Raises:
            InputError: not finite and > 0. A robot that stands stays as it is.
        """
    def state(self, data: typing.Any) -> State:
        """
        The robot's part of `data` as plain numbers: time, position and velocity. What feet feel is left unknown.

        Args:
            data: mujoco.MjData.

        Returns:
            State.

        Raises:
            InputError: data of another model.
        """
    @typing.overload
    def update(self, state: State) -> CycleOutput:
        """
        Computes the torque for a State and returns it as `tau`; nothing outside the controller changes.
        """
    @typing.overload
    def update(
        self,
        data: typing.Any,
        after_step1: bool = False,
        external: typing.Any = None,
        contact: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"] | None = None,
    ) -> CycleOutput:
        """
        Computes the torque for the state in `data`, writes the control that gives it into `data`, and returns what was decided (a copy).

        Args:
            data: mujoco.MjData.
            after_step1: True where mj_step1 (or mj_forward) has just run for this state, so that `data` holds kinematics,
                inertia and bias forces already; the torque has the same bits, in half the time.
            external: known forces on the robot, {body or site: (6,) force and moment at its frame's origin, world axes
                [N, N m]}; None where there are none.
            contact: (left, right), 1 where a foot touches the ground, 0 where it does not, NaN where it is unknown; None reads
                the contacts of the last step from `data`, if the setting `touch_down` needs them.

        Raises:
            InputError: the state is not finite, its terms belong to another, or reset() was not called; nothing is
                changed.
        """
    def within_limits(
        self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        The velocity (v_x, v_y, w_z) as command() takes it: made smaller until reach, torques and friction allow it.
        """
    def within_reach(
        self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        The velocity (v_x, v_y, w_z), made smaller until its reach_share is at most 1.
        """
    def zmp_bounds(
        self, side: str
    ) -> tuple[
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"],
        typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"],
    ]:
        """
        Bounds of the ZMP (lower, upper), each (2,), in the sole's axes about its centre [m].
        """
    @property
    def Tc(self) -> float:
        """
        time constant of the pendulum, sqrt(z_c / g) [s]
        """
    @property
    def active_limits(self) -> list[str]:
        """
        the limits that held the last torque back, in words: ["torque of l_knee", "yaw friction of the left sole"]; empty where none did
        """
    @property
    def arm_joints(self) -> list[str]:
        """
        joints that count as those of arms: they are outside the legs and carry less than a fifth of the robot's mass
        """
    @property
    def com_height(self) -> float:
        """
        height z_c of the COM over the soles [m]
        """
    @property
    def cycles(self) -> int:
        """
        control cycles since the last reset
        """
    @property
    def description(self) -> RobotDescription: ...
    @property
    def ground(self) -> KnownGround:
        """
        what is known of the ground, a KnownGround
        """
    @property
    def joint_names(self) -> list[str]: ...
    @property
    def mass(self) -> float:
        """
        mass of the robot [kg]: that of the model, and as a walk finds it to be (`observer`)
        """
    @property
    def motion(self) -> JointMotion: ...
    @property
    def profile(self) -> VelocityProfile: ...
    @property
    def settings(self) -> WalkSettings:
        """
        the WalkSettings of this walk; every NaN has the robot's value
        """
    @property
    def speed_limit(self) -> float:
        """
        largest v_x that reach, torques and friction allow [m/s]
        """
    @property
    def speed_limits(self) -> dict:
        """
        largest velocity forward, backward, sideways [m/s] and turning [rad/s], and what limits each, by name; together they bound a velocity: the sum of its |v| / most is at most 1
        """
    @property
    def task_activations(self) -> list[float]:
        """
        how far each added task acts now, from 0 to its weight, in the order of their priority
        """
    @property
    def torque_limit(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        torque limit of each joint, infinite without (joints,) [N m]
        """
    @property
    def torque_path(self) -> dict:
        """
        how each joint's torque reaches MuJoCo, by joint name: "motor 'l_knee'", "qfrc_applied: position servo 'l_knee' is silenced", ...
        """

class RecordedColumn:
    """
    What a recorded column is: one row of `recorded_columns`.
    """
    def __reduce__(self) -> typing.Any: ...
    def __repr__(self) -> str: ...
    @property
    def decided(self) -> bool:
        """
        Whether the cycle decides it, so that it is a property of CycleOutput too; else it is known only after the step.
        """
    @property
    def frame(self) -> str:
        """
        Frame in which the numbers are given: W, the world; H, turned into the planned heading; S, the axes of the
        support sole. It is empty where they have none.
        """
    @property
    def meaning(self) -> str:
        """
        What the numbers mean, in a sentence.
        """
    @property
    def name(self) -> str:
        """
        Name of the column in a Trace, and of the property of CycleOutput.
        """
    @property
    def parts(self) -> list[str]:
        """
        Names of the numbers in a row; empty where there is one, or where the robot says how many.
        """
    @property
    def size(self) -> str:
        """
        The same in words: "3", "joints", "nv + 1".
        """
    @property
    def unit(self) -> str:
        """
        SI unit of the numbers; empty where they have none.
        """
    @property
    def width(self) -> int | None:
        """
        How many numbers a row holds; None where the robot says how many.
        """

class Recorder:
    """
    Keeps what cycles record as columns. Row k holds the state before step k and what was decided for it.
    """
    def __init__(self, controller: WalkingController) -> None: ...
    def __len__(self) -> int: ...
    def __reduce__(self) -> typing.Any: ...
    def add(self, out: CycleOutput, data: typing.Any) -> None:
        """
        Adds one row. Call it right after mj_step, while `data` holds the contact forces of this cycle. A cycle that held an earlier torque adds none.
        """
    def columns(self) -> dict:
        """
        Columns by name, (T,) or (T, n): a copy.
        """

class SensorNoise:
    """
    Standard deviations of what is measured; white and Gaussian.
    """
    def __init__(self) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def attitude(self) -> float:
        """
        Of the base, about each of its axes [rad].
        """
    @attitude.setter
    def attitude(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def base_speed(self) -> float:
        """
        Along each axis [m/s].
        """
    @base_speed.setter
    def base_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def gyro(self) -> float:
        """
        Angular velocity of the base [rad/s].
        """
    @gyro.setter
    def gyro(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def joint(self) -> float:
        """
        Joint positions [rad].
        """
    @joint.setter
    def joint(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def joint_speed(self) -> float:
        """
        [rad/s]
        """
    @joint_speed.setter
    def joint_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class SignalUncertainty:
    """
    What lies between a robot and its controller: noise, bias, delays, lag. `zmpwalk.Uncertainty` makes it.
    """
    def __init__(self) -> None: ...
    def __reduce__(self) -> typing.Any: ...
    @property
    def lag(self) -> float:
        """
        Time constant with which a drive takes a torque up [s].
        """
    @lag.setter
    def lag(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def noise(self) -> SensorNoise:
        """
        Of the sensors.
        """
    @noise.setter
    def noise(self, arg0: SensorNoise) -> None: ...
    @property
    def pitch_bias(self) -> float:
        """
        The same about its y [rad].
        """
    @pitch_bias.setter
    def pitch_bias(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def roll_bias(self) -> float:
        """
        Of the measured attitude, about the base's x [rad].
        """
    @roll_bias.setter
    def roll_bias(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def seed(self) -> int:
        """
        Of the noise.
        """
    @seed.setter
    def seed(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    @property
    def state_delay(self) -> float:
        """
        Age of what is measured [s].
        """
    @state_delay.setter
    def state_delay(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...
    @property
    def torque_delay(self) -> float:
        """
        From a torque's decision to its effect [s].
        """
    @torque_delay.setter
    def torque_delay(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None: ...

class Simulation:
    """
    The closed loop in C++ from the start pose, the interpreter's lock released. It may be run in several stretches.
    """
    def __init__(
        self, controller: WalkingController, uncertainty: SignalUncertainty = ..., simulated: typing.Any = None
    ) -> None:
        """
        Args:
            uncertainty: what lies between robot and controller.
            simulated: the model that is simulated, None where it is the controller's.

        Raises:
            ModelError, InputError.
        """
    def __reduce__(self) -> typing.Any: ...
    def push(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        duration: typing.SupportsFloat | typing.SupportsIndex,
        body: str,
        wrench: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"],
    ) -> None:
        """
        A constant force and torque on a body, at its centre of mass, in [t, t + duration).

        Args:
            t, duration: [s].
            body: a name; "" takes the trunk.
            wrench: force, then torque, world axes (6,) [N, N m].

        Raises:
            InputError.
        """
    def run(
        self,
        duration: typing.SupportsFloat | typing.SupportsIndex,
        on_progress: typing.Any = None,
        command: typing.Any = None,
        command_interval: typing.SupportsFloat | typing.SupportsIndex = 0.02,
        on_fall: str = "stop",
        only_last: bool = False,
    ) -> tuple:
        """
        Walks on for `duration`.

        Args:
            duration: [s].
            on_progress: called as f(t, duration) about 20 times a second; may raise.
            command: called as f(t, out) after the first cycle and then every `command_interval` [s]; returns
                (vx, vy, wz) or None, which leaves the command as it is; StopIteration ends the run.
            on_fall: "stop" ends where the controller says that the robot has fallen, "go_on" only where it lies on the ground.
            only_last: return the last row of the columns alone, for a caller who looks at the walk now and then.

        Returns:
            (columns, info) of this stretch.

        Raises:
            InputError; whatever a callback raises; KeyboardInterrupt.
        """
    @property
    def time(self) -> float:
        """
        Simulated time [s].
        """

def benchmark_cycle(
    model: typing.Any,
    description: RobotDescription,
    settings: WalkSettings,
    profile: VelocityProfile,
    duration: typing.SupportsFloat | typing.SupportsIndex,
    textbook_every: typing.SupportsInt | typing.SupportsIndex = 20,
    on_progress: typing.Any = None,
) -> dict:
    """
    Times the parts of a control cycle while a robot walks, all in the same cycles.

    Args:
        duration: simulated time [s].
        textbook_every: equations as printed are timed in each n-th cycle; 0 never.
        on_progress: called as f(t, duration) about 20 times a second; may raise.

    Returns:
        columns by name, (T,), times in microseconds: phase (0 double, 1 single support), in_loop, from_scratch, step,
        terms, terms_from_scratch, algebra, iteration, other, textbook, difference (of textbook and algebra, relative).

    Raises:
        ModelError, InputError as WalkingController; InputError for a Runge-Kutta integrator.
    """

def benchmark_walk(
    model: typing.Any,
    description: RobotDescription,
    settings: WalkSettings,
    profile: VelocityProfile,
    duration: typing.SupportsFloat | typing.SupportsIndex,
    on_progress: typing.Any = None,
) -> dict:
    """
    Times a recorded walk and mj_step alone on the same states, piece by piece in turn.

    Args:
        duration: simulated time [s].
        on_progress: called as f(t, duration) about 10 times a second; may raise.

    Returns:
        columns by name, (pieces,): walk, bare, microseconds per step; difference, the largest difference of qvel between
        the two at the end of the piece, which is zero.

    Raises:
        ModelError, InputError as WalkingController; InputError for a Runge-Kutta integrator.
    """

def build_info() -> dict:
    """
    How this copy was built, and what it runs here.

    Returns:
        dict: version, mujoco (connected with), compiler, kernels (builds of the inner loops that this processor runs),
        kernel (the one that 'auto' takes).

    Usage:
        >>> zmpwalk.build_info()['kernel']
    """

def common_plane(feet: typing.Annotated[collections.abc.Sequence[Contact], "FixedSize(2)"], support: str) -> Plane:
    """
    Plane on which the ZMP of two feet is taken, through the support sole's centre.

    One standing foot: the ground under the support foot. Two: the plane that contains the line between the two places where they stand, and otherwise leans as the two grounds do on average.

    Args:
        feet: Contact of the left and the right foot.
        support: 'left' or 'right'.

    Raises:
        InputError: support is neither.
    """

def connect(adapter: str, libmujoco: str, version: str) -> None:
    """
    Connects the core with MuJoCo; `import zmpwalk` calls it. Later calls change nothing.

    Args:
        adapter: file of the adapter for this version.
        libmujoco: file of MuJoCo's library.
        version: of MuJoCo.
    """

def describe(model: typing.Any) -> RobotDescription:
    """
    Description of a model with box sites left_sole, right_sole and a keyframe stand.

    Raises:
        ModelError: says what is missing.
    """

def distribute_wrench(
    F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    M_P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    P: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    c: typing.Annotated[
        collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]], "FixedSize(2)"
    ],
    along: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    alone: typing.SupportsFloat | typing.SupportsIndex = 0.0,
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
    """
    Shares a total wrench (F, M about P) between two feet with sole centres c, exactly, whatever their heights and tilts; (12,).
    """

def iterate_reference(
    estimate: collections.abc.Callable[
        [typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]],
        typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
    ],
    zmp_des: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
    threshold: typing.SupportsFloat | typing.SupportsIndex = 0.001,
    max_passes: typing.SupportsInt | typing.SupportsIndex = 200,
) -> ReferenceResult:
    """
    The loop of III-B: it adds r_des - r_est(r_ref) to the reference r_ref until the estimate is the desired ZMP.

    Args:
        estimate: callable, reference ZMP (2,) -> estimated ZMP (2,) [m].
        zmp_des: (2,) [m].
        threshold: largest difference that is good enough [m].
    """

def measured_zmp(
    model: typing.Any, data: typing.Any, description: RobotDescription, plane: Plane | None = None
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
    """
    World x and y of the ZMP of MuJoCo's contact forces under the feet (2,) [m]; NaN without contact.

    After mj_step it belongs to the state before it.

    Args:
        plane: Plane that it is taken on. None: the level plane at the height of the soles, weighted by their loads.
    """

@typing.overload
def model_reasons(model: typing.Any, description: RobotDescription | None = None) -> list:
    """
    Every reason why a robot cannot walk, as (rule, sentence) pairs; the list is empty where it can.

    Args:
        description: the robot to look at; None looks at the world alone: gravity, time step, contacts, and a tree with most of the joints that is fixed to the world.
    """

@typing.overload
def model_reasons(model: typing.Any, robot: RobotParts, upright: typing.Any = None) -> list:
    """
    The same for a robot that has no description yet.

    Args:
        upright: data with the robot on level feet, after mj_kinematics and mj_comPos; with it, and with the robot's forward direction, the directions of the legs' axes are looked at too.
    """

def mujoco_version() -> str:
    """
    MuJoCo version that the core is connected with; empty without one.
    """

def pd_acceleration(
    kp: typing.SupportsFloat | typing.SupportsIndex,
    kd: typing.SupportsFloat | typing.SupportsIndex,
    position_error: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    velocity_error: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
    """
    Eq. 8: f* = kp (x_d - x) + kd (v_d - v).
    """

def recorded_columns() -> list[RecordedColumn]:
    """
    The table of everything that is recorded, in the order of the record.
    """

def seen(model: typing.Any, data: typing.Any) -> dict:
    """
    What the core sees of a model and its data, to be compared with what the mujoco package shows.

    Returns:
        dict: numbers by name; model and data, addresses of arrays by name; time; contacts, (geom, geom, position).
    """

def simulate(
    controller: WalkingController,
    duration: typing.SupportsFloat | typing.SupportsIndex,
    on_progress: typing.Any = None,
    command: typing.Any = None,
    command_interval: typing.SupportsFloat | typing.SupportsIndex = 0.02,
) -> tuple:
    """
    A whole walk: `Simulation(controller).run(duration, ...)`.

    Raises:
        as there.
    """

def solve_reference(
    estimate: collections.abc.Callable[
        [typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]],
        typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
    ],
    zmp_des: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
    slope: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 2]"],
    threshold: typing.SupportsFloat | typing.SupportsIndex = 0.001,
) -> ReferenceResult:
    """
    Where the loop of `iterate_reference` ends, in closed form, for an estimate that is affine in the reference.
    """

def trunk_body(controller: WalkingController) -> str:
    """
    Name of the body that a push is given to where none is named.
    """

def yaw_momentum(dynamics: Dynamics) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
    """
    Row c (nv,) of the angular momentum about the vertical through the COM, L_z = c dq [kg m^2/s].
    """

def zmp_bounds(
    length: typing.SupportsFloat | typing.SupportsIndex,
    width: typing.SupportsFloat | typing.SupportsIndex,
    ankle: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
    pitch_torque: typing.SupportsFloat | typing.SupportsIndex,
    roll_torque: typing.SupportsFloat | typing.SupportsIndex,
    weight: typing.SupportsFloat | typing.SupportsIndex,
    sole_fraction: typing.SupportsFloat | typing.SupportsIndex = 0.72,
    torque_fraction: typing.SupportsFloat | typing.SupportsIndex = 0.9,
) -> tuple[
    typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"],
    typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"],
]:
    """
    Bounds of the ZMP in one sole, from its size and the torque of the ankle: (lower, upper) about the sole's centre, each (2,) [m].
    """

def zmp_of_wrench(
    F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    M: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
    """
    Eq. 14, 15 on the level plane through the point about which M is taken, from that point: (-M_y / F_z, M_x / F_z) (2,) [m].
    """

def zmp_on_plane(
    F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    M: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    s: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    plane: Plane,
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
    """
    Eq. 14, 15 on any plane: the point of `plane` about which a wrench has a moment along its normal only (3,) [m].

    Args:
        F: force (3,) [N].
        M: moment about `s` (3,) [N m].
        s: any point (3,) [m], world axes all.
        plane: Plane.
    """
