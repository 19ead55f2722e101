#pragma once

#include <string>

namespace tumble::files {

/// Creates a file beside `place` under a name of its own, "NAME.part-PID-N", which is to be renamed to `place`, and
/// locks it until it is closed. Returns its descriptor and the name in `part`; −1 and errno where there can be none.
/// Removes files of such names that processes left which were killed: the process is gone and no other holds the lock.
int open_part(const std::string& place, std::string& part);

/// Says that a part was renamed or removed: remove_parts() passes it by.
void forget_part(const std::string& part);

/// Removes this process's parts that were not forgotten. For the handler of a signal that ends the process, or its end:
/// whoever makes a part after that waits for ever.
void remove_parts();

}  // namespace tumble::files
