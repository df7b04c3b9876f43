#include "zmpwalk/robot/mujoco.hpp"

#include <dlfcn.h>

#include "zmpwalk/math/error.hpp"

namespace zmpwalk {
namespace {

void* open(const std::string& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw Error(file + " cannot be loaded: " + dlerror());
  return library;
}

}  // namespace

void connect(AdapterEntry entry, void* library) {
  if (mj::adapter) return;
  const char* missing = nullptr;
  const auto find = [](void* in, const char* name) { return dlsym(in, name); };
  const zmpwalk_adapter* adapter = entry(find, library, &missing);
  if (!adapter) throw Error("this libmujoco has no " + std::string(missing) + ", which zmpwalk needs");
  if (adapter->interface != ZMPWALK_ADAPTER_INTERFACE)
    throw Error("the adapter to MuJoCo has interface " + std::to_string(adapter->interface) + ", this zmpwalk needs " +
                std::to_string(ZMPWALK_ADAPTER_INTERFACE));
  mj::adapter = adapter;
}

void connect(const std::string& adapter, const std::string& libmujoco) {
  if (mj::adapter) return;
  void* library = open(libmujoco);
  const auto entry = reinterpret_cast<AdapterEntry>(dlsym(open(adapter), "zmpwalk_adapter_of"));
  if (!entry) throw Error(adapter + " is no adapter of zmpwalk");
  connect(entry, library);
}

const zmpwalk_adapter& mj::connected() {
  if (!adapter) throw Error("zmpwalk is not connected with MuJoCo: call zmpwalk::connect first");
  return *adapter;
}

OwnData::OwnData(const Model& m)
    : Data(mj::connected().make_data(m.handle)), owned_(handle, mj::connected().delete_data) {
  if (!handle) throw ModelError("MuJoCo could not make an mjData for this model");
}

}  // namespace zmpwalk
