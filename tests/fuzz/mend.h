#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Logs with their messages laid open, so that whoever changes bytes reaches what lies behind compression and hashes.
namespace tumble::fuzz {

using Bytes = std::vector<std::byte>;

/// Each record of a log as its prelude and its message without compression; the footer is left off.
Bytes laid_open(std::span<const std::byte> log);

/// A log again from any bytes of that form: messages compressed, lengths, hashes, tags and, where a chunk can be
/// decoded, chains as they would be written. The other numbers of the preludes stay as they are.
Bytes mended(std::span<const std::byte> open);

}  // namespace tumble::fuzz
