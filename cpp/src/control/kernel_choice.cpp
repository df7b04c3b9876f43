#include "zmpwalk/control/kernel_choice.hpp"

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {

extern const Kernel kernel_plain;
#ifdef __x86_64__
extern const Kernel kernel_v3, kernel_v4;
#endif

const std::vector<const Kernel*>& kernels() {
  static const std::vector<const Kernel*> all = [] {
    std::vector<const Kernel*> found{&kernel_plain};
#ifdef __x86_64__
    // Asks the processor and the operating system for just what the builds were given.
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
      found.push_back(&kernel_v3);
      if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
          __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
          __builtin_cpu_supports("avx512cd"))
        found.push_back(&kernel_v4);
    }
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
