#pragma once

#include <memory>

// MuJoCo's structs by name alone: a header that only passes them on need not include MuJoCo.
struct mjModel_;
struct mjData_;
typedef struct mjModel_ mjModel;
typedef struct mjData_ mjData;

namespace zmpwalk {

struct MjDataDeleter {
  void operator()(mjData* d) const;
};
using MjDataPtr = std::unique_ptr<mjData, MjDataDeleter>;

}  // namespace zmpwalk
