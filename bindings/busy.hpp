#pragma once

#include "common.hpp"
#include "zmpwalk/walk/walking_controller.hpp"

/// Marks a controller as walking while this lives. Everybody holds the interpreter's lock who makes, asks or ends one.
class Busy {
 public:
  /// @throws InputError  the controller walks already, `what` cannot be done meanwhile
  Busy(const zmpwalk::WalkingController& controller, const char* what);
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

  /// While this lives, a callback of the walk runs on this thread, between two cycles: it may add tasks and motions.
  class Pause {
   public:
    explicit Pause(const zmpwalk::WalkingController& controller);
    ~Pause();
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

   private:
    const zmpwalk::WalkingController* controller_;
  };

 private:
  const zmpwalk::WalkingController* controller_;
};

/// @throws InputError  the controller walks, and this is not called between two cycles by the thread that walks it
void require_between_cycles(const zmpwalk::WalkingController& controller, const char* what);
