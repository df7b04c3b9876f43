#include "busy.hpp"

#include <map>
#include <string>
#include <thread>

using namespace zmpwalk;

namespace {

/// Controllers that walk, and the thread in whose callback each pauses between two cycles; none while it computes.
std::map<const WalkingController*, std::thread::id>& walking() {
  static std::map<const WalkingController*, std::thread::id> all;
  return all;
}

[[noreturn]] void refuse(const char* what) {
  throw InputError(std::string(what) +
                   ": this controller is busy, a walk with it is running; wait for its end, steer it by command, or "
                   "make a controller for each walk");
}

}  // namespace

Busy::Busy(const WalkingController& controller, const char* what) : controller_(&controller) {
  if (!walking().emplace(controller_, std::thread::id()).second) refuse(what);
}

Busy::~Busy() { walking().erase(controller_); }

Busy::Pause::Pause(const WalkingController& controller) : controller_(&controller) {
  walking()[controller_] = std::this_thread::get_id();
}

Busy::Pause::~Pause() { walking()[controller_] = std::thread::id(); }

void require_between_cycles(const WalkingController& controller, const char* what) {
  const auto found = walking().find(&controller);
  if (found != walking().end() && found->second != std::this_thread::get_id()) refuse(what);
}
