// TSID from C++ on the states of problem.json: `tsid_peer FOLDER`; the commands of serve.py, the formulation of tsid_peer.py.

#include <boost/property_tree/json_parser.hpp>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/parsers/urdf.hpp>
#include <sstream>
#include <tsid/contacts/contact-6d.hpp>
#include <tsid/formulations/inverse-dynamics-formulation-acc-force.hpp>
#include <tsid/robots/robot-wrapper.hpp>
#include <tsid/solvers/solver-HQP-eiquadprog-fast.hpp>
#include <tsid/tasks/task-com-equality.hpp>
#include <tsid/tasks/task-joint-posture.hpp>
#include <tsid/tasks/task-se3-equality.hpp>

using Eigen::VectorXd;
using Json = boost::property_tree::ptree;
using tsid::trajectories::TrajectorySample;

namespace {

VectorXd numbers(const Json& json) {
  VectorXd values(json.size());
  Eigen::Index i = 0;
  for (const auto& entry : json) values[i++] = entry.second.get_value<double>();
  return values;
}

template <class Vector>
std::string to_json(const Vector& values) {
  std::ostringstream text;
  text << std::setprecision(17) << '[';
  for (Eigen::Index i = 0; i < values.size(); ++i) text << (i ? "," : "") << values[i];
  return text.str() + ']';
}

struct State {
  VectorXd q, v, com, trunk, swing, posture;
};

/// One formulation: COM, trunk, swing foot and posture as costs of one level, contacts as constraints.
class Phase {
 public:
  Phase(const std::string& folder, const Json& problem, const Json& part) {
    pinocchio::Model model;
    pinocchio::urdf::buildModel(folder + "/robot.urdf", pinocchio::JointModelFreeFlyer(), model);
    for (const auto& name : problem.get_child("joints"))
      index_.push_back(model.joints[model.getJointId(name.second.data())].idx_v() - 6);
    model.armature.tail(model.nv - 6) = from_ours(numbers(problem.get_child("armature")));
    robot_ = std::make_unique<tsid::robots::RobotWrapper>(model, tsid::robots::RobotWrapper::FLOATING_BASE_SYSTEM);
    formulation_ = std::make_unique<tsid::InverseDynamicsFormulationAccForce>("tsid", *robot_, false);
    formulation_->computeProblemData(0.0, pinocchio::neutral(model), VectorXd::Zero(model.nv));

    const Json& weights = problem.get_child("tsid");
    const double x = 0.5 * problem.get<double>("sole_length"), y = 0.5 * problem.get<double>("sole_width");
    Eigen::MatrixXd corners(3, 4);
    corners << x, x, -x, -x, y, -y, y, -y, 0, 0, 0, 0;
    for (const auto& entry : part.get_child("standing")) {
      const std::string& frame = entry.second.data();
      auto contact = std::make_unique<tsid::contacts::Contact6d>(
          frame, *robot_, frame, corners, Eigen::Vector3d::UnitZ(), problem.get<double>("friction"),
          weights.get<double>("min_force"), weights.get<double>("max_force"));
      contact->Kp(VectorXd::Zero(6));
      contact->Kd(VectorXd::Zero(6));
      contact->setReference(robot_->framePosition(formulation_->data(), model.getFrameId(frame)));
      formulation_->addRigidContact(*contact, weights.get<double>("force"));
      contacts_.push_back(std::move(contact));
    }

    const double weight = weights.get<double>("motion");
    com_ = std::make_unique<tsid::tasks::TaskComEquality>("com", *robot_);
    trunk_ = se3("trunk", problem.get<std::string>("root_link"), 0.0);
    posture_ = std::make_unique<tsid::tasks::TaskJointPosture>("posture", *robot_);
    VectorXd mask = VectorXd::Zero(model.nv - 6);
    for (const auto& i : problem.get_child("posture_joints")) mask[index_[i.second.get_value<int>()]] = 1.0;
    posture_->setMask(mask);
    add(*com_, 3, weight);
    add(*trunk_, 6, weight);
    add(*posture_, model.nv - 6, weight);
    if (const auto swing = part.get<std::string>("swing"); !swing.empty()) {
      swing_ = se3("swing", swing, 1.0);
      add(*swing_, 6, weight);
    }
    solver_.resize(formulation_->nVar(), formulation_->nEq(), formulation_->nIn());

    const Json none;
    for (const auto& entry : part.get_child("states")) {
      const auto get = [&](const char* name) { return numbers(entry.second.get_child(name, none)); };
      State state{get("q"), get("v"), get("com"), get("trunk"), get("swing"), from_ours(get("posture"))};
      for (VectorXd* x : {&state.q, &state.v}) x->tail(index_.size()) = from_ours(x->tail(index_.size()));
      states_.push_back(state);
    }
  }

  int states() const { return static_cast<int>(states_.size()); }

