#include "golden/bundle/sealed_text.h"

#include <cstddef>
#include <span>

#include "src/base/check.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

constexpr const char* kHashKey = ",\n \"hash\": \"";
constexpr const char* kEnd = "\"\n}\n";
constexpr std::string_view kObjectEnd = "\n}";

std::string hash_text(std::string_view text) { return to_string(hash_bytes(std::as_bytes(std::span(text)))); }

}  // namespace

std::string sealed(std::string object) {
  SIM_CHECK(object.ends_with(kObjectEnd));
  object.resize(object.size() - kObjectEnd.size());
  const std::string hash = hash_text(object);
  return object + kHashKey + hash + kEnd;
}

std::string fault_of_seal(std::string_view text) {
  const std::size_t at = text.rfind(kHashKey);
  if (at == std::string_view::npos || !text.ends_with(kEnd)) return "its end is missing";
  const std::string wanted = hash_text(text.substr(0, at));
  if (text.substr(at) == kHashKey + wanted + kEnd) return "";
  return "its text has the hash " + wanted + ", which its last key is not";
}

}  // namespace tumble::golden
