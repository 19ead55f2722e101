#include "tools/output/exit.h"

namespace tumble::tools {

Exit exit_for(const Error& error) {
  switch (error.kind) {
    case ErrorKind::kBadInput:
      return Exit::kBadInput;
    case ErrorKind::kDamaged:
      return Exit::kDamaged;
    case ErrorKind::kCannotFinish:
      return Exit::kCannotFinish;
  }
  return Exit::kCannotFinish;
}

}  // namespace tumble::tools
