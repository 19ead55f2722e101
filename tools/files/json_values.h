#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tools/output/text.h"

/// Values of JSON that another program, or another version of this one, wrote: whatever stands there, nothing is
/// thrown.
namespace tumble::tools {

/// The member of an object; null where there is none, or `json` is no object.
inline Json member(const Json& json, const char* key) { return json.is_object() ? json.value(key, Json()) : Json(); }

inline std::string text_in(const Json& json, const char* key, const std::string& otherwise = {}) {
  const Json value = member(json, key);
  return value.is_string() ? value.get<std::string>() : otherwise;
}

inline bool flag_in(const Json& json, const char* key) {
  const Json value = member(json, key);
  return value.is_boolean() && value.get<bool>();
}

}  // namespace tumble::tools
