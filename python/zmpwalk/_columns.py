"""The columns of a Trace as attributes that editors and type checkers know; written by `make columns`."""

from __future__ import annotations

import numpy as np


class RecordedColumns:
    """Every column that zmpwalk records; `Trace.columns()` tells more of each."""

    t: np.ndarray
    """(T,) [s]. Time in the simulation of the state that this cycle read."""

    com: np.ndarray
    """(T, 3) [m]. Measured position of the centre of mass (COM)."""

    dcom: np.ndarray
    """(T, 3) [m/s]. Measured velocity of the COM."""

    com_des: np.ndarray
    """(T, 3) [m]. Position of the COM that the next cycle should find; eq. (16) gives its x and y."""

    dcom_des: np.ndarray
    """(T, 3) [m/s]. Velocity of the COM that the next cycle should find; eq. (16) gives its x and y."""

    heading: np.ndarray
    """(T,) [rad]. Direction in which the path leads, as an angle from the world's x axis."""

    command: np.ndarray
    """(T, 3) [m/s, rad/s]. Live velocity command that is in force; it is NaN while the velocity profile leads."""

    command_limit: np.ndarray
    """(T,). What keeps the live command down: 0 nothing, 1 the reach of the legs, 2 torque of a hip, 3 of a knee, 4
    friction against turning on the sole, 5 friction against sliding."""

    v_plan: np.ndarray
    """(T, 3) [m/s, rad/s]. Planned velocity: that of the command or the profile, changed no faster than the steps can
    follow."""

    v_des: np.ndarray
    """(T, 3) [m/s, rad/s]. Desired velocity: horizontal velocity of the COM that the next cycle should find, and the
    planned turning rate."""

    v_error_integral: np.ndarray
    """(T, 3) [m, rad]. Integral over time of v_des minus v_plan, which velocity tracking (III-C) brings back to zero;
    it is taken along x alone and is zero in the other two."""

    zmp_des: np.ndarray
    """(T, 2) [m]. Desired ZMP: the bound that III-B brings the ZMP to, or the estimate itself where the ZMP is left
    alone."""

    zmp_ref: np.ndarray
    """(T, 2) [m]. Reference ZMP: the ZMP that the pendulum of eq. (16) is given."""

    zmp_est: np.ndarray
    """(T, 2) [m]. ZMP that the torque of this cycle will produce, estimated before it is sent (eq. 14, 15)."""

    zmp_meas: np.ndarray
    """(T, 2) [m]. ZMP of the contact forces that MuJoCo applied under this torque, on the plane of the estimate through
    the sole as the contacts found it; it is NaN without contact."""

    zmp_lower: np.ndarray
    """(T, 2) [m]. Corner of the designed bounds of the ZMP that lies at their lower end along both axes of the support
    sole."""

    zmp_upper: np.ndarray
    """(T, 2) [m]. Corner of the designed bounds of the ZMP that lies at their upper end along both axes of the support
    sole."""

    zmp_plane: np.ndarray
    """(T, 4) [m]. Plane that every zmp_* lies on, as the points p with n . p = d: its unit normal n, which has no unit,
    and d."""

    zmp_first: np.ndarray
    """(T, 2) [m]. Estimated ZMP of the first pass of III-B, whose reference is the desired ZMP; it is NaN where the ZMP
    is left alone."""

    zmp_slope: np.ndarray
    """(T, 2). Derivative of the estimated ZMP with respect to the reference ZMP, along each axis of the support
    sole."""

    zmp_modified: np.ndarray
    """(T, 2). What III-B does along each axis of the support sole: -1 brings the ZMP to the lower bound, +1 to the
    upper bound, 0 leaves it alone."""

    phase: np.ndarray
    """(T,). Phase of the step: 0 is double support, 1 is single support."""

    support: np.ndarray
    """(T,). Foot that carries the ZMP: +1 is the left foot, -1 the right foot."""

    step: np.ndarray
    """(T,). Number of the step, from 0 on; a step is a double support and the single support after it."""

    at_rest: np.ndarray
    """(T,). Whether the robot stands and is not asked to walk."""

    phase_time: np.ndarray
    """(T,) [s]. Time since the phase began."""

    w_T: np.ndarray
    """(T,) [m/s]. Lateral velocity that the COM would have in the middle of the next single support if the ZMP switched
    feet now (eq. 18); it is NaN while no switch is awaited."""

    iterations: np.ndarray
    """(T,). Number of passes of III-B; it is 0 where the ZMP is left alone."""

    foothold: np.ndarray
    """(T, 3) [m, rad]. Place and direction in which the swing foot is to land; it is NaN in double support."""

    foot_left: np.ndarray
    """(T, 7) [m]. Pose of the left sole: position of its centre, and unit quaternion of its axes."""

    foot_right: np.ndarray
    """(T, 7) [m]. Pose of the right sole: position of its centre, and unit quaternion of its axes."""

    tau: np.ndarray
    """(T, joints) [N m]. Torque that is sent to each joint."""

    f_c: np.ndarray
    """(T, 12) [N, N m]. Wrench of the robot on the ground that is expected under each foot, at the centre of its sole;
    f_z < 0 where the foot carries, and a foot in the air has NaN."""

    contact_wrench: np.ndarray
    """(T, 12) [N, N m]. Wrench of the robot on the ground that MuJoCo's contacts gave under each foot, at the centre of
    its sole; a foot without contact has NaN."""

    disturbance: np.ndarray
    """(T, 3) [m/s^2]. Steady acceleration of the COM that the command does not explain and that is made up for: x and y
    as a force, z as a mass that differs from the model's."""

    attitude_bias: np.ndarray
    """(T, 3) [rad]. Rotation vector of the bias that was found in the measured attitude and is taken out of it."""

    ground: np.ndarray
    """(T,) [m]. Height of the ground that the walk follows: that of the soles at the start until the ground is felt to
    be uneven."""

    uneven: np.ndarray
    """(T,). Whether the ground has been felt to be uneven."""

    friction: np.ndarray
    """(T,). Friction that the feet are believed to have; it falls where a foot slips, and recovers slowly."""

    torque_ratio: np.ndarray
    """(T,). Largest ratio of a joint's torque to its limit, before limits are kept or torques cut."""

    saturated: np.ndarray
    """(T,). Whether a torque was cut to its limit, because no motion keeps the limits or because keep_limits is off."""

    limit_soles: np.ndarray
    """(T,). Limits of the soles that held the torque back, as a sum: 1 load, 2 friction, 4 centre of pressure, 8 yaw
    friction of the left sole, and 16 times these of the right one."""

    limit_torques: np.ndarray
    """(T,). Joints whose torque limit held the torque back, as a sum: 2^j for joint j, from 0 on."""

    limit_ranges: np.ndarray
    """(T,). Joints whose range held the torque back, as a sum: 2^j for joint j, from 0 on."""

    damped: np.ndarray
    """(T,). Whether the motion was damped because a leg is nearly straight."""

    self_contacts: np.ndarray
    """(T,). Number of contacts between two bodies of the robot while this torque acted."""

    joint_margin: np.ndarray
    """(T,) [rad or m]. Distance from its limit of the joint that is nearest to one, after this torque acted; it is
    infinite without limits."""

    fall_gap: np.ndarray
    """(T,) [m]. How far the DCM (COM + T_c times its velocity) is beyond what any foothold within reach can catch; it
    is 0 where one can, and NaN where falls are not foreseen."""

    fall_foreseen: np.ndarray
    """(T,). Whether a fall is foreseen; it stays so until the walk is started anew."""

    fell: np.ndarray
    """(T,). Whether the robot has fallen, which ends the walk."""

    qpos: np.ndarray
    """(T, nv + 1) [m, rad]. Configuration of the robot as the cycle began, as in MuJoCo: position and unit quaternion
    of the base, then the joints."""

    qvel: np.ndarray
    """(T, nv) [m/s, rad/s]. Velocity of the robot as the cycle began, as in MuJoCo: of the base, its rotation in its
    own axes, then of the joints."""
