#pragma once

#include <string>
#include <vector>

namespace tumble::replay {

/// The finite numbers of "0 0 -9.81", with spaces or commas between; empty for any other text.
std::vector<double> numbers_of(const std::string& text);

}  // namespace tumble::replay
