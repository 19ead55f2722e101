#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// What libFuzzer, or run_corpus.cc in its place, calls with every input. 0: carry on.
/// The label is the name that libFuzzer knows.
extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) __asm__("LLVMFuzzerTestOneInput");

namespace tumble::fuzz {

inline std::span<const std::byte> as_bytes(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

}  // namespace tumble::fuzz
