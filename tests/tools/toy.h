#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"

namespace tumble::test {

/// The command line of the toy engine as a tumble.toml has it.
inline const std::string kToy = TUMBLE_TOY_ENGINE " --log {log} --inputs {inputs}";

/// A session of the toy engine as NAME, in which a body is pushed before step 10.
inline void record_toy(const Workshop& shop, const std::string& name, const std::string& options = "") {
  const std::string line = "'" TUMBLE_TOY_ENGINE "' --log '" + shop.path(name) + "' --push 10:2:3 " + options;
  ASSERT_EQ(std::system(line.c_str()), 0);
}

}  // namespace tumble::test
