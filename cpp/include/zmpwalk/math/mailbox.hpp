#pragma once

#include <array>
#include <atomic>
#include <mutex>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// Hands three numbers from any thread to one reader, who gets the newest and neither waits nor locks (a sequence lock).
class Mailbox {
 public:
  /// Puts `value` in place of what was there. Writers wait for each other.
  void put(const Vec3& value) {
    const std::lock_guard<std::mutex> one_writer(writing_);
    const unsigned n = sequence_.load(std::memory_order_relaxed);
    sequence_.store(n + 1, std::memory_order_relaxed);  // odd: being written
    // Released and acquired, a number that the reader sees brings along that it was being written. Fences would do as well, but no thread sanitizer
    // knows them.
    for (int i = 0; i < 3; ++i) value_[i].store(value[i], std::memory_order_release);
    sequence_.store(n + 2, std::memory_order_release);
  }

  /// Writes a new value into `out`. Returns false where there is none, or while a writer is at work; then the next call gets it.
  bool take(Vec3& out) {
    const unsigned n = sequence_.load(std::memory_order_acquire);
    if (n == taken_ || n % 2 == 1) return false;
    const Vec3 value(value_[0].load(std::memory_order_acquire), value_[1].load(std::memory_order_acquire),
                     value_[2].load(std::memory_order_acquire));
    if (sequence_.load(std::memory_order_relaxed) != n) return false;
    out = value;
    taken_ = n;
    return true;
  }

  /// Forgets a value that was not taken.
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
