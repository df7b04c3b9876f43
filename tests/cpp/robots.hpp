#pragma once

#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "testing.hpp"
#include "zmpwalk/control/whole_body.hpp"
#include "zmpwalk/robot/robot.hpp"

// The bundled humanoid, alone and in scenes, and random states of it.

namespace zmpwalk::testing {

/// The program links the adapter and libmujoco.
inline const bool connected = (connect(zmpwalk_adapter_of, RTLD_DEFAULT), true);

struct ModelDeleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
using ModelPtr = std::unique_ptr<mjModel, ModelDeleter>;

inline ModelPtr load_file(const std::string& path) {
  char error[500] = "";
  ModelPtr m(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
  if (!m) throw std::runtime_error(path + ": " + error);
  return m;
}

/// A model from MJCF text. MuJoCo's versions hold files in memory differently, so it goes through a file.
inline ModelPtr load_text(const std::string& xml) {
  static int count = 0;
  std::random_device device;
  const auto path = std::filesystem::temp_directory_path() /
                    ("zmpwalk_" + std::to_string(device()) + "_" + std::to_string(count++) + ".xml");
  std::ofstream(path) << xml;
  try {
    ModelPtr m = load_file(path.string());
    std::filesystem::remove(path);
    return m;
  } catch (...) {
    std::filesystem::remove(path);
    throw;
  }
}

inline std::string mahru_text() {
  std::ostringstream text;
  text << std::ifstream(ZMPWALK_ROBOTS_DIR "/mahru.xml").rdbuf();
  return text.str();
}

/// `text` with the first `from` replaced by `to`; fails where there is none, so that no test passes on the wrong model.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no '" + from + "' in the model");
  return text.replace(at, from.size(), to);
}

/// The bundled humanoid; loaded once.
inline const mjModel* mahru() {
  static const ModelPtr m = load_file(ZMPWALK_ROBOTS_DIR "/mahru.xml");
  return m.get();
}

/// The humanoid as the third tree of a scene: a free box and a motor-driven pendulum stand before it.
inline ModelPtr mahru_in_a_scene() {
  std::string text = mahru_text();
  text.erase(text.find("<keyframe>"), text.find("</keyframe>") + 11 - text.find("<keyframe>"));
  text = replaced(
      text, "<worldbody>",
      "<worldbody>"
      "<body name='box' pos='2 1 0.2'><freejoint name='box'/>"
      "<inertial mass='3' pos='0 0 0' diaginertia='0.02 0.02 0.02'/><geom type='box' size='0.1 0.1 0.1'/></body>"
      "<body name='arm' pos='-2 1 1'><joint name='arm' type='hinge' axis='0 1 0' damping='1'/>"
      "<inertial mass='1' pos='0 0 -0.3' diaginertia='0.01 0.01 0.01'/></body>");
  return load_text(replaced(text, "<actuator>", "<actuator><motor joint='arm'/>"));
}

struct DataDeleter {
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using MjDataPtr = std::unique_ptr<mjData, DataDeleter>;

inline MjDataPtr make_data(const mjModel* m) { return MjDataPtr(mj_makeData(m)); }

/// Gives the robot a random state: base anywhere, joints +-0.3 rad about `stand` with knees >= 0.3 rad, |dq| <= 1.
inline void randomize(const Robot& robot, mjData* d, unsigned seed) {
  Numbers numbers(seed);
  mjtNum* q = d->qpos + robot.qpos_address();
  mjtNum* dq = d->qvel + robot.dof_address();
  const Vec3 p = Vec3(0, 0, 0.7) + numbers.vector(3, 0.2), turn = numbers.vector(3, 0.3);
  const Eigen::Quaterniond base(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  Eigen::Map<Eigen::Matrix<double, 7, 1>>{q} << p, base.w(), base.x(), base.y(), base.z();
  for (int j = 0; j < robot.joints(); ++j) {
    q[7 + j] = robot.stand()[j] + numbers.uniform(-0.3, 0.3);
    if (robot.joint_names()[j].find("knee") != std::string::npos) q[7 + j] = std::max(q[7 + j], 0.3);
  }
  Eigen::Map<VecX>{dq, robot.nv()} = numbers.vector(robot.nv(), 1.0);
}

/// The three ways to stand.
enum class Standing { kLeft, kRight, kBoth };
inline constexpr std::array<Standing, 3> kStandings{Standing::kLeft, Standing::kRight, Standing::kBoth};

inline Stance stance_of(Standing standing) {
  Stance stance;
  stance.standing = {standing != Standing::kRight, standing != Standing::kLeft};
  stance.support = standing == Standing::kRight ? kRight : kLeft;
  return stance;
}

/// Rows of the standing feet, left before right.
struct ContactRows {
  RowMatX J;
  VecX drift;
};

inline ContactRows contact_rows(const Dynamics& dyn, const Stance& stance) {
  ContactRows rows{RowMatX(stance.both() ? 12 : 6, dyn.nv()), VecX(stance.both() ? 12 : 6)};
  int row = 0;
  for (const Side side : kSides) {
    if (!stance.standing[side]) continue;
    rows.J.middleRows<6>(row) = dyn.sole[side].J;
    rows.drift.segment<6>(row) = dyn.sole[side].drift;
    row += 6;
  }
  return rows;
}

/// Random commanded accelerations of the size that walking has.
inline TaskAccelerations random_tasks(int joints, unsigned seed) {
  Numbers numbers(seed);
  TaskAccelerations f;
  f.com = numbers.vector(3, 2.0);
  f.trunk = numbers.vector(3, 5.0);
  f.swing = numbers.vector(6, 10.0);
  f.posture = numbers.vector(joints, 10.0);
  return f;
}

}  // namespace zmpwalk::testing
