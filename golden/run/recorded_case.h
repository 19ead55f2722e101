#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tumble/golden/case_result.h"
#include "tumble/golden/provenance.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {

/// A case's session that another machine ran, as the report of its check holds it.
struct RecordedCase {
  std::filesystem::path folder;         ///< with actual.tumble and the pictures that moved
  Hash128 continuation;                 ///< of the last state; zero where it is not known
  std::string final_hash;               ///< of the last state, in hexadecimal digits
  std::vector<PictureResult> pictures;  ///< as that check judged them
  Provenance run;                       ///< of that check; its seconds are the case's own
};
using RecordedCases = std::map<std::string, RecordedCase>;

}  // namespace tumble::golden
