#pragma once

#include "replay/step_record.h"

namespace tumble::replay {

/// copy_visible() past the caches, where the machine can: for states that another thread reads much later. Written as
/// usual, each line would first be fetched from where that thread read what it held before.
void stream_visible(const sim::Bodies& bodies, BodyStates& states);

}  // namespace tumble::replay
