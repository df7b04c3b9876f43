#include "zmpwalk/control/tasks/frame.hpp"

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
/// Pose and velocity of that frame, and how the acceleration of its origin and of its axes follows from ddq.
struct FrameTask::Carrier {
  Carrier(RelativeTo relative_to, const TaskInput& in) {
    const Dynamics& dyn = in.dynamics;
    if (relative_to == RelativeTo::kWalk) {
      p = dyn.com;
      R = rotation_z(in.heading);
      v = dyn.dcom;
      omega.z() = in.heading_rate;
    } else if (relative_to == RelativeTo::kTrunk) {
      p = dyn.p_WB;
      R = dyn.R_WB;
      v = dyn.dq.head<3>();
      omega = dyn.omega_WB;
    }
  }
  Vec3 p = Vec3::Zero(), v = Vec3::Zero(), omega = Vec3::Zero();
  Mat3 R = Mat3::Identity();
};

FrameTask::FrameTask(std::string frame, FramePart part, RelativeTo relative_to, double kp, double kd)
    : name_(std::move(frame)), part_(part), relative_to_(relative_to), kp_(kp), kd_(kd) {
  require_gain("kp", kp);
  require_gain("kd", kd);
}

void FrameTask::set(const PoseReference& reference) {
  const bool finite = reference.p.allFinite() && reference.velocity.allFinite() && reference.acceleration.allFinite();
  if (!finite) throw InputError("the reference of frame '" + name_ + "' is not finite");
  if (!(Mat3(reference.R.transpose() * reference.R).isIdentity(1e-6) && reference.R.determinant() > 0.0))
    throw InputError("the orientation given for frame '" + name_ + "' is no rotation matrix");
  function_ = nullptr;
  reference_ = reference;
  given_ = true;
}

void FrameTask::begin(const TaskInput& in, double blend) {
  t_begin_ = in.t;
  blend_ = blend;
  const FrameState& frame = in.dynamics.frames[frame_];
  const Carrier carrier(relative_to_, in);
  const Mat3 R_CW = carrier.R.transpose();
  const Vec3 arm = frame.p_WF - carrier.p;
  const Vec3 v = R_CW * (frame.velocity.head<3>() - carrier.v - carrier.omega.cross(arm));
  const Vec3 omega = R_CW * (frame.velocity.tail<3>() - carrier.omega);
  if (function_) {
    reference_ = function_(0.0);
  } else if (!given_) {
    reference_ = {R_CW * arm, R_CW * frame.R_WF, Vec6::Zero(), Vec6::Zero()};
  }
  for (int i = 0; i < 3; ++i) away_[i] = {(R_CW * arm)[i] - reference_.p[i], v[i] - reference_.velocity[i], 0.0};
  const Eigen::AngleAxisd turn(Mat3(R_CW * frame.R_WF * reference_.R.transpose()));
  turn_axis_ = turn.axis();
  turned_ = {turn.angle(), turn_axis_.dot(omega - reference_.velocity.tail<3>()), 0.0};
}

PoseReference FrameTask::faded(double t) const {
  PoseReference out = reference_;
  for (int i = 0; i < 3; ++i) {
    const Motion1 away = fade_out(away_[i], blend_, t);
    out.p[i] += away.p;
    out.velocity[i] += away.v;
    out.acceleration[i] += away.a;
  }
  // R = exp(angle axis) R_ref, the axis fixed.
  const Motion1 turned = fade_out(turned_, blend_, t);
  const Mat3 E = Eigen::AngleAxisd(turned.p, turn_axis_).toRotationMatrix();
  const Vec3 omega = E * reference_.velocity.tail<3>(), rate = turned.v * turn_axis_;
  out.R = E * reference_.R;
  out.velocity.tail<3>() = rate + omega;
  out.acceleration.tail<3>() = turned.a * turn_axis_ + rate.cross(omega) + E * reference_.acceleration.tail<3>();
  return out;
}

void FrameTask::compute(const TaskInput& in, TaskRows& out) {
  const Dynamics& dyn = in.dynamics;
  const FrameState& frame = dyn.frames[frame_];
  if (function_) reference_ = function_(in.t - t_begin_);
  const PoseReference wanted = faded(in.t - t_begin_);

  // Carried along to W: p = p_C + r with r = R_C p_ref, and so on; the carrier's own acceleration goes to the rows.
  const Carrier carrier(relative_to_, in);
  const Vec3 r = carrier.R * wanted.p, v_r = carrier.R * wanted.velocity.head<3>(),
             omega_r = carrier.R * wanted.velocity.tail<3>();
  PoseReference world;
  world.p = carrier.p + r;
  world.R = carrier.R * wanted.R;
  world.velocity << carrier.v + carrier.omega.cross(r) + v_r, carrier.omega + omega_r;
  world.acceleration << carrier.R * wanted.acceleration.head<3>() + 2.0 * carrier.omega.cross(v_r) +
                            carrier.omega.cross(carrier.omega.cross(r)),
      carrier.R * wanted.acceleration.tail<3>() + carrier.omega.cross(omega_r);
  const Vec6 f_star = pose_acceleration(world, frame, kp_, kd_);

  const bool turns = part_ != FramePart::kPosition;
  if (part_ != FramePart::kOrientation) {
    out.J.topRows<3>() = frame.J.topRows<3>();
    out.drift.head<3>() = frame.drift.head<3>();
    out.f_star.head<3>() = f_star.head<3>();
    if (relative_to_ == RelativeTo::kWalk) {
      out.J.topRows<3>() -= dyn.J_com;
      out.drift.head<3>() -= dyn.drift_com;
    } else if (relative_to_ == RelativeTo::kTrunk) {  // its origin moves by a_B + alpha_B x r
      out.J.block<3, 3>(0, 0) -= Mat3::Identity();
      out.J.block<3, 3>(0, 3) += skew(r) * dyn.R_WB;
    }
  }
  if (turns) {
    out.J.bottomRows<3>() = frame.J.bottomRows<3>();
    out.drift.tail<3>() = frame.drift.tail<3>();
    out.f_star.tail<3>() = f_star.tail<3>();
    if (relative_to_ == RelativeTo::kTrunk) out.J.bottomRows<3>().middleCols<3>(3) -= dyn.R_WB;
  }
}

}  // namespace zmpwalk
