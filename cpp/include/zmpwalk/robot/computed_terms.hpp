#pragma once

#include <vector>

#include "zmpwalk/math/types.hpp"
#include "zmpwalk/robot/mujoco.hpp"

namespace zmpwalk {

/// Tells whether the terms that `mj_step1` leaves in the data belong to the positions and velocities that stand there.
///
/// The base is compared with its body's pose and velocity. A joint is compared with the length and the speed of a motor that moves it; where it has
/// none, its body's velocity is compared with that of the body above it and what the joint adds.
class ComputedTerms {
 public:
  ComputedTerms(const Model& m, int root_body);

  /// @throws InputError  somebody has changed qpos or qvel since. Allocates nothing otherwise.
  void require(const Data& d) const;

 private:
  /// Motors that follow each other in the data as the joints do that they move.
  struct Motors {
    int actuator, qpos, dof, count;
    VecX gear;         // (count,)
    double tolerance;  // of a length or a speed
  };
  bool base_moved(const Data& d) const;
  bool base_sped(const Data& d) const;
  bool is_of_qvel(const Data& d, int body) const;

  Model m_;
  int root_body_, qpos0_, dof0_;
  std::vector<Motors> motors_;
  std::vector<int> unmotored_;  // bodies with a joint that no motor moves
};

}  // namespace zmpwalk
