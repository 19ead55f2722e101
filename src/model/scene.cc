#include "src/model/scene.h"

namespace tumble::sim {

const char* name_of(const Command& command) {
  struct Names {
    const char* operator()(const Throw&) const { return "throw"; }
    const char* operator()(const Push&) const { return "push"; }
    const char* operator()(const Remove&) const { return "remove"; }
    const char* operator()(const Wake&) const { return "wake"; }
    const char* operator()(const SetVelocity&) const { return "set_velocity"; }
    const char* operator()(const SetGravity&) const { return "set_gravity"; }
    const char* operator()(const SetDt&) const { return "set_dt"; }
  };
  return std::visit(Names{}, command);
}

}  // namespace tumble::sim
