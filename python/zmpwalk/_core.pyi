"""
zmpwalk's C++ core: contact-consistent control, ZMP estimate, gait, and the walking loop.
"""

from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import typing

__all__: list[str] = [
    "ContactSpace",
    "CycleOutput",
    "Dynamics",
    "Foot",
    "GaitGenerator",
    "GaitOutput",
    "JointMotion",
    "LinearInvertedPendulum",
    "Recorder",
    "ReferenceResult",
    "Robot",
    "RobotDescription",
    "SoleState",
    "TaskAccelerations",
    "TaskSpace",
    "VelocityProfile",
    "VelocityTracker",
    "WalkSettings",
    "WalkingController",
    "WholeBodyController",
    "WholeBodyResult",
    "ZmpEstimate",
    "ZmpEstimator",
    "benchmark_cycle",
    "build_info",
    "describe",
    "distribute_wrench",
    "iterate_reference",
    "measured_zmp",
    "mujoco_version",
    "pd_acceleration",
    "simulate",
    "solve_reference",
    "yaw_momentum",
    "zmp_bounds",
    "zmp_of_wrench",
]

class WalkSettings:
    __hash__: typing.ClassVar[None] = None
    @staticmethod
    def table() -> dict:
        """
        Every setting's (unit, meaning) by name, in the order of `to_dict`.
        """
    def __copy__(self) -> WalkSettings: ...
    def __deepcopy__(self, arg0: dict) -> WalkSettings: ...
    def __eq__(self, arg0: WalkSettings) -> bool: ...
    def __getstate__(self) -> dict: ...
    def __init__(self, law: str = "default", **kwargs) -> None:
        """
        Every gain, bound and switch of the walk. NaN means 'from the robot' and is filled in by WalkingController.

        Args:
            law: preset, 'default' or 'paper' (the literal law of the paper).
            control_dt: control period, a multiple of the model's time step; NaN: the model's time step [s]. Default nan.
            T_ds: double support time; NaN: one fifth of the step period, which goes as sqrt(COM height) [s]. Default nan.
            T_ss: single support time; NaN: four fifths of the step period [s]. Default nan.
            T_ds_first: first double support; NaN: computed so that the lateral orbit starts symmetric [s]. Default nan.
            first_swing: foot that swings first, 'right' or 'left'. Default 'right'.
            cadence_speed: speed up to which steps take T_ds + T_ss and grow longer; NaN: 0.1 of sqrt(g COM height) [m/s]. Default nan.
            cadence_exponent: above it, steps take (cadence_speed / speed)^cadence_exponent of that; 0: always the same; NaN: 0.4, and 0 where a list sets the lengths. Default nan.
            cadence_double: and the double support's share of a step goes as (cadence_speed / speed)^cadence_double. Default 0.5.
            cadence_sideways: what 1 m/s sideways counts as forward, for the cadence. Default 3.0.
            cadence_turning: what 1 rad/s counts as forward, for the cadence; NaN: 0.54 of the COM height [m/rad]. Default nan.
            stand: stand, feet side by side, while the profile is zero; False: step on the spot. Default True.
            stand_gain: standing: how far the ZMP goes beyond the DCM, per distance from the middle. Default 1.0.
            closing_reach: the last step goes beside the stance foot where the DCM will be this near; NaN: 0.1 of the COM height [m]. Default nan.
            closing_turn: and where the headings of path and stance foot differ by no more [rad]. Default 0.05.
            rate_limit: limit how fast the planned velocity changes; False: take profiles as they are. Default True.
            forward_jump: change of v_x that passes at once; NaN: 0.036 of sqrt(g COM height) [m/s]. Default nan.
            sideways_jump: change of v_y that passes at once; NaN: 0.03 of sqrt(g COM height) [m/s]. Default nan.
            turning_jump: change of w_z that passes at once; NaN: 0.07 / T_c [rad/s]. Default nan.
            forward_acceleration: at which v_x grows beyond that; NaN: 0.02 g [m/s^2]. Default nan.
            forward_deceleration: at which v_x goes back to zero; NaN: 0.056 g [m/s^2]. Default nan.
            sideways_acceleration: at which v_y follows beyond that; NaN: 0.025 g [m/s^2]. Default nan.
            turning_acceleration: at which w_z follows beyond that; NaN: 0.08 / T_c^2 [rad/s^2]. Default nan.
            tracker: velocity tracker: 'smooth' or 'bang_bang' (III-C as printed). Default 'smooth'.
            tracker_gain: smooth tracker: speed asked for per metre of integrated error; NaN: 1.38 / T_c [1/s]. Default nan.
            tracker_time: smooth tracker: time in which a speed error is removed; NaN: 0.18 T_c [s]. Default nan.
            tracker_reach: smooth tracker: largest speed beside the planned one that removes an integrated error; NaN: 0.03 of sqrt(g COM height) [m/s]. Default nan.
            tracker_deadband: bang-bang tracker: integrated error that counts as zero before a drive starts [m]. Default 0.0002.
            zmp_modification: keep the estimated ZMP inside its bounds (III-B, III-C); False: track v_plan blindly. Default True.
            iteration: how the reference ZMP is found: 'closed_form' or 'loop' (III-B), or 'none': the desired ZMP as the pendulum has it, the estimate changes nothing. Default 'closed_form'.
            zmp_threshold: |desired - estimated ZMP| at which the loop ends (section IV) [m]. Default 0.001.
            max_iterations: bound of the loop. Default 200.
            sole_fraction: share of the sole that the ZMP may use. Default 0.72.
            sole_exponent: above cadence_speed the ZMP uses less of the sole's length, as (cadence_speed / speed)^sole_exponent: at its edges the contact chatters. Default 0.5.
            ankle_torque_fraction: share of the ankle's torque limit that may hold the ZMP. Default 0.9.
            bound_lateral: bound the lateral ZMP too; the paper bounds the sagittal one only. Default True.
            least_knee: knee angle that the plan keeps: room for what it does not know, as swing leg and pelvis move the hips against the COM [rad]. Default 0.3.
            crouch_limit: how far the COM may come down for long steps; NaN: 0.1 of its height [m]. Default nan.
            crouch_margin: the COM comes down until the legs reach this many times as far as the feet are from the hips in double support. Default 1.2.
            crouch_time: time constant of that; NaN: 0.5 T_c [s]. Default nan.
            com_state: 'current' COM state in (16), (17): 'measured' or 'desired' (the previous one). Default 'measured'.
            feed_forward: add the pendulum's acceleration to (8). Default True.
            com_x_kp: COM, forward; NaN: scaled with 1/T_c^2 [1/s^2]. Default nan.
            com_x_kd: COM, forward; NaN: scaled with 1/T_c [1/s]. Default nan.
            com_y_kp: COM, lateral [1/s^2]. Default nan.
            com_y_kd: COM, lateral [1/s]. Default nan.
            com_z_kp: COM, height [1/s^2]. Default nan.
            com_z_kd: COM, height [1/s]. Default nan.
            lateral_feedback: shift the lateral reference ZMP so that the orbit repeats; False: (17) alone. Default True.
            lateral_reach: largest such shift, as a share of the half sole width. Default 0.4.
            footsteps: 'tied' to the COM, 'absolute', 'paper', 'printed' or 'list' (step_lengths). Default 'tied'.
            step_lengths: lead of each step over the stance foot, the last one repeated [m]. Default [].
            step_width: lateral distance of the feet; NaN: as they stand at the start [m]. Default nan.
            foot_clearance: least distance of the soles' edges sideways; NaN: 0.03 of the COM height [m]. Default nan.
            step_height: height of the swing foot; NaN: 0.0535 of the COM height, less (to 0.01) where the knee's rotor and damping would take over 0.6 of its torque at the profile's top speed [m]. Default nan.
            foothold_reach: tied footholds: largest distance from the nominal foothold; NaN: 0.25 of the COM height [m]. Default nan.
            com_lead: tied footholds: how far the COM rides ahead of the middle of the feet, so that a foot is not loaded on its heel; NaN: 0.0134 of the COM height [m]. Default nan.
            foothold_time: tied footholds: time constant of the low-pass on the target; NaN: 0.18 T_c [s]. Default nan.
            foothold_give: tied footholds: an excess speed moves the DCM; up to this share of the bounds the ZMP of the next stance takes it up, what is more moves the foothold. Default 0.3.
            foothold_freeze: tied footholds: share of the single support after which the target stands. Default 0.7.
            capture_reach: tied footholds: how far the DCM may be from where the plan has it as the next foot takes over: beyond, the COM's speed yields; NaN: 0.07 of the COM height [m]. Default nan.
            capture_speed: by how much it yields at most; NaN: 0.2 of sqrt(g COM height) [m/s]. Default nan.
            swing_feed_forward: add the spline's acceleration to the swing foot's task. Default True.
            swing_kp: swing foot, position and orientation [1/s^2]. Default nan.
            swing_kd: swing foot, position and orientation [1/s]. Default nan.
            trunk_kp: trunk orientation [1/s^2]. Default nan.
            trunk_kd: trunk orientation [1/s]. Default nan.
            posture_kp: joints that are in no leg [1/s^2]. Default nan.
            posture_kd: joints that are in no leg [1/s]. Default nan.
            motion_blend: time in which a joint motion takes over from the reference before it; NaN: 1.8 T_c [s]. Default nan.
            momentum_arms: share of the yaw momentum of legs and trunk that the arms swing to cancel, 0 to 1; joints that a motion names do not swing. Default 0.0.
            momentum_kp: swinging arms: spring to the posture [1/s^2]. Default nan.
            momentum_kd: swinging arms: rate at which the robot's yaw momentum is brought to zero [1/s]. Default nan.
            posture_task: stack the posture of waist and arms. Default True.
            wrench_distribution: share the load of two standing feet; False: minimum-norm torque. Default True.
            load_alone: double support: while the ZMP is this near to a sole's centre line, in half sole widths, that foot carries everything: a foot that just landed chatters under a light load. Default 0.7.
            contact_damping: damping of the velocity of a standing foot that does not carry the ZMP: without load it would drift off the ground [1/s]. Default 100.0.
            textbook: equations 1-13 as printed instead of the direct path: slower, the same numbers. Default False.
            singular_damping: damping of the motion where a leg is straight. Default 0.001.
            singular_pivot: pivot below which a leg counts as straight. Default 0.01.
            friction_velocity: joint speed below which dry friction is taken as proportional to speed [rad/s]. Default 0.02.
            kernel: build of the inner loops: 'auto', the best that this processor runs, or one of build_info()['kernels']. Default 'auto'.
            torque_limits: torque limits by joint name, in place of the robot's own; a motor still gives no more than the model lets through [N m]. Default {}.
            fall_height: COM height over the support foot, as a share of the start's, that counts as a fall. Default 0.8.
            fall_tilt: trunk tilt that counts as a fall [rad]. Default 0.8.
            fall_foot_tilt: tilt of the foot that stands alone that counts as a fall [rad]. Default 0.3.

        Raises:
            InputError: an unknown name or a value of the wrong type.

        Usage:
            >>> WalkSettings(law='paper', footsteps='absolute')
        """
    def __repr__(self) -> str: ...
    def __setstate__(self, arg0: dict) -> None: ...
    def to_dict(self) -> dict:
        """
        All settings by name, as plain Python values.
        """
    @property
    def T_ds(self) -> typing.Any:
        """
        double support time; NaN: one fifth of the step period, which goes as sqrt(COM height) [s]
        """
    @T_ds.setter
    def T_ds(self, arg1: typing.Any) -> None: ...
    @property
    def T_ds_first(self) -> typing.Any:
        """
        first double support; NaN: computed so that the lateral orbit starts symmetric [s]
        """
    @T_ds_first.setter
    def T_ds_first(self, arg1: typing.Any) -> None: ...
    @property
    def T_ss(self) -> typing.Any:
        """
        single support time; NaN: four fifths of the step period [s]
        """
    @T_ss.setter
    def T_ss(self, arg1: typing.Any) -> None: ...
    @property
    def ankle_torque_fraction(self) -> typing.Any:
        """
        share of the ankle's torque limit that may hold the ZMP
        """
    @ankle_torque_fraction.setter
    def ankle_torque_fraction(self, arg1: typing.Any) -> None: ...
    @property
    def bound_lateral(self) -> typing.Any:
        """
        bound the lateral ZMP too; the paper bounds the sagittal one only
        """
    @bound_lateral.setter
    def bound_lateral(self, arg1: typing.Any) -> None: ...
    @property
    def cadence_double(self) -> typing.Any:
        """
        and the double support's share of a step goes as (cadence_speed / speed)^cadence_double
        """
    @cadence_double.setter
    def cadence_double(self, arg1: typing.Any) -> None: ...
    @property
    def cadence_exponent(self) -> typing.Any:
        """
        above it, steps take (cadence_speed / speed)^cadence_exponent of that; 0: always the same; NaN: 0.4, and 0 where a list sets the lengths
        """
    @cadence_exponent.setter
    def cadence_exponent(self, arg1: typing.Any) -> None: ...
    @property
    def cadence_sideways(self) -> typing.Any:
        """
        what 1 m/s sideways counts as forward, for the cadence
        """
    @cadence_sideways.setter
    def cadence_sideways(self, arg1: typing.Any) -> None: ...
    @property
    def cadence_speed(self) -> typing.Any:
        """
        speed up to which steps take T_ds + T_ss and grow longer; NaN: 0.1 of sqrt(g COM height) [m/s]
        """
    @cadence_speed.setter
    def cadence_speed(self, arg1: typing.Any) -> None: ...
    @property
    def cadence_turning(self) -> typing.Any:
        """
        what 1 rad/s counts as forward, for the cadence; NaN: 0.54 of the COM height [m/rad]
        """
    @cadence_turning.setter
    def cadence_turning(self, arg1: typing.Any) -> None: ...
    @property
    def capture_reach(self) -> typing.Any:
        """
        tied footholds: how far the DCM may be from where the plan has it as the next foot takes over: beyond, the COM's speed yields; NaN: 0.07 of the COM height [m]
        """
    @capture_reach.setter
    def capture_reach(self, arg1: typing.Any) -> None: ...
    @property
    def capture_speed(self) -> typing.Any:
        """
        by how much it yields at most; NaN: 0.2 of sqrt(g COM height) [m/s]
        """
    @capture_speed.setter
    def capture_speed(self, arg1: typing.Any) -> None: ...
    @property
    def closing_reach(self) -> typing.Any:
        """
        the last step goes beside the stance foot where the DCM will be this near; NaN: 0.1 of the COM height [m]
        """
    @closing_reach.setter
    def closing_reach(self, arg1: typing.Any) -> None: ...
    @property
    def closing_turn(self) -> typing.Any:
        """
        and where the headings of path and stance foot differ by no more [rad]
        """
    @closing_turn.setter
    def closing_turn(self, arg1: typing.Any) -> None: ...
    @property
    def com_lead(self) -> typing.Any:
        """
        tied footholds: how far the COM rides ahead of the middle of the feet, so that a foot is not loaded on its heel; NaN: 0.0134 of the COM height [m]
        """
    @com_lead.setter
    def com_lead(self, arg1: typing.Any) -> None: ...
    @property
    def com_state(self) -> typing.Any:
        """
        'current' COM state in (16), (17): 'measured' or 'desired' (the previous one)
        """
    @com_state.setter
    def com_state(self, arg1: typing.Any) -> None: ...
    @property
    def com_x_kd(self) -> typing.Any:
        """
        COM, forward; NaN: scaled with 1/T_c [1/s]
        """
    @com_x_kd.setter
    def com_x_kd(self, arg1: typing.Any) -> None: ...
    @property
    def com_x_kp(self) -> typing.Any:
        """
        COM, forward; NaN: scaled with 1/T_c^2 [1/s^2]
        """
    @com_x_kp.setter
    def com_x_kp(self, arg1: typing.Any) -> None: ...
    @property
    def com_y_kd(self) -> typing.Any:
        """
        COM, lateral [1/s]
        """
    @com_y_kd.setter
    def com_y_kd(self, arg1: typing.Any) -> None: ...
    @property
    def com_y_kp(self) -> typing.Any:
        """
        COM, lateral [1/s^2]
        """
    @com_y_kp.setter
    def com_y_kp(self, arg1: typing.Any) -> None: ...
    @property
    def com_z_kd(self) -> typing.Any:
        """
        COM, height [1/s]
        """
    @com_z_kd.setter
    def com_z_kd(self, arg1: typing.Any) -> None: ...
    @property
    def com_z_kp(self) -> typing.Any:
        """
        COM, height [1/s^2]
        """
    @com_z_kp.setter
    def com_z_kp(self, arg1: typing.Any) -> None: ...
    @property
    def contact_damping(self) -> typing.Any:
        """
        damping of the velocity of a standing foot that does not carry the ZMP: without load it would drift off the ground [1/s]
        """
    @contact_damping.setter
    def contact_damping(self, arg1: typing.Any) -> None: ...
    @property
    def control_dt(self) -> typing.Any:
        """
        control period, a multiple of the model's time step; NaN: the model's time step [s]
        """
    @control_dt.setter
    def control_dt(self, arg1: typing.Any) -> None: ...
    @property
    def crouch_limit(self) -> typing.Any:
        """
        how far the COM may come down for long steps; NaN: 0.1 of its height [m]
        """
    @crouch_limit.setter
    def crouch_limit(self, arg1: typing.Any) -> None: ...
    @property
    def crouch_margin(self) -> typing.Any:
        """
        the COM comes down until the legs reach this many times as far as the feet are from the hips in double support
        """
    @crouch_margin.setter
    def crouch_margin(self, arg1: typing.Any) -> None: ...
    @property
    def crouch_time(self) -> typing.Any:
        """
        time constant of that; NaN: 0.5 T_c [s]
        """
    @crouch_time.setter
    def crouch_time(self, arg1: typing.Any) -> None: ...
    @property
    def fall_foot_tilt(self) -> typing.Any:
        """
        tilt of the foot that stands alone that counts as a fall [rad]
        """
    @fall_foot_tilt.setter
    def fall_foot_tilt(self, arg1: typing.Any) -> None: ...
    @property
    def fall_height(self) -> typing.Any:
        """
        COM height over the support foot, as a share of the start's, that counts as a fall
        """
    @fall_height.setter
    def fall_height(self, arg1: typing.Any) -> None: ...
    @property
    def fall_tilt(self) -> typing.Any:
        """
        trunk tilt that counts as a fall [rad]
        """
    @fall_tilt.setter
    def fall_tilt(self, arg1: typing.Any) -> None: ...
    @property
    def feed_forward(self) -> typing.Any:
        """
        add the pendulum's acceleration to (8)
        """
    @feed_forward.setter
    def feed_forward(self, arg1: typing.Any) -> None: ...
    @property
    def first_swing(self) -> typing.Any:
        """
        foot that swings first, 'right' or 'left'
        """
    @first_swing.setter
    def first_swing(self, arg1: typing.Any) -> None: ...
    @property
    def foot_clearance(self) -> typing.Any:
        """
        least distance of the soles' edges sideways; NaN: 0.03 of the COM height [m]
        """
    @foot_clearance.setter
    def foot_clearance(self, arg1: typing.Any) -> None: ...
    @property
    def foothold_freeze(self) -> typing.Any:
        """
        tied footholds: share of the single support after which the target stands
        """
    @foothold_freeze.setter
    def foothold_freeze(self, arg1: typing.Any) -> None: ...
    @property
    def foothold_give(self) -> typing.Any:
        """
        tied footholds: an excess speed moves the DCM; up to this share of the bounds the ZMP of the next stance takes it up, what is more moves the foothold
        """
    @foothold_give.setter
    def foothold_give(self, arg1: typing.Any) -> None: ...
    @property
    def foothold_reach(self) -> typing.Any:
        """
        tied footholds: largest distance from the nominal foothold; NaN: 0.25 of the COM height [m]
        """
    @foothold_reach.setter
    def foothold_reach(self, arg1: typing.Any) -> None: ...
    @property
    def foothold_time(self) -> typing.Any:
        """
        tied footholds: time constant of the low-pass on the target; NaN: 0.18 T_c [s]
        """
    @foothold_time.setter
    def foothold_time(self, arg1: typing.Any) -> None: ...
    @property
    def footsteps(self) -> typing.Any:
        """
        'tied' to the COM, 'absolute', 'paper', 'printed' or 'list' (step_lengths)
        """
    @footsteps.setter
    def footsteps(self, arg1: typing.Any) -> None: ...
    @property
    def forward_acceleration(self) -> typing.Any:
        """
        at which v_x grows beyond that; NaN: 0.02 g [m/s^2]
        """
    @forward_acceleration.setter
    def forward_acceleration(self, arg1: typing.Any) -> None: ...
    @property
    def forward_deceleration(self) -> typing.Any:
        """
        at which v_x goes back to zero; NaN: 0.056 g [m/s^2]
        """
    @forward_deceleration.setter
    def forward_deceleration(self, arg1: typing.Any) -> None: ...
    @property
    def forward_jump(self) -> typing.Any:
        """
        change of v_x that passes at once; NaN: 0.036 of sqrt(g COM height) [m/s]
        """
    @forward_jump.setter
    def forward_jump(self, arg1: typing.Any) -> None: ...
    @property
    def friction_velocity(self) -> typing.Any:
        """
        joint speed below which dry friction is taken as proportional to speed [rad/s]
        """
    @friction_velocity.setter
    def friction_velocity(self, arg1: typing.Any) -> None: ...
    @property
    def iteration(self) -> typing.Any:
        """
        how the reference ZMP is found: 'closed_form' or 'loop' (III-B), or 'none': the desired ZMP as the pendulum has it, the estimate changes nothing
        """
    @iteration.setter
    def iteration(self, arg1: typing.Any) -> None: ...
    @property
    def kernel(self) -> typing.Any:
        """
        build of the inner loops: 'auto', the best that this processor runs, or one of build_info()['kernels']
        """
    @kernel.setter
    def kernel(self, arg1: typing.Any) -> None: ...
    @property
    def lateral_feedback(self) -> typing.Any:
        """
        shift the lateral reference ZMP so that the orbit repeats; False: (17) alone
        """
    @lateral_feedback.setter
    def lateral_feedback(self, arg1: typing.Any) -> None: ...
    @property
    def lateral_reach(self) -> typing.Any:
        """
        largest such shift, as a share of the half sole width
        """
    @lateral_reach.setter
    def lateral_reach(self, arg1: typing.Any) -> None: ...
    @property
    def law(self) -> str:
        """
        preset this started from
        """
    @property
    def least_knee(self) -> typing.Any:
        """
        knee angle that the plan keeps: room for what it does not know, as swing leg and pelvis move the hips against the COM [rad]
        """
    @least_knee.setter
    def least_knee(self, arg1: typing.Any) -> None: ...
    @property
    def load_alone(self) -> typing.Any:
        """
        double support: while the ZMP is this near to a sole's centre line, in half sole widths, that foot carries everything: a foot that just landed chatters under a light load
        """
    @load_alone.setter
    def load_alone(self, arg1: typing.Any) -> None: ...
    @property
    def max_iterations(self) -> typing.Any:
        """
        bound of the loop
        """
    @max_iterations.setter
    def max_iterations(self, arg1: typing.Any) -> None: ...
    @property
    def momentum_arms(self) -> typing.Any:
        """
        share of the yaw momentum of legs and trunk that the arms swing to cancel, 0 to 1; joints that a motion names do not swing
        """
    @momentum_arms.setter
    def momentum_arms(self, arg1: typing.Any) -> None: ...
    @property
    def momentum_kd(self) -> typing.Any:
        """
        swinging arms: rate at which the robot's yaw momentum is brought to zero [1/s]
        """
    @momentum_kd.setter
    def momentum_kd(self, arg1: typing.Any) -> None: ...
    @property
    def momentum_kp(self) -> typing.Any:
        """
        swinging arms: spring to the posture [1/s^2]
        """
    @momentum_kp.setter
    def momentum_kp(self, arg1: typing.Any) -> None: ...
    @property
    def motion_blend(self) -> typing.Any:
        """
        time in which a joint motion takes over from the reference before it; NaN: 1.8 T_c [s]
        """
    @motion_blend.setter
    def motion_blend(self, arg1: typing.Any) -> None: ...
    @property
    def posture_kd(self) -> typing.Any:
        """
        joints that are in no leg [1/s]
        """
    @posture_kd.setter
    def posture_kd(self, arg1: typing.Any) -> None: ...
    @property
    def posture_kp(self) -> typing.Any:
        """
        joints that are in no leg [1/s^2]
        """
    @posture_kp.setter
    def posture_kp(self, arg1: typing.Any) -> None: ...
    @property
    def posture_task(self) -> typing.Any:
        """
        stack the posture of waist and arms
        """
    @posture_task.setter
    def posture_task(self, arg1: typing.Any) -> None: ...
    @property
    def rate_limit(self) -> typing.Any:
        """
        limit how fast the planned velocity changes; False: take profiles as they are
        """
    @rate_limit.setter
    def rate_limit(self, arg1: typing.Any) -> None: ...
    @property
    def sideways_acceleration(self) -> typing.Any:
        """
        at which v_y follows beyond that; NaN: 0.025 g [m/s^2]
        """
    @sideways_acceleration.setter
    def sideways_acceleration(self, arg1: typing.Any) -> None: ...
    @property
    def sideways_jump(self) -> typing.Any:
        """
        change of v_y that passes at once; NaN: 0.03 of sqrt(g COM height) [m/s]
        """
    @sideways_jump.setter
    def sideways_jump(self, arg1: typing.Any) -> None: ...
    @property
    def singular_damping(self) -> typing.Any:
        """
        damping of the motion where a leg is straight
        """
    @singular_damping.setter
    def singular_damping(self, arg1: typing.Any) -> None: ...
    @property
    def singular_pivot(self) -> typing.Any:
        """
        pivot below which a leg counts as straight
        """
    @singular_pivot.setter
    def singular_pivot(self, arg1: typing.Any) -> None: ...
    @property
    def sole_exponent(self) -> typing.Any:
        """
        above cadence_speed the ZMP uses less of the sole's length, as (cadence_speed / speed)^sole_exponent: at its edges the contact chatters
        """
    @sole_exponent.setter
    def sole_exponent(self, arg1: typing.Any) -> None: ...
    @property
    def sole_fraction(self) -> typing.Any:
        """
        share of the sole that the ZMP may use
        """
    @sole_fraction.setter
    def sole_fraction(self, arg1: typing.Any) -> None: ...
    @property
    def stand(self) -> typing.Any:
        """
        stand, feet side by side, while the profile is zero; False: step on the spot
        """
    @stand.setter
    def stand(self, arg1: typing.Any) -> None: ...
    @property
    def stand_gain(self) -> typing.Any:
        """
        standing: how far the ZMP goes beyond the DCM, per distance from the middle
        """
    @stand_gain.setter
    def stand_gain(self, arg1: typing.Any) -> None: ...
    @property
    def step_height(self) -> typing.Any:
        """
        height of the swing foot; NaN: 0.0535 of the COM height, less (to 0.01) where the knee's rotor and damping would take over 0.6 of its torque at the profile's top speed [m]
        """
    @step_height.setter
    def step_height(self, arg1: typing.Any) -> None: ...
    @property
    def step_lengths(self) -> typing.Any:
        """
        lead of each step over the stance foot, the last one repeated [m]
        """
    @step_lengths.setter
    def step_lengths(self, arg1: typing.Any) -> None: ...
    @property
    def step_width(self) -> typing.Any:
        """
        lateral distance of the feet; NaN: as they stand at the start [m]
        """
    @step_width.setter
    def step_width(self, arg1: typing.Any) -> None: ...
    @property
    def swing_feed_forward(self) -> typing.Any:
        """
        add the spline's acceleration to the swing foot's task
        """
    @swing_feed_forward.setter
    def swing_feed_forward(self, arg1: typing.Any) -> None: ...
    @property
    def swing_kd(self) -> typing.Any:
        """
        swing foot, position and orientation [1/s]
        """
    @swing_kd.setter
    def swing_kd(self, arg1: typing.Any) -> None: ...
    @property
    def swing_kp(self) -> typing.Any:
        """
        swing foot, position and orientation [1/s^2]
        """
    @swing_kp.setter
    def swing_kp(self, arg1: typing.Any) -> None: ...
    @property
    def textbook(self) -> typing.Any:
        """
        equations 1-13 as printed instead of the direct path: slower, the same numbers
        """
    @textbook.setter
    def textbook(self, arg1: typing.Any) -> None: ...
    @property
    def torque_limits(self) -> typing.Any:
        """
        torque limits by joint name, in place of the robot's own; a motor still gives no more than the model lets through [N m]
        """
    @torque_limits.setter
    def torque_limits(self, arg1: typing.Any) -> None: ...
    @property
    def tracker(self) -> typing.Any:
        """
        velocity tracker: 'smooth' or 'bang_bang' (III-C as printed)
        """
    @tracker.setter
    def tracker(self, arg1: typing.Any) -> None: ...
    @property
    def tracker_deadband(self) -> typing.Any:
        """
        bang-bang tracker: integrated error that counts as zero before a drive starts [m]
        """
    @tracker_deadband.setter
    def tracker_deadband(self, arg1: typing.Any) -> None: ...
    @property
    def tracker_gain(self) -> typing.Any:
        """
        smooth tracker: speed asked for per metre of integrated error; NaN: 1.38 / T_c [1/s]
        """
    @tracker_gain.setter
    def tracker_gain(self, arg1: typing.Any) -> None: ...
    @property
    def tracker_reach(self) -> typing.Any:
        """
        smooth tracker: largest speed beside the planned one that removes an integrated error; NaN: 0.03 of sqrt(g COM height) [m/s]
        """
    @tracker_reach.setter
    def tracker_reach(self, arg1: typing.Any) -> None: ...
    @property
    def tracker_time(self) -> typing.Any:
        """
        smooth tracker: time in which a speed error is removed; NaN: 0.18 T_c [s]
        """
    @tracker_time.setter
    def tracker_time(self, arg1: typing.Any) -> None: ...
    @property
    def trunk_kd(self) -> typing.Any:
        """
        trunk orientation [1/s]
        """
    @trunk_kd.setter
    def trunk_kd(self, arg1: typing.Any) -> None: ...
    @property
    def trunk_kp(self) -> typing.Any:
        """
        trunk orientation [1/s^2]
        """
    @trunk_kp.setter
    def trunk_kp(self, arg1: typing.Any) -> None: ...
    @property
    def turning_acceleration(self) -> typing.Any:
        """
        at which w_z follows beyond that; NaN: 0.08 / T_c^2 [rad/s^2]
        """
    @turning_acceleration.setter
    def turning_acceleration(self, arg1: typing.Any) -> None: ...
    @property
    def turning_jump(self) -> typing.Any:
        """
        change of w_z that passes at once; NaN: 0.07 / T_c [rad/s]
        """
    @turning_jump.setter
    def turning_jump(self, arg1: typing.Any) -> None: ...
    @property
    def wrench_distribution(self) -> typing.Any:
        """
        share the load of two standing feet; False: minimum-norm torque
        """
    @wrench_distribution.setter
    def wrench_distribution(self, arg1: typing.Any) -> None: ...
    @property
    def zmp_modification(self) -> typing.Any:
        """
        keep the estimated ZMP inside its bounds (III-B, III-C); False: track v_plan blindly
        """
    @zmp_modification.setter
    def zmp_modification(self, arg1: typing.Any) -> None: ...
    @property
    def zmp_threshold(self) -> typing.Any:
        """
        |desired - estimated ZMP| at which the loop ends (section IV) [m]
        """
    @zmp_threshold.setter
    def zmp_threshold(self, arg1: typing.Any) -> None: ...

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
        Velocity (3,) at time t [s]; the last value holds.
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
    What tells one robot from another; all addressing is by name.
    """
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
    def check(self, model: typing.Any) -> None:
        """
        Raises ModelError unless this robot is in `model` and can be walked.
        """
    def drives(self, model: typing.Any) -> dict:
        """
        Torque limit [N m], infinite without, and way of the torque (see WalkingController.torque_path), by joint name.

        Raises:
            ModelError: as check().
        """
    def place(
        self, model: typing.Any, data: typing.Any, ground: typing.SupportsFloat | typing.SupportsIndex = 0.0
    ) -> None:
        """
        Puts the robot into its start pose, at rest, soles on z = ground [m]; only its own qpos and qvel change.

        Raises:
            ModelError: as check().
        """
    @property
    def left(self) -> Foot: ...
    @property
    def name(self) -> str: ...
    @property
    def right(self) -> Foot: ...
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
    def stand_keyframe(self) -> str: ...
    @property
    def torque_limits(self) -> dict[str, float]:
        """
        by joint name, in place of the model's [N m]
        """

class SoleState:
    """
    A sole frame: origin at the sole's centre, x forward, z up; all in world axes.
    """
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
    def joints(self) -> int: ...
    @property
    def left(self) -> SoleState:
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
    def nv(self) -> int: ...
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
    def right(self) -> SoleState:
        """
        right sole
        """

class Robot:
    """
    One robot inside a MuJoCo model: mjModel and mjData on one side, Dynamics on the other.
    """
    def __init__(self, model: typing.Any, description: RobotDescription) -> None:
        """
        Raises:
            ModelError: the robot cannot be walked.
        """
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
    def joint_names(self) -> list[str]: ...
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
    The contact space of the feet that stand: eq. 2 and 10-13.
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
    def wrench(
        self, tau: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]
    ) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        Eq. 9: wrench of the robot on the ground (m,) for joint torque (joints,) [N m].
        """
    @property
    def Jbar_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        eq. 13 (nv, m)
        """
    @property
    def Lambda_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        eq. 10 (m, m)
        """
    @property
    def N_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        eq. 2 (nv, nv)
        """
    @property
    def mu_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        eq. 11 (m,)
        """
    @property
    def p_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        eq. 12 (m,)
        """

class TaskSpace:
    """
    Eq. 1 and 3-7 as printed (with the erratum of (7)): the definition.
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
        eq. 4, transposed (nv, m)
        """
    @property
    def Lambda(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        eq. 3 (m, m)
        """
    @property
    def N_k(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        torques through it leave the tasks alone (joints, joints)
        """
    @property
    def V_n(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, n]"]:
        """
        internal torques (joints, m_c - 6)
        """
    @property
    def mu(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        eq. 5 (m,)
        """
    @property
    def p(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        eq. 6 (m,)
        """

class TaskAccelerations:
    """
    Commanded accelerations f* of the stacked tasks.
    """
    def __init__(
        self,
        com: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        trunk: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
        swing: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"],
        posture: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"],
    ) -> None: ...
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m/s^2]
        """
    @com.setter
    def com(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...
    @property
    def posture(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (joints,); leg entries are not used
        """
    @posture.setter
    def posture(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[m, 1]"]) -> None: ...
    @property
    def swing(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[6, 1]"]:
        """
        (6,), linear then angular, world axes
        """
    @swing.setter
    def swing(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[6, 1]"]) -> None: ...
    @property
    def trunk(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,), world axes [rad/s^2]
        """
    @trunk.setter
    def trunk(self, arg0: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None: ...

class WholeBodyResult:
    """
    Torque, motion and contact wrenches.
    """
    @property
    def damped(self) -> bool:
        """
        a leg was near singular
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
    Contact-consistent whole-body control of a biped, eq. 1-7: COM, trunk, swing foot and posture, stacked.

    Everything is affine in the COM's horizontal acceleration: prepare() once, then zmp() and solve() cost next to nothing.
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
    def prepare(
        self,
        dynamics: typing.Any,
        standing: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(2)"],
        support: str,
        f_star: TaskAccelerations,
    ) -> None:
        """
        Takes one instant.

        Args:
            dynamics: Dynamics.
            standing: (left, right).
            support: 'left' or 'right', about which the ZMP is taken.
            f_star: TaskAccelerations; com's x and y are not used here.

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
        ZMP in W (2,) [m] for horizontal COM acceleration (2,) [m/s^2]; affine.
        """
    @property
    def zmp_slope(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 2]"]:
        """
        d zmp / d f_xy (2, 2) [s^2]
        """

class ZmpEstimate:
    """
    What a torque will do to the ground.
    """
    @property
    def f_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
        """
        robot on ground, left then right (12,), NaN in the air
        """
    @property
    def in_contact(self) -> bool: ...
    @property
    def zmp(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        in W, on the plane of the support sole (2,) [m]
        """

class ZmpEstimator:
    """
    Eq. 9-15: the ZMP that a torque will produce, before it is sent. One or two standing feet.
    """
    def __init__(self, nv: typing.SupportsInt | typing.SupportsIndex) -> None: ...
    def estimate(self, tau: typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]) -> ZmpEstimate:
        """
        ZMP and wrenches of joint torque (joints,) [N m].
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
    ) -> None:
        """
        Takes the state of one instant.

        Args:
            A (nv, nv), b, g (nv,): inertia, velocity and gravity terms.
            J_c (6 k, nv), drift_c (6 k,): of the k standing feet, left before right.
            standing: (left, right).
            soles: sole centres in W (2, 3) [m].
            support: foot whose sole plane carries the ZMP.

        Raises:
            DimensionError, InputError.
        """

class ReferenceResult:
    """
    What III-B ends with.
    """
    @property
    def converged(self) -> bool: ...
    @property
    def passes(self) -> int: ...
    @property
    def zmp_est(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) [m]
        """
    @property
    def zmp_ref(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        (2,) [m]
        """

class LinearInvertedPendulum:
    """
    x'' = (x - r) / T_c^2, T_c = sqrt(z_c / g).

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
    def acceleration(
        self, x: typing.SupportsFloat | typing.SupportsIndex, r: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        (x - r) / T_c^2 [m/s^2].
        """
    def dcm(
        self, x: typing.SupportsFloat | typing.SupportsIndex, v: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        x + T_c v [m].
        """
    def first_double_support(
        self, period: typing.SupportsFloat | typing.SupportsIndex, T_ss: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        First double support from which the symmetric orbit starts at rest [s].
        """
    def orbit_inset(
        self, width: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        How far the lateral orbit's DCM, half way between the feet, lies inside the foot to come [m].
        """
    def orbit_offset(
        self, drift: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        And along a drift of the feet's middle by `drift` a step [m].
        """
    def orbit_velocity(
        self, drift: typing.SupportsFloat | typing.SupportsIndex, period: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        Velocity of that orbit in the middle of a single support [m/s].
        """
    def reference_for(
        self, x: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex
    ) -> float:
        """
        r = x - T_c^2 a [m].
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
        Eq. 17: (y_d, w_d), about a zero reference.
        """
    def velocity_after(
        self,
        T: typing.SupportsFloat | typing.SupportsIndex,
        y: typing.SupportsFloat | typing.SupportsIndex,
        w: typing.SupportsFloat | typing.SupportsIndex,
    ) -> float:
        """
        Eq. 18: w(T) [m/s].
        """
    @property
    def Tc(self) -> float:
        """
        [s]
        """
    @property
    def omega(self) -> float:
        """
        1 / T_c [rad/s]
        """

class VelocityTracker:
    """
    Planned-velocity tracking along one axis, III-C.
    """
    def __init__(
        self,
        law: str = "smooth",
        gain: typing.SupportsFloat | typing.SupportsIndex = 5.0,
        time: typing.SupportsFloat | typing.SupportsIndex = 0.05,
        deadband: typing.SupportsFloat | typing.SupportsIndex = 0.0002,
        reach: typing.SupportsFloat | typing.SupportsIndex = ...,
    ) -> None:
        """
        Args:
            law: 'smooth' or 'bang_bang' (the paper's).
            gain: [1/s].
            time: [s].
            deadband: [m].
            reach: largest |gain I| [m/s].

        Raises:
            InputError.
        """
    def acceleration(
        self,
        v_plan: typing.SupportsFloat | typing.SupportsIndex,
        v: typing.SupportsFloat | typing.SupportsIndex,
        ahead: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> float:
        """
        Smooth law: (v_plan - gain (I - ahead) - v) / time [m/s^2]; ahead: what I is meant to be now [m].
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
        bang-bang law: -1 ZMP to the lower bound, +1 to the upper, 0 track
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
    @property
    def at_rest(self) -> bool:
        """
        stands, and is not asked to walk
        """
    @property
    def foothold(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (x, y, yaw)
        """
    @property
    def heading(self) -> float:
        """
        of the walk, in the world [rad]
        """
    @property
    def phase(self) -> int:
        """
        0 double, 1 single support
        """
    @property
    def phase_time(self) -> float:
        """
        [s]
        """
    @property
    def standing(self) -> typing.Annotated[list[bool], "FixedSize(2)"]:
        """
        (left, right)
        """
    @property
    def step(self) -> int: ...
    @property
    def support(self) -> int:
        """
        +1 left, -1 right
        """
    @property
    def swing_acceleration(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m/s^2]
        """
    @property
    def swing_position(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m]
        """
    @property
    def swing_velocity(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        (3,) [m/s]
        """
    @property
    def v_plan(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        planned velocity (v_x, v_y, w_z)
        """
    @property
    def w_T(self) -> float:
        """
        eq. 18 [m/s]
        """
    @property
    def zmp_lateral(self) -> float:
        """
        reference ZMP along the support frame's y [m]
        """

class GaitGenerator:
    """
    Phases, support switch, footholds and swing foot, from time and the COM alone.
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
    def command(self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> None:
        """
        From the next cycle on towards (v_x, v_y, w_z), whatever the profile says.
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
    def update(
        self,
        t: typing.SupportsFloat | typing.SupportsIndex,
        com: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        dcom: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[2, 1]"],
        soles: typing.Annotated[
            collections.abc.Sequence[typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]], "FixedSize(2)"
        ],
    ) -> GaitOutput:
        """
        One cycle at time t [s].
        """
    @property
    def settings(self) -> WalkSettings:
        """
        settings in force
        """

class CycleOutput:
    """
    Everything one control cycle decided. SI units, world frame, unless said.
    """
    def __copy__(self) -> CycleOutput: ...
    def __repr__(self) -> str: ...
    @property
    def at_rest(self) -> bool:
        """
        stands, and is not asked to walk
        """
    @property
    def com(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        COM (3,) [m]
        """
    @property
    def com_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired COM of the next cycle (3,) [m]
        """
    @property
    def command(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        live command in force (v_x, v_y, w_z), NaN while the profile leads
        """
    @property
    def damped(self) -> bool:
        """
        a straight leg damped the motion
        """
    @property
    def dcom(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        COM velocity (3,) [m/s]
        """
    @property
    def dcom_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired COM velocity of the next cycle (3,) [m/s]
        """
    @property
    def f_c(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[12, 1]"]:
        """
        expected contact wrenches, robot on ground, left then right (12,)
        """
    @property
    def fall_cause(self) -> str:
        """
        why, or ''
        """
    @property
    def fell(self) -> bool:
        """
        the robot fell
        """
    @property
    def foot_left(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[7, 1]"]:
        """
        left sole pose: position, quaternion (7,)
        """
    @property
    def foot_right(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[7, 1]"]:
        """
        right sole pose: position, quaternion (7,)
        """
    @property
    def foothold(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        target of the swing foot (x, y, yaw)
        """
    @property
    def fresh(self) -> bool:
        """
        computed in this call, not held from an earlier one
        """
    @property
    def heading(self) -> float:
        """
        of the walk, in the world [rad]
        """
    @property
    def iterations(self) -> int:
        """
        passes of III-B, 0 where the ZMP was left alone
        """
    @property
    def phase(self) -> int:
        """
        0 double, 1 single support
        """
    @property
    def phase_time(self) -> float:
        """
        since the phase began [s]
        """
    @property
    def saturated(self) -> bool:
        """
        a torque was cut to its limit
        """
    @property
    def step(self) -> int:
        """
        number of the step
        """
    @property
    def support(self) -> int:
        """
        +1 left, -1 right: the foot that carries the ZMP
        """
    @property
    def t(self) -> float:
        """
        simulation time of the state [s]
        """
    @property
    def tau(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        joint torques, in the order of the joints (nu,) [N m]
        """
    @property
    def torque_ratio(self) -> float:
        """
        largest |tau| / limit
        """
    @property
    def v_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        desired velocity (v_x, v_y, w_z), heading frame
        """
    @property
    def v_error_integral(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        integral of v_des - v_plan (3,) [m, m, rad]
        """
    @property
    def v_plan(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[3, 1]"]:
        """
        planned velocity (v_x, v_y, w_z), heading frame
        """
    @property
    def w_T(self) -> float:
        """
        eq. 18: lateral velocity in the middle of the next single support if the ZMP switched now [m/s]
        """
    @property
    def zmp_des(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        desired ZMP (2,) [m]
        """
    @property
    def zmp_est(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        estimated ZMP (2,) [m]
        """
    @property
    def zmp_first(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        estimate of the first pass of III-B (2,) [m], NaN where the ZMP was left alone
        """
    @property
    def zmp_lower(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        designed lower bound (2,) [m]
        """
    @property
    def zmp_modified(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        -1 brought to the lower bound, +1 to the upper, 0 left alone (2,)
        """
    @property
    def zmp_ref(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        reference ZMP of the pendulum (2,) [m]
        """
    @property
    def zmp_slope(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        d zmp_est / d zmp_ref (2,)
        """
    @property
    def zmp_upper(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
        """
        designed upper bound (2,) [m]
        """

class WalkingController:
    """
    One update(data) -> CycleOutput per physics step: state in, torque out.

    Takes eq. (16) for the desired COM state, (1)-(8) for the torque, (9)-(15) for the ZMP it will produce, III-B to correct it.
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
    def command(
        self,
        vx: typing.SupportsFloat | typing.SupportsIndex,
        vy: typing.SupportsFloat | typing.SupportsIndex = 0.0,
        wz: typing.SupportsFloat | typing.SupportsIndex = 0.0,
    ) -> None:
        """
        From the next cycle on, walk with (vx, vy, wz) in the heading frame instead of the profile's velocity; until reset().

        May be called from any thread, at any time. What the legs cannot reach is scaled down to `within_reach`; how fast the
        robot takes a command up is limited (settings forward_jump, forward_acceleration, ...).

        Args:
            vx, vy: [m/s].
            wz: [rad/s].

        Raises:
            InputError: not finite.
        """
    def knee_share(self, speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        Share of the knee's torque limit that its own rotor and damping take at lift-off, walking at speed [m/s].
        """
    def move(self, motion: JointMotion) -> None:
        """
        Joints outside the legs, and the trunk, follow `motion` from now on; see the package's WalkingController.
        """
    def plan(
        self,
        duration: typing.SupportsFloat | typing.SupportsIndex = 3.2,
        dt: typing.SupportsFloat | typing.SupportsIndex = 0.01,
    ) -> dict:
        """
        Footsteps, COM and ZMP ahead of time, for a robot that does as it is told, from where the last reset was.

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
        Largest speed of the footsteps minus the planned one within `duration` [s]; 0 where steps follow the profile [m/s].
        """
    def reach_share(self, velocity: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"]) -> float:
        """
        Share of the legs' reach that walking with velocity (v_x, v_y, w_z) takes; at most 1 can be walked.
        """
    def reset(self, data: typing.Any) -> None:
        """
        Reads the state and starts a walk there; moves nothing.

        Raises:
            InputError: the state is not finite.
        """
    def update(self, data: typing.Any, after_step1: bool = False) -> CycleOutput:
        """
        Computes the torque for the state in `data`, writes data.ctrl, returns a copy of what was decided.

        Args:
            data: mujoco.MjData.
            after_step1: mj_step1 (or mj_forward) has just run for this state, so that `data` holds kinematics,
                inertia and bias forces already; the torque has the same bits, in half the time.

        Raises:
            InputError: the state is not finite, its terms belong to another, or reset() was not called; nothing is
                changed.
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
        Designed bounds (lower, upper), each (2,), in the sole's axes about its centre [m].
        """
    @property
    def Tc(self) -> float:
        """
        sqrt(z_c / g) [s]
        """
    @property
    def arm_joints(self) -> list[str]:
        """
        joints outside the legs that carry less than a fifth of the robot's mass: arms, not the waist
        """
    @property
    def com_height(self) -> float:
        """
        z_c over the soles [m]
        """
    @property
    def description(self) -> RobotDescription: ...
    @property
    def joint_names(self) -> list[str]: ...
    @property
    def mass(self) -> float:
        """
        [kg]
        """
    @property
    def motion(self) -> JointMotion: ...
    @property
    def profile(self) -> VelocityProfile: ...
    @property
    def settings(self) -> WalkSettings:
        """
        WalkSettings in force, every NaN filled in
        """
    @property
    def speed_limit(self) -> float:
        """
        largest v_x that the legs reach [m/s]
        """
    @property
    def torque_limit(self) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[m, 1]"]:
        """
        (nu,) [N m]
        """
    @property
    def torque_path(self) -> dict:
        """
        how each joint's torque reaches MuJoCo, by joint name: "motor 'l_knee'", "qfrc_applied: position servo 'l_knee' is silenced", ...
        """

class Recorder:
    """
    Cycle records as columns; row k is the state before step k and what was decided there.
    """
    def __init__(self, controller: WalkingController) -> None: ...
    def __len__(self) -> int: ...
    def add(self, out: CycleOutput, data: typing.Any) -> None:
        """
        Adds one row; call right after mj_step, while `data` holds the contact forces of this cycle. Held cycles add none.
        """
    def columns(self) -> dict:
        """
        Columns by name, (T,) or (T, n): a copy.
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
    Times the parts of every cycle of a walk side by side.

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

def build_info() -> dict:
    """
    How this copy was built, and what it runs here.

    Returns:
        dict: version, mujoco (compiled against), compiler, kernels (builds of the inner loops that this processor runs),
        kernel (the one that 'auto' takes).

    Usage:
        >>> zmpwalk.build_info()['kernel']
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
    Shares a total wrench (F, M about P) between two feet with sole centres c, exactly; (12,).
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
    The loop of III-B: r_ref <- r_ref + r_des - r_est(r_ref).

    Args:
        estimate: callable (2,) -> (2,).
        zmp_des: (2,) [m].
        threshold: [m].
    """

def measured_zmp(
    model: typing.Any, data: typing.Any, description: RobotDescription
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
    """
    ZMP of MuJoCo's contact forces under the feet (2,) [m], W; NaN without contact. After mj_step it belongs to the state before it.
    """

def mujoco_version() -> str:
    """
    MuJoCo version this module was compiled against.
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

def simulate(
    controller: WalkingController,
    duration: typing.SupportsFloat | typing.SupportsIndex,
    on_progress: typing.Any = None,
    command: typing.Any = None,
    command_interval: typing.SupportsFloat | typing.SupportsIndex = 0.02,
) -> tuple:
    """
    Closed loop in C++ from the start pose, the interpreter's lock released.

    Args:
        controller: WalkingController.
        duration: [s].
        on_progress: called as f(t, duration) about 20 times a second; may raise.
        command: called as f(t, out) after the first cycle and then every `command_interval` [s]; returns
            (vx, vy, wz) or None, which leaves the command as it is; StopIteration ends the run.

    Returns:
        (columns, info).

    Raises:
        InputError; whatever a callback raises; KeyboardInterrupt.
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
    The fixed point of that loop in closed form, for an affine estimate.
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
    Designed bounds of the ZMP about the sole's centre (lower, upper), each (2,) [m].
    """

def zmp_of_wrench(
    F: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
    M: typing.Annotated[numpy.typing.ArrayLike, numpy.float64, "[3, 1]"],
) -> typing.Annotated[numpy.typing.NDArray[numpy.float64], "[2, 1]"]:
    """
    Eq. 14, 15: (-M_y / F_z, M_x / F_z) (2,) [m].
    """
