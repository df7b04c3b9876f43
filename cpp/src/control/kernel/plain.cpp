#include "zmpwalk/control/kernel.hpp"

#define ZMPWALK_KERNEL kernel_plain
#ifdef __x86_64__
#define ZMPWALK_KERNEL_NAME "x86-64"
#else
#define ZMPWALK_KERNEL_NAME "generic"
#endif
#include "loops.hpp"
