#include "zmpwalk/control/kernel.hpp"

#ifdef __x86_64__
#define ZMPWALK_KERNEL kernel_v4
#define ZMPWALK_KERNEL_NAME "x86-64-v4"
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma,avx512f,avx512vl,avx512dq,avx512bw,avx512cd"))), \
                             apply_to = function)
#else
#pragma GCC target("avx2,fma,avx512f,avx512vl,avx512dq,avx512bw,avx512cd")
#endif
#include "loops.hpp"
#ifdef __clang__
#pragma clang attribute pop
#endif
#endif