  void load(int k) {
    state_ = &states_[k];
    TrajectorySample com(3), frame(12, 6), posture(index_.size());
    com.setSecondDerivative(state_->com);
    com_->setReference(com);
    VectorXd placement = VectorXd::Zero(12), acceleration = VectorXd::Zero(6);
    placement[3] = placement[7] = placement[11] = 1.0;  // zero gain, but no rotation gives NaN
    frame.setValue(placement);
    acceleration.tail<3>() = state_->trunk;
    frame.setSecondDerivative(acceleration);
    trunk_->setReference(frame);
    posture.setSecondDerivative(state_->posture);
    posture_->setReference(posture);
    if (swing_) {
      frame.setSecondDerivative(state_->swing);
      swing_->setReference(frame);
    }
  }

  void tick() {
    const auto& data = formulation_->computeProblemData(0.0, state_->q, state_->v);
    solution_ = &solver_.solve(data);
    tau_ = formulation_->getActuatorForces(*solution_);
    ddq_ = formulation_->getAccelerations(*solution_);
  }

  std::string result() {
    VectorXd ddq = ddq_;
    ddq.tail(index_.size()) = to_ours(ddq_.tail(index_.size()));
    std::string wrenches;
    for (const auto& contact : contacts_) {
      const Eigen::Matrix3d R =
          robot_->framePosition(formulation_->data(), robot_->model().getFrameId(contact->name())).rotation();
      const VectorXd local =
          contact->getForceGeneratorMatrix() * formulation_->getContactForces(contact->name(), *solution_);
      Eigen::Matrix<double, 6, 1> wrench;
      wrench << -R * local.head<3>(), -R * local.tail<3>();
      wrenches += (wrenches.empty() ? "\"" : ",\"") + contact->name() + "\":" + to_json(wrench);
    }
    return "{\"status\":" + std::to_string(solution_->status) +
           ",\"active\":" + std::to_string(solution_->activeSet.size()) + ",\"tau\":" + to_json(to_ours(tau_)) +
           ",\"ddq\":" + to_json(ddq) + ",\"wrenches\":{" + wrenches + "}}";
  }

 private:
  VectorXd from_ours(const VectorXd& ours) const {
    VectorXd theirs(ours.size());
    for (Eigen::Index i = 0; i < ours.size(); ++i) theirs[index_[i]] = ours[i];
    return theirs;
  }

  VectorXd to_ours(const VectorXd& theirs) const {
    VectorXd ours(theirs.size());
    for (Eigen::Index i = 0; i < ours.size(); ++i) ours[i] = theirs[index_[i]];
    return ours;
  }

  std::unique_ptr<tsid::tasks::TaskSE3Equality> se3(const std::string& name, const std::string& frame, double linear) {
    auto task = std::make_unique<tsid::tasks::TaskSE3Equality>(name, *robot_, frame);
    task->useLocalFrame(false);
    VectorXd mask = VectorXd::Ones(6);
    mask.head<3>().setConstant(linear);
    task->setMask(mask);
    return task;
  }

  template <class Task>
  void add(Task& task, Eigen::Index size, double weight) {
    task.Kp(VectorXd::Zero(size));  // commanded accelerations go in as feed-forward
    task.Kd(VectorXd::Zero(size));
    formulation_->addMotionTask(task, weight, 1, 0.0);
  }

  std::vector<State> states_;
  const State* state_ = nullptr;
  std::vector<Eigen::Index> index_;  // of each of our joints in pinocchio's order
  std::unique_ptr<tsid::robots::RobotWrapper> robot_;
  std::unique_ptr<tsid::InverseDynamicsFormulationAccForce> formulation_;
  std::vector<std::unique_ptr<tsid::contacts::Contact6d>> contacts_;
  std::unique_ptr<tsid::tasks::TaskComEquality> com_;
  std::unique_ptr<tsid::tasks::TaskSE3Equality> trunk_, swing_;
  std::unique_ptr<tsid::tasks::TaskJointPosture> posture_;
  tsid::solvers::SolverHQuadProgFast solver_{"solver"};
  VectorXd tau_, ddq_;
  const tsid::solvers::HQPOutput* solution_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: tsid_peer FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  Json problem;
  boost::property_tree::read_json(folder + "/problem.json", problem);
  std::map<std::string, Phase> phases;
  for (const auto& part : problem.get_child("phases"))
    phases.emplace(std::piecewise_construct, std::forward_as_tuple(part.first),
                   std::forward_as_tuple(folder, problem, part.second));

  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string command, name;
    words >> command >> name;
    if (command == "versions") {
      std::cout << "{\"compiler\":\"" << __VERSION__ << "\"}" << std::endl;
      continue;
    }
    Phase& phase = phases.at(name);
    if (command == "time") {
      int count = 0;
      words >> count;
      VectorXd nanoseconds(count);
      for (int i = 0; i < count; ++i) {
        phase.load(i % phase.states());
        const auto start = std::chrono::steady_clock::now();
        phase.tick();
        nanoseconds[i] = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
      }
      std::cout << to_json(nanoseconds) << std::endl;
    } else {  // solve
      std::cout << '[';
      for (int k = 0; k < phase.states(); ++k) {
        phase.load(k);
        phase.tick();
        std::cout << (k ? "," : "") << phase.result();
      }
      std::cout << ']' << std::endl;
    }
  }
}
