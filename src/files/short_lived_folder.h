#pragma once

#include <string>

namespace tumble::files {

/// Makes a new folder, named by `pattern` with other letters for its last six, XXXXXX, and put there. It goes with this
/// process: remove_short_lived_folders() removes it. At most sixteen are remembered at a time; further ones stay where
/// a signal ends the process. False and errno where none can be made.
bool make_short_lived_folder(std::string& pattern);

/// Says that a folder was removed.
void forget_short_lived_folder(const std::string& folder);

/// Removes the folders that this process remembered and did not forget, with all that is in them; none of the process
/// that forked this one. May be called in the handler of a signal that ends the process.
void remove_short_lived_folders();

}  // namespace tumble::files
