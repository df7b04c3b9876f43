#include "bind_tasks.hpp"

#include <map>
#include <optional>

#include "zmpwalk/control/external.hpp"
#include "zmpwalk/control/tasks/frame.hpp"
#include "zmpwalk/control/tasks/joint.hpp"
#include "zmpwalk/control/tasks/momentum.hpp"
#include "zmpwalk/gait/joint_motion.hpp"

using namespace zmpwalk;

namespace {

template <class Value>
Value one_of(const char* what, const std::string& name, const std::map<std::string, Value>& known) {
  if (const auto found = known.find(name); found != known.end()) return found->second;
  std::string names;
  for (const auto& [each, value] : known) names += (names.empty() ? "" : ", ") + each;
  throw InputError(std::string(what) + " = '" + name + "' is unknown; there are: " + names);
}

/// What a Python task is given: this instant, and frames by their names.
class TaskState {
 public:
  explicit TaskState(std::map<std::string, int>& frames) : frames_(frames) {}

  /// @param names  where frames may still be asked for that no one watches yet; else none
  void show(const TaskInput& in, RobotNames* names) {
    in_ = &in;
    names_ = names;
    copied_ = false;
  }
  void hide() { in_ = nullptr; }
  const TaskInput& in() const {
    if (!in_) throw InputError("a task's state is good only while its compute(state) runs; copy what you keep");
    return *in_;
  }
  /// A copy, made where it is asked for: it is as good after the cycle as in it.
  const Dynamics& dynamics() {
    if (!copied_) dynamics_ = in().dynamics;
    copied_ = true;
    return *dynamics_;
  }
  FrameState frame(const std::string& name) {
    in();
    auto found = frames_.find(name);
    if (found == frames_.end()) {
      if (!names_)
        throw InputError("the frame '" + name +
                         "' was not asked for in the first compute(state), which is when the "
                         "frames are chosen that every cycle reads");
      found = frames_.emplace(name, names_->frame(name)).first;
    }
    return in().dynamics.frames[static_cast<std::size_t>(found->second)];
  }

 private:
  std::map<std::string, int>& frames_;
  const TaskInput* in_ = nullptr;
  RobotNames* names_ = nullptr;
  std::optional<Dynamics> dynamics_;
  bool copied_ = false;
};

/// A Python object with compute(state) -> J, drift, f_star.
class PythonTask : public Task {
 public:
  explicit PythonTask(py::object task) : task_(std::move(task)), state_(py::cast(new TaskState(frames_))) {}
  ~PythonTask() override {
    py::gil_scoped_acquire locked;
    state_ = py::object();
    task_ = py::object();
  }

  int rows() const override { return rows_; }

  void attach(RobotNames& names) override {
    // Its first compute tells the number of rows, and which frames it will ask for.
    py::gil_scoped_acquire locked;
    const Dynamics& dynamics = names.dynamics();
    const auto [J, drift, f_star] = call({dynamics, 0.0, 0.0, 0.0}, &names);
    require_shape("J", J.rows(), J.cols(), f_star.size(), dynamics.nv());
    require_size("drift", drift.size(), f_star.size());
    if (f_star.size() == 0) throw InputError("compute(state) returned no row");
    rows_ = static_cast<int>(f_star.size());
  }

  void compute(const TaskInput& in, TaskRows& out) override {
    py::gil_scoped_acquire locked;
    const auto [J, drift, f_star] = call(in, nullptr);
    require_shape("J", J.rows(), J.cols(), out.J.rows(), out.J.cols());
    require_size("drift", drift.size(), out.drift.size());
    require_size("f_star", f_star.size(), out.f_star.size());
    if (!(J.allFinite() && drift.allFinite() && f_star.allFinite()))
      throw InputError("compute(state) returned something that is not finite");
    out.J = J;
    out.drift = drift;
    out.f_star = f_star;
  }

 private:
  std::tuple<RowMatX, VecX, VecX> call(const TaskInput& in, RobotNames* names) {
    TaskState& state = state_.cast<TaskState&>();
    state.show(in, names);
    const py::object answer = py::reinterpret_steal<py::object>(
        PyObject_CallMethodObjArgs(task_.ptr(), py::str("compute").ptr(), state_.ptr(), nullptr));
    state.hide();
    if (!answer) throw py::error_already_set();
    try {
      return answer.cast<std::tuple<RowMatX, VecX, VecX>>();
    } catch (const py::cast_error&) {
      throw InputError("compute(state) must return (J, drift, f_star), arrays of shape (m, nv), (m,), (m,)");
    }
  }

  std::map<std::string, int> frames_;
  py::object task_, state_;
  int rows_ = 0;
};

}  // namespace

std::vector<ExternalWrench> external_of(WalkingController& controller, const py::object& external) {
  std::vector<ExternalWrench> out;
  if (external.is_none()) return out;
  for (const auto& [name, wrench] : external.cast<std::map<std::string, VecX>>()) {
    require_size(("external['" + name + "']").c_str(), wrench.size(), 6);
    out.push_back({controller.watch(name), Vec6(wrench)});
  }
  return out;
}

