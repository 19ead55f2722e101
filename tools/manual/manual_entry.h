#pragma once

#include <string>
#include <vector>

#include "tools/arguments/arguments.h"

namespace tumble::tools {

/// One command as it declares itself: the source of its help, its manual page and its completion.
struct ManualEntry {
  std::string name;  ///< "record"
  std::string summary;
  std::vector<ArgumentText> arguments;  ///< in the order of help, -h first
  std::string footer;                   ///< examples and exit statuses, as help prints them
};

}  // namespace tumble::tools
