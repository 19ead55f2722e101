#include "src/model/scene.h"

#include "src/model/command_fields.h"

namespace tumble::sim {

const char* name_of(const Command& command) { return kCommandNames[command.index()]; }

}  // namespace tumble::sim
