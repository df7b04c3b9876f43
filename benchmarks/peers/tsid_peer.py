"""TSID on the states of problem.json: `python tsid_peer.py FOLDER`, in the peers' own environment; see serve.py."""

import importlib.metadata
import json
import sys
from pathlib import Path

import numpy as np
import pinocchio
import tsid
from serve import serve

if not hasattr(tsid, "RobotWrapper"):  # the wheel of 1.7.1 puts its __init__.py one folder too deep
    sys.path.insert(0, next(iter(tsid.__path__)))
    import tsid_pywrap as tsid


class Peer:
    """One formulation per phase: COM, trunk, swing foot and posture as costs of one level, contacts as constraints."""

    def __init__(self, folder):
        self.problem = problem = json.loads((folder / "problem.json").read_text())
        self.states = {phase: part["states"] for phase, part in problem["phases"].items()}
        # Commanded accelerations go in as feed-forward, so every gain is zero.
        self.phases = {phase: self.formulate(folder, part) for phase, part in problem["phases"].items()}

    def formulate(self, folder, part):
        problem, weights = self.problem, self.problem["tsid"]
        model = pinocchio.buildModelFromUrdf(str(folder / "robot.urdf"), pinocchio.JointModelFreeFlyer())
        index = np.array([model.joints[model.getJointId(name)].idx_v - 6 for name in problem["joints"]])
        armature = np.zeros(model.nv)
        armature[6 + index] = problem["armature"]
        model.armature = armature
        robot = tsid.RobotWrapper(model, tsid.FLOATING_BASE_SYSTEM, False)
        formulation = tsid.InverseDynamicsFormulationAccForce("tsid", robot, False)
        formulation.computeProblemData(0.0, pinocchio.neutral(model), np.zeros(model.nv))
        data = formulation.data()

        contacts = []
        for frame in part["standing"]:
            x, y = 0.5 * problem["sole_length"], 0.5 * problem["sole_width"]
            corners = np.array([[x, x, -x, -x], [y, -y, y, -y], [0.0, 0.0, 0.0, 0.0]])
            contact = tsid.Contact6d(
                frame,
                robot,
                frame,
                corners,
                np.array([0.0, 0.0, 1.0]),
                problem["friction"],
                weights["min_force"],
                weights["max_force"],
            )
            contact.setKp(np.zeros(6))
            contact.setKd(np.zeros(6))
            contact.setReference(robot.framePosition(data, model.getFrameId(frame)))
            formulation.addRigidContact(contact, weights["force"])
            contacts.append(contact)

        tasks, samples = {}, {}

        def add(name, task, size, sample):
            task.setKp(np.zeros(size))
            task.setKd(np.zeros(size))
            formulation.addMotionTask(task, weights["motion"], 1, 0.0)
            tasks[name], samples[name] = task, sample

        add("com", tsid.TaskComEquality("com", robot), 3, tsid.TrajectorySample(3))
        frames = {"trunk": (problem["root_link"], [0, 0, 0, 1, 1, 1])}
        if part["swing"]:
            frames["swing"] = (part["swing"], [1, 1, 1, 1, 1, 1])
        for name, (frame, mask) in frames.items():
            task = tsid.TaskSE3Equality(name, robot, frame)
            task.useLocalFrame(False)
            task.setMask(np.array(mask, float))
            sample = tsid.TrajectorySample(12, 6)
            sample.value(np.concatenate([np.zeros(3), np.eye(3).ravel()]))  # zero gain, but no rotation gives NaN
            add(name, task, 6, sample)
        mask = np.zeros(len(index))
        mask[index[problem["posture_joints"]]] = 1.0
        posture = tsid.TaskJointPosture("posture", robot)
        posture.setMask(mask)
        add("posture", posture, len(index), tsid.TrajectorySample(len(index)))

        solver = tsid.SolverHQuadProgFast("solver")
        solver.resize(formulation.nVar, formulation.nEq, formulation.nIn)
        return {
            "model": model,
            "robot": robot,
            "index": index,
            "formulation": formulation,
            "solver": solver,
            "contacts": contacts,
            "tasks": tasks,
            "samples": samples,
        }

    def load(self, phase, k):
        p, state = self.phases[phase], self.states[phase][k]
        p["q"], p["v"] = (np.array(state[name]) for name in ("q", "v"))
        for name in ("q", "v"):
            offset = len(p[name]) - len(p["index"])
            joints = p[name][offset:].copy()
            p[name][offset + p["index"]] = joints
        for name, task in p["tasks"].items():
            sample, acceleration = p["samples"][name], np.zeros(len(p["samples"][name].second_derivative()))
            if name == "posture":
                acceleration[p["index"]] = state[name]
            else:
                acceleration[-len(state[name]) :] = state[name]
            sample.second_derivative(acceleration)
            task.setReference(sample)

    def tick(self, phase):
        p = self.phases[phase]
        data = p["formulation"].computeProblemData(0.0, p["q"], p["v"])
        p["solution"] = p["solver"].solve(data)
        p["tau"] = p["formulation"].getActuatorForces(p["solution"])
        p["ddq"] = p["formulation"].getAccelerations(p["solution"])

    def result(self, phase):
        p = self.phases[phase]
        wrenches = {}
        for contact in p["contacts"]:
            force = p["formulation"].getContactForce(contact.name, p["solution"])
            R = p["robot"].framePosition(p["formulation"].data(), p["robot"].model().getFrameId(contact.name)).rotation
            local = contact.getForceGeneratorMatrix @ force
            wrenches[contact.name] = (-np.concatenate([R @ local[:3], R @ local[3:]])).tolist()
        return {
            "status": int(p["solution"].status),
            "tau": p["tau"][p["index"]].tolist(),
            "ddq": np.concatenate([p["ddq"][:6], p["ddq"][6:][p["index"]]]).tolist(),
            "wrenches": wrenches,
        }

    def versions(self):
        return {name: importlib.metadata.version(name) for name in ("tsid", "pin", "eiquadprog")}

    def size(self):
        return {
            phase: {"variables": f.nVar, "equalities": f.nEq, "inequalities": f.nIn}
            for phase, f in ((phase, p["formulation"]) for phase, p in self.phases.items())
        }

    def model(self):
        """Inertia, nonlinear effects, COM and sole positions at the states of the model check, joints in our order."""
        p = self.phases["ss"]
        model, answer = p["model"], []
        data = model.createData()
        q_order = np.concatenate([np.arange(7), 7 + p["index"]])
        v_order = np.concatenate([np.arange(6), 6 + p["index"]])
        for state in self.problem["model_states"]:
            q, v = np.empty(model.nq), np.empty(model.nv)
            q[q_order], v[v_order] = state["q"], state["v"]
            M = pinocchio.crba(model, data, q)
            M = np.triu(M) + np.triu(M, 1).T
            h = pinocchio.nonLinearEffects(model, data, q, v)
            pinocchio.framesForwardKinematics(model, data, q)
            answer.append(
                {
                    "M": M[np.ix_(v_order, v_order)].tolist(),
                    "h": h[v_order].tolist(),
                    "com": pinocchio.centerOfMass(model, data, q).tolist(),
                    "soles": [data.oMf[model.getFrameId(f)].translation.tolist() for f in ("left_sole", "right_sole")],
                }
            )
        return answer


if __name__ == "__main__":
    serve(Peer(Path(sys.argv[1])))
