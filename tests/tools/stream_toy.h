#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {

/// The command line of the engine that writes through the recorder, as a tumble.toml has it.
inline const std::string kFalling = TUMBLE_STREAM_ENGINE " --log {log} --inputs {inputs}";

inline void write_falling(const Workshop& shop, const std::string& options = "", const std::string& more = "") {
  shop.write("tumble.toml", "[engine]\nrun = '" + kFalling + ' ' + options + "'\n" + more);
}

/// A session of that engine as the log NAME.tumble.
inline void record_falling(const Workshop& shop, const std::string& name, const std::string& options = "") {
  const std::string file = name + (options.find("--table") == std::string::npos ? ".tumblestream" : ".csv");
  const std::string line = "'" TUMBLE_STREAM_ENGINE "' --log '" + shop.path(file) + "' " + options;
  ASSERT_EQ(std::system(line.c_str()), 0) << line;
  const Outcome imported = shop.run({"import", file});
  ASSERT_EQ(imported.exit, 0) << imported.err;
}

}  // namespace tumble::test
