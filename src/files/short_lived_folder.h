#pragma once

#include <string>

namespace tumble::files {

/// Makes a new folder "PREFIX-PROCESS-XXXXXX", with other letters for the last six, in the folder `place`. It goes with
/// this process: remove_short_lived_folders() removes it. At most sixteen are remembered at a time; further ones stay
/// where a signal ends the process. Before, removes what processes left there under this prefix that were killed: the
/// process is gone, its folder is this user's, and no process that it forked holds the folder's lock. Empty and errno
/// where no folder can be made.
std::string make_short_lived_folder(const std::string& place, const std::string& prefix);

/// Says that a folder was removed, and gives its lock back.
void forget_short_lived_folder(const std::string& folder);

/// Removes the folders that this process remembered and did not forget, with all that is in them; none of the process
/// that forked this one. For the handler of a signal that ends the process, or its end: whoever makes
/// a folder after that waits for ever.
void remove_short_lived_folders();

}  // namespace tumble::files
