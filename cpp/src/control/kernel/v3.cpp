#include "zmpwalk/control/kernel.hpp"

#ifdef __x86_64__
#define ZMPWALK_KERNEL kernel_v3
#define ZMPWALK_KERNEL_NAME "x86-64-v3"
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif
#include "loops.hpp"
#ifdef __clang__
#pragma clang attribute pop
#endif
#endif
