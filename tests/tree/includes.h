#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/source_tree.h"

namespace tumble::test {

/// One line `#include "..."` of the tree's code.
struct Include {
  std::string from;     ///< the file with the line
  std::string spelled;  ///< as it stands there
  std::string file;     ///< the file that is meant, from the repository root
  std::size_t line = 0;
};

/// The rows of cmake/public_headers.txt: the file of each spelling ("tumble/sim/step.h" to "src/step/step.h").
const std::map<std::string, std::string>& public_headers();

/// All includes of some files, in order; spellings of public headers are resolved.
std::vector<Include> includes_of(const std::vector<SourceFile>& files);

/// The circles between units, a header and its source being one unit: one text for each group of units that include
/// one another, with the shortest way round: "a.h includes b.h, b.cc includes a.h".
std::vector<std::string> circles(const std::vector<Include>& includes);

}  // namespace tumble::test
