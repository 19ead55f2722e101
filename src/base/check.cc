#include "src/base/check.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "src/base/text.h"

namespace tumble::base {
namespace {

constexpr int kExitStatus = 4;  // the command line's "could not finish"

// From the repository's root on, wherever the tree was built.
std::string_view from_root(std::string_view file) {
  for (std::string_view folder : {"/src/", "/replay/", "/golden/", "/tools/", "/tests/", "/bench/"}) {
    if (const auto at = file.rfind(folder); at != std::string_view::npos) return file.substr(at + 1);
  }
  return file;
}

std::string value_text(const CheckValue& value) {
  switch (value.kind) {
    case CheckValue::Kind::kSigned:
      return std::to_string(value.whole);
    case CheckValue::Kind::kUnsigned:
      return std::to_string(value.natural);
    case CheckValue::Kind::kReal:
      return exact(value.real);
    case CheckValue::Kind::kText:
      break;
  }
  return in_quotes(value.text);
}

}  // namespace

void check_failed(const char* file, int line, const char* condition, const char* names,
                  std::initializer_list<CheckValue> values) {
  std::string message =
      std::string(from_root(file)) + ':' + std::to_string(line) + ": internal check failed: " + condition;
  const char* before = "; found ";
  if (values.size() > 0) message += std::string(before) + names + " = ";
  for (const CheckValue& value : values) message += (&value == values.begin() ? "" : ", ") + value_text(value);
  std::fprintf(stderr, "tumble: %s\n", message.c_str());
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  std::abort();  // libFuzzer keeps the input of a process that aborts
#else
  std::_Exit(kExitStatus);
#endif
}

}  // namespace tumble::base