void bind_tasks(py::module_& m) {
  py::class_<Task, std::shared_ptr<Task>>(m, "Task", "Something that the robot is to do while it walks.")
      .def_readwrite("priority", &Task::priority, "a task with a smaller number comes first")
      .def_readwrite("weight", &Task::weight, "share of its correction that is applied, 0 to 1");

  py::class_<PoseReference>(m, "PoseReference",
                            "Where a frame is to be and how it is to move there, in the frame that it is relative to.")
      .def(py::init([](const Vec3& p, const Mat3& R, const Vec6& velocity, const Vec6& acceleration) {
             return PoseReference{p, R, velocity, acceleration};
           }),
           "p"_a = Vec3(Vec3::Zero()), "R"_a = Mat3(Mat3::Identity()), "velocity"_a = Vec6(Vec6::Zero()),
           "acceleration"_a = Vec6(Vec6::Zero()))
      .def_readwrite("p", &PoseReference::p, "position (3,) [m]")
      .def_readwrite("R", &PoseReference::R, "orientation (3, 3)")
      .def_readwrite("velocity", &PoseReference::velocity, "linear, angular (6,) [m/s, rad/s]")
      .def_readwrite("acceleration", &PoseReference::acceleration,
                     "linear, angular (6,), fed forward [m/s^2, rad/s^2]");

  py::class_<FrameTask, Task, std::shared_ptr<FrameTask>>(m, "FrameTask",
                                                          "The frame of a body or a site follows a pose.")
      .def(py::init([](const std::string& frame, const std::string& part, const std::string& relative_to, double kp,
                       double kd) {
             const auto which = one_of<FramePart>("part", part,
                                                  {{"position", FramePart::kPosition},
                                                   {"orientation", FramePart::kOrientation},
                                                   {"pose", FramePart::kPose}});
             const auto to = one_of<RelativeTo>(
                 "relative_to", relative_to,
                 {{"world", RelativeTo::kWorld}, {"walk", RelativeTo::kWalk}, {"trunk", RelativeTo::kTrunk}});
             return std::make_shared<FrameTask>(frame, which, to, kp, kd);
           }),
           "frame"_a, "part"_a = "pose", "relative_to"_a = "world", "kp"_a = 400.0, "kd"_a = 40.0)
      .def("set", &FrameTask::set, "reference"_a, "From the next cycle on, the reference is this one.")
      .def("follow", &FrameTask::follow, "reference"_a,
           "The reference is a function of the time since the task began [s] that returns a PoseReference.")
      .def_property_readonly("reference", &FrameTask::reference, "the reference of the last cycle");

  py::class_<JointTask, Task, std::shared_ptr<JointTask>>(m, "JointTask", "Joints outside the legs follow references.")
      .def(py::init<std::vector<std::string>, double, double>(), "joints"_a, "kp"_a = 400.0, "kd"_a = 40.0)
      .def("set", &JointTask::set, "q"_a, "dq"_a, "ddq"_a,
           "From the next cycle on, the references are these, each (m,) [rad or m].")
      .def(
          "follow",
          [](JointTask& task, const JointMotion& motion) {
            const auto rows = static_cast<Eigen::Index>(motion.names().size());
            VecX low(rows), high(rows);
            for (int i = 0; i < rows; ++i) {
              low[i] = motion.extent(i).low;
              high[i] = motion.extent(i).high;
            }
            task.follow([motion](double t, int i) { return motion.at(t, i); }, low, high);
          },
          "motion"_a, "The references follow `motion` from when the task begins.");

  py::class_<MomentumTask, Task, std::shared_ptr<MomentumTask>>(
      m, "MomentumTask",
      "Keeps the angular momentum about the COM small: it is brought to that of one body which turns as the walk "
      "turns.")
      .def(py::init([](const std::string& axes, double kd) {
             return std::make_shared<MomentumTask>(
                 one_of<MomentumTask::Axes>("axes", axes,
                                            {{"yaw", MomentumTask::Axes::kYaw}, {"all", MomentumTask::Axes::kAll}}),
                 kd);
           }),
           "axes"_a = "yaw", "kd"_a = 20.0);

  py::class_<TaskState>(
      m, "TaskState",
      "The robot at one instant, as a task of your own gets it. It may be used only while its compute(state) runs.")
      .def_property_readonly(
          "t", [](const TaskState& s) { return s.in().t; }, "time since the walk was reset [s]")
      .def_property_readonly(
          "heading", [](const TaskState& s) { return s.in().heading; }, "heading of the walk in the world [rad]")
      .def_property_readonly(
          "heading_rate", [](const TaskState& s) { return s.in().heading_rate; },
          "planned rate at which the heading turns [rad/s]")
      .def_property_readonly("dynamics", &TaskState::dynamics, "Dynamics: q, dq, com, J_com, drift_com, A, b, ...")
      .def("frame", &TaskState::frame, "name"_a,
           "FrameState of a body or site: p_WF, R_WF, velocity, J (6, nv), drift (6,). The first compute(state), when "
           "the task is\nadded, chooses which frames every cycle reads.\n\nRaises:\n    InputError: there is none of "
           "that name, or it was not asked for in the first compute.");

  py::class_<PythonTask, Task, std::shared_ptr<PythonTask>>(m, "PythonTask",
                                                            "A Python object with compute(state) as a task.")
      .def(py::init<py::object>(), "task"_a);
}
