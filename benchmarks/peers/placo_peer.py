"""placo on the states of problem.json: `python placo_peer.py FOLDER`, in an environment of its own; see serve.py."""

import importlib.metadata
import json
import sys
import time
from pathlib import Path

import numpy as np
import placo
from serve import serve


class Peer:
    """One dynamics solver per phase: contacts as hard constraints, the other tasks as costs, as in placo's examples."""

    def __init__(self, folder):
        self.problem = problem = json.loads((folder / "problem.json").read_text())
        self.urdf = str(folder / "robot.urdf")
        self.states = {phase: part["states"] for phase, part in problem["phases"].items()}
        self.phases = {phase: self.formulate(part) for phase, part in problem["phases"].items()}

    def formulate(self, part):
        problem, weights = self.problem, self.problem["placo"]
        robot = placo.RobotWrapper(self.urdf, placo.Flags.ignore_collisions)
        index = np.array([robot.get_joint_v_offset(name) - 6 for name in problem["joints"]])
        for name, inertia in zip(problem["joints"], problem["armature"]):
            robot.set_rotor_inertia(name, inertia)
            robot.set_gear_ratio(name, 1.0)
        robot.update_kinematics()
        solver = placo.DynamicsSolver(robot)
        solver.torque_cost = weights["torque"]
        tasks = {"com": solver.add_com_task(np.zeros(3)), "posture": solver.add_joints_task()}
        tasks["trunk"] = solver.add_orientation_task(problem["root_link"], np.eye(3))
        posture_names = [problem["joints"][i] for i in problem["posture_joints"]]
        tasks["posture"].set_joints(dict.fromkeys(posture_names, 0.0))
        contacts = {}
        for frame in part["standing"]:
            foot = solver.add_frame_task(frame, np.eye(4))
            foot.configure(frame, "hard", 1.0, 1.0)
            contact = solver.add_planar_contact(foot)
            contact.length, contact.width = problem["sole_length"], problem["sole_width"]
            contact.mu = problem["friction"]
            contact.weight_moments = weights["moments"]
            contacts[frame] = contact
            for task in (foot.position(), foot.orientation()):
                task.kp = task.kd = 0.0
        if part["swing"]:
            foot = solver.add_frame_task(part["swing"], np.eye(4))
            tasks["swing_position"], tasks["swing_orientation"] = foot.position(), foot.orientation()
        for name, task in tasks.items():
            task.configure(name, "soft", weights["motion"])
            task.kp = task.kd = 0.0
        return {
            "robot": robot,
            "index": index,
            "solver": solver,
            "contacts": contacts,
            "tasks": tasks,
            "posture_names": posture_names,
        }

    def load(self, phase, k):
        p, state = self.phases[phase], self.states[phase][k]
        p["q"], p["v"] = (np.array(state[name]) for name in ("q", "v"))
        for name in ("q", "v"):
            offset = len(p[name]) - len(p["index"])
            joints = p[name][offset:].copy()
            p[name][offset + p["index"]] = joints
        tasks = p["tasks"]
        tasks["com"].ddtarget_world = np.array(state["com"])
        tasks["trunk"].domega_world = np.array(state["trunk"])
        if "swing_position" in tasks:
            tasks["swing_position"].ddtarget_world = np.array(state["swing"][:3])
            tasks["swing_orientation"].domega_world = np.array(state["swing"][3:])
        for i, name in zip(self.problem["posture_joints"], p["posture_names"]):
            tasks["posture"].set_joint(name, 0.0, 0.0, state["posture"][i])

    def tick(self, phase):
        p = self.phases[phase]
        p["robot"].state.q = p["q"]
        p["robot"].state.qd = p["v"]
        p["robot"].update_kinematics()
        p["solution"] = p["solver"].solve(False)
        p["tau"], p["ddq"] = p["solution"].tau, p["solution"].qdd

    def result(self, phase):
        p = self.phases[phase]
        tau, ddq, wrenches = p["tau"].ravel(), p["ddq"].ravel(), {}
        for frame, contact in p["contacts"].items():
            R, local = p["robot"].get_T_world_frame(frame)[:3, :3], np.ravel(contact.wrench)
            wrenches[frame] = (-np.concatenate([R @ local[:3], R @ local[3:]])).tolist()
        return {
            "status": 0 if p["solution"].success else 1,
            "tau": tau[6:][p["index"]].tolist(),
            "ddq": np.concatenate([ddq[:6], ddq[6:][p["index"]]]).tolist(),
            "wrenches": wrenches,
        }

    def versions(self):
        return {name: importlib.metadata.version(name) for name in ("placo", "pin")}

    def plan(self):
        """Times [ns] to plan a walk: footsteps, supports, COM and ZMP; by the time steps per single support."""
        return {str(timesteps): self.plan_with(timesteps) for timesteps in self.problem["plan"]["timesteps"]}

    def plan_with(self, timesteps):
        plan, problem = self.problem["plan"], self.problem
        robot = placo.HumanoidRobot(self.urdf, placo.Flags.ignore_collisions)
        parameters = placo.HumanoidParameters()
        parameters.single_support_duration = plan["single_support"]
        parameters.single_support_timesteps = timesteps
        parameters.double_support_ratio = plan["double_support"] / plan["single_support"]
        parameters.startend_double_support_ratio = parameters.double_support_ratio
        parameters.planned_timesteps = 1000  # the whole plan, whatever its length
        parameters.walk_com_height = problem["com_height"]
        parameters.walk_max_dx_forward = 2 * plan["step_length"]
        parameters.foot_length, parameters.foot_width = problem["sole_length"], problem["sole_width"]
        parameters.feet_spacing = plan["step_width"]
        robot.state.q = np.array(self.states["ds"][0]["q"])
        robot.update_kinematics()
        left, right = (np.eye(4) for _ in range(2))
        left[1, 3], right[1, 3] = 0.5 * plan["step_width"], -0.5 * plan["step_width"]
        com = np.array([0.0, 0.0, problem["com_height"]])
        times = []
        for _ in range(plan["repeat"]):
            start = time.perf_counter_ns()
            planner = placo.FootstepsPlannerRepetitive(parameters)
            planner.configure(plan["step_length"], 0.0, 0.0, plan["steps"])
            footsteps = planner.plan(placo.HumanoidRobot_Side.left, left, right)
            supports = placo.FootstepsPlanner.make_supports(footsteps, 0.0, True, True, True)
            trajectory = placo.WalkPatternGenerator(robot, parameters).plan(supports, com, 0.0)
            times.append(time.perf_counter_ns() - start)
        return {"ns": times, "planned_s": trajectory.t_end - trajectory.t_start}


if __name__ == "__main__":
    serve(Peer(Path(sys.argv[1])))
