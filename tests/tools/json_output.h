#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {

/// The one JSON value that a command printed; fails the test if it printed something else.
inline nlohmann::ordered_json parsed(const Outcome& outcome) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << "not JSON: " << outcome.out;
  return json;
}

/// The keys of an object, in their order.
inline std::vector<std::string> keys_of(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

}  // namespace tumble::test
