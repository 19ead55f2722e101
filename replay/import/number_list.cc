#include "replay/import/number_list.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace tumble::replay {

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  while (at != end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    at = stop;
  }
  return numbers;
}

}  // namespace tumble::replay
