#pragma once

#include <cstdint>

/// Every count, length and size that a log states is checked against one of these, or against another field that was,
/// before memory is set aside for it. Raise one freely: older files stay readable.
namespace tumble::replay {

// Sizes of stored and decoded parts.
inline constexpr std::uint64_t kChunkBytesMax = 1ULL << 30;  ///< any decoded message
/// zstd cannot pack more than a block of 128 KiB into 4 bytes, so a frame that claims more lies.
inline constexpr std::uint64_t kZstdExpansionMax = 32768;
inline constexpr std::uint64_t kEasyBytes = 10 << 20;     ///< a chunk or an index up to this may come from few bytes
inline constexpr std::uint64_t kLargeExpansionMax = 256;  ///< a larger one is at most so many times as long
/// zstd's smallest window: blocks of 1 KiB, at least 4 bytes each, so that nothing packs better than
/// kLargeExpansionMax.
inline constexpr int kNarrowWindowLog = 10;
inline constexpr std::uint64_t kHeaderEasyBytes = 4 << 20;  ///< a header up to this may come from few bytes
inline constexpr std::uint64_t kHeaderExpansionMax = 64;    ///< a larger one: no two boxes or inputs are alike
inline constexpr std::uint64_t kOverridesMax = 1 << 16;     ///< texts of a header, a few bytes each
inline constexpr std::uint64_t kBoxBytesMin = 192;   ///< of a message for each box of its scene: lists may claim more
inline constexpr std::uint64_t kInputBytesMin = 48;  ///< likewise for each input

// A chunk, as the writer closes it. Frozen bodies cost next to nothing, so quiet chunks may be longer, which spreads
// the cost of the keyframe; both limits bound the time to reach a step inside a chunk.
inline constexpr std::uint64_t kChunkStepsMax = 256;         ///< steps
inline constexpr std::uint64_t kChunkBusySteps = 64;         ///< steps, if all bodies move in each
inline constexpr std::uint64_t kChunkStateBytes = 32 << 20;  ///< states of a chunk in memory, kBodyStateBytes each
inline constexpr std::uint64_t kBodyStateBytes = 113;        ///< id, 13 doubles, a flag

// A chunk, as the reader accepts it.
inline constexpr std::uint64_t kStepsPerChunkRead = 1 << 16;
/// Body-steps a chunk may decode to beyond its first step.
inline constexpr std::uint64_t kBodyStepsRead = 4 * kChunkStateBytes / kBodyStateBytes;
inline constexpr std::uint64_t kPhaseWordsMax = 1 << 16;  ///< of one step
inline constexpr std::uint64_t kPhasesMax = 256;
inline constexpr std::uint64_t kPairsMax = 1ULL << 28;
inline constexpr std::uint64_t kChunksMax = 1 << 22;
inline constexpr std::uint64_t kRowMovesMax = 1ULL << 32;    ///< rows moved by the throws and removes of a chunk
inline constexpr std::uint64_t kSalvageWork = 8;             ///< times a damaged file's size that its recovery may read
inline constexpr std::uint64_t kScrapBytesMax = 1ULL << 28;  ///< of damaged bytes searched for frames in one piece

// What a message of so many bytes in the file may decompress to, so that a small file cannot fill the memory: what
// takes 10 MiB as a message takes less than 256 MB in a program that steps it (tests/trial/hostile_memory.cc).
constexpr std::uint64_t expanded_max(std::uint64_t bytes, std::uint64_t times, std::uint64_t easy) {
  const std::uint64_t packed = bytes < kChunkBytesMax ? bytes * times : kChunkBytesMax;
  const std::uint64_t larger = easy > packed ? easy : packed;
  return larger < kChunkBytesMax ? larger : kChunkBytesMax;
}

/// A header: a real one packs to a thirtieth at best, because ids and places differ.
constexpr std::uint64_t header_bytes_max(std::uint64_t stored_bytes) {
  return expanded_max(stored_bytes, kHeaderExpansionMax, kHeaderEasyBytes);
}

/// A chunk or an index whose record ends at a byte of the file. What is before counts too: bodies that stand in rows
/// pack to almost nothing, but each was told of before, in the header or in the input that threw it. RecordWriter packs
/// worse what would be refused.
constexpr std::uint64_t message_bytes_max(std::uint64_t end_byte) {
  return expanded_max(end_byte, kLargeExpansionMax, kEasyBytes);
}

inline constexpr int kNestingMax = 16;  ///< of Cap'n Proto pointers; the schema needs 6

}  // namespace tumble::replay
