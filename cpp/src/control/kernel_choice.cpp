#include "zmpwalk/control/kernel_choice.hpp"

#ifdef __x86_64__
#include <cpuid.h>
#endif

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

extern const Kernel kernel_plain;
#ifdef __x86_64__
extern const Kernel kernel_v3, kernel_v4;

namespace {

/// Which vector units processor and operating system give. The processor is asked itself, because __builtin_cpu_supports answers no to everything
/// in what zig links.
struct VectorUnits {
  bool v3 = false, v4 = false;

  VectorUnits() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (!__get_cpuid(1, &a, &b, &c, &d)) return;
    constexpr unsigned kFma = 1u << 12, kXgetbv = 1u << 27, kAvx = 1u << 28;
    if (!has(c, kFma | kXgetbv | kAvx) || !__get_cpuid_count(7, 0, &a, &b, &c, &d)) return;
    constexpr unsigned kAvx2 = 1u << 5, kF = 1u << 16, kDq = 1u << 17, kCd = 1u << 28, kBw = 1u << 30, kVl = 1u << 31;
    unsigned saved = 0, high = 0;  // the registers that the operating system saves
    __asm__("xgetbv" : "=a"(saved), "=d"(high) : "c"(0));
    constexpr unsigned kYmm = 0x6, kZmm = 0xe6;
    v3 = has(b, kAvx2) && has(saved, kYmm);
    v4 = v3 && has(b, kF | kDq | kCd | kBw | kVl) && has(saved, kZmm);
  }

  static bool has(unsigned word, unsigned bits) { return (word & bits) == bits; }
};

}  // namespace
#endif

const std::vector<const Kernel*>& kernels() {
  static const std::vector<const Kernel*> all = [] {
    std::vector<const Kernel*> found{&kernel_plain};
#ifdef __x86_64__
    const VectorUnits units;
    if (units.v3) found.push_back(&kernel_v3);
    if (units.v4) found.push_back(&kernel_v4);
#endif
    return found;
  }();
  return all;
}

const Kernel& kernel(const std::string& name) {
  if (name == "auto") return *kernels().back();
  std::string known = "auto";
  for (const Kernel* k : kernels()) {
    if (name == k->name) return *k;
    known += std::string(", ") + k->name;
  }
  throw InputError("kernel = '" + name + "' is not one that this processor runs; there are: " + known);
}

}  // namespace zmpwalk
