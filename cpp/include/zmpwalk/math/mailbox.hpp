#pragma once

#include <array>
#include <atomic>
#include <mutex>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// The newest of three numbers, from any thread to one reader that neither waits nor locks (a sequence lock).
class Mailbox {
 public:
  /// Puts `value` in place of what was there. Writers wait for each other.
  void put(const Vec3& value) {
    const std::lock_guard<std::mutex> one_writer(writing_);
    const unsigned n = sequence_.load(std::memory_order_relaxed);
    sequence_.store(n + 1, std::memory_order_relaxed);  // odd: being written
    std::atomic_thread_fence(std::memory_order_release);
    for (int i = 0; i < 3; ++i) value_[i].store(value[i], std::memory_order_relaxed);
    sequence_.store(n + 2, std::memory_order_release);
  }

  /// Takes what is new. False where nothing is, or where a writer is at it: then it comes with the next call.
  bool take(Vec3& out) {
    const unsigned n = sequence_.load(std::memory_order_acquire);
    if (n == taken_ || n % 2 == 1) return false;
    const Vec3 value(value_[0].load(std::memory_order_relaxed), value_[1].load(std::memory_order_relaxed),
                     value_[2].load(std::memory_order_relaxed));
    std::atomic_thread_fence(std::memory_order_acquire);
    if (sequence_.load(std::memory_order_relaxed) != n) return false;
    out = value;
    taken_ = n;
    return true;
  }

  /// Forgets what was not taken.
  void clear() {
    Vec3 stale;
    take(stale);
  }

 private:
  std::mutex writing_;
  std::atomic<unsigned> sequence_{0};
  std::array<std::atomic<double>, 3> value_{};
  unsigned taken_ = 0;  // of the reader
};

}  // namespace zmpwalk
