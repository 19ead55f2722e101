#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "replay/arrays/npy.h"
#include "tumble/sim/result.h"

/// Reads archives of arrays as numpy.savez() and savez_compressed() write them: zip (PKWARE's APPNOTE.TXT).
namespace tumble::replay {

/// All arrays of an archive. `bytes` is the whole file; name: for messages. Checks each array's CRC. Errors
/// (kBadInput): not a zip archive, one that is encrypted, spans volumes or needs a method other than stored and
/// deflate; sizes that do not fit the file; an array of objects or structs.
Result<std::vector<Array>> read_npz(std::string_view bytes, const std::string& name);

}  // namespace tumble::replay
