#pragma once

#include <string>
#include <string_view>

/// JSON that says of itself whether it is whole.
namespace tumble::golden {

/// The text of a JSON object as `dump(1)` writes it, with one key more at its end: "hash", of all text before that key.
std::string sealed(std::string object);

/// What is wrong with a text that sealed() wrote; empty: nothing.
std::string fault_of_seal(std::string_view text);

}  // namespace tumble::golden
