#include "common.hpp"

PYBIND11_MODULE(_core, m) {
  m.doc() = "zmpwalk's C++ core: contact-consistent control, ZMP estimate, gait, and the walking loop.";
  bind_errors(m);
  bind_mujoco(m);
  bind_settings(m);
  bind_velocity_profile(m);
  bind_description(m);
  bind_dynamics(m);
  bind_joint_motion(m);
  bind_contact_space(m);
  bind_task_space(m);
  bind_plane(m);
  bind_tasks(m);
  bind_whole_body(m);
  bind_estimate(m);
  bind_reference_iteration(m);
  bind_pendulum(m);
  bind_velocity_tracker(m);
  bind_gait_generator(m);
  bind_state(m);
  bind_walking_controller(m);
  bind_simulation(m);
  bind_kernel(m);
  bind_benchmark(m);
}
