#pragma once

#include <cstdint>

/// Limits of a log. A reader compares every count, length and size in a file with one of these limits, or with another
/// field that it has compared, before it allocates memory. Raising a limit keeps older files readable.
namespace tumble::replay {

// Sizes of stored and decoded parts.
inline constexpr std::uint64_t kChunkBytesMax = 1ULL << 30;  ///< any decoded message
/// zstd compresses a block of 128 KiB to 4 bytes at best, so a frame that claims more is damaged.
inline constexpr std::uint64_t kZstdExpansionMax = 32768;
inline constexpr std::uint64_t kEasyBytes = 10 << 20;  ///< a chunk or an index up to this size may come from few bytes
inline constexpr std::uint64_t kLargeExpansionMax = 256;  ///< for a larger one: see message_bytes_max()
/// The smallest window of zstd: blocks of 1 KiB, each stored in 4 bytes or more, so that no message exceeds
/// kLargeExpansionMax.
inline constexpr int kNarrowWindowLog = 10;
inline constexpr std::uint64_t kHeaderEasyBytes = 4 << 20;  ///< a header up to this size may come from few bytes
inline constexpr std::uint64_t kHeaderExpansionMax = 64;    ///< for a larger one: see header_bytes_max()
inline constexpr std::uint64_t kOverridesMax = 1 << 16;     ///< in a header, a few bytes each
inline constexpr std::uint64_t kTableColumnsMax = 1000;     ///< of an imported table
inline constexpr std::uint64_t kColumnNameBytesMax = 200;   ///< of such a column
inline constexpr std::uint64_t kChannelsMax = 1 << 14;
inline constexpr std::uint64_t kShapesMax = 1 << 20;
inline constexpr std::uint64_t kShapePointsMax = 1 << 22;
inline constexpr std::uint64_t kShapeTrianglesMax = 1 << 22;
inline constexpr double kShapeLengthMax = 1e9;              ///< m, of any dimension of a shape
inline constexpr std::uint64_t kExtraRowsMax = 1 << 23;     ///< values of all channels and contacts of a chunk
inline constexpr std::uint64_t kTextRowsMax = 1 << 22;      ///< values of one channel of bytes or text in a chunk
inline constexpr std::uint64_t kExtraListMax = 1 << 20;     ///< notes, snapshots, views, new bodies: each, in a chunk
inline constexpr std::uint64_t kChannelStepsMax = 1 << 18;  ///< channels times steps of a chunk
inline constexpr std::uint64_t kContactsPerStepMax = 1 << 20;
inline constexpr std::uint64_t kNoteBytesMax = 1 << 16;
inline constexpr std::uint64_t kSnapshotBytesMax = 1ULL << 28;
inline constexpr std::uint64_t kValueBytesMax = 1ULL << 28;  ///< of one value of bytes or text
inline constexpr std::uint64_t kBoxBytesMin = 192;   ///< bytes of a message per box, at least; a list may claim more
inline constexpr std::uint64_t kInputBytesMin = 48;  ///< bytes of a message per input, at least

// When the writer closes a chunk. Frozen bodies take almost no space, so chunks at rest may have more steps and need
// fewer keyframes. Both limits bound the time to reach a step inside a chunk.
inline constexpr std::uint64_t kChunkStepsMax = 256;         ///< steps
inline constexpr std::uint64_t kChunkBusySteps = 64;         ///< steps, if all bodies move in each of them
inline constexpr std::uint64_t kChunkStateBytes = 32 << 20;  ///< bytes of a chunk's states in memory
inline constexpr std::uint64_t kBodyStateBytes = 113;        ///< bytes of one body's state: id, 13 doubles, a flag

// The chunks that a reader accepts.
inline constexpr std::uint64_t kStepsPerChunkRead = 1 << 16;
/// States of single bodies that a chunk of more than one step may decode to.
inline constexpr std::uint64_t kBodyStepsRead = 4 * kChunkStateBytes / kBodyStateBytes;
inline constexpr std::uint64_t kPhaseWordsMax = 1 << 16;  ///< of one step
inline constexpr std::uint64_t kPhasesMax = 256;
inline constexpr std::uint64_t kPairsMax = 1ULL << 28;
inline constexpr std::uint64_t kChunksMax = 1 << 22;
inline constexpr std::uint64_t kRowMovesMax = 1ULL << 32;  ///< rows that the throws and removes of a chunk may move
inline constexpr std::uint64_t kSalvageWork = 8;  ///< recovery reads at most this many times the size of the file
/// The longest run of damaged bytes that recovery searches for frames.
inline constexpr std::uint64_t kScrapBytesMax = 1ULL << 28;

// The most bytes that a stored message may decompress to, so that a small file cannot fill the memory. A program that
// reads a message of 10 MiB and steps its scene needs less than 256 MB (tests/trial/hostile_memory.cc).
constexpr std::uint64_t expanded_max(std::uint64_t bytes, std::uint64_t times, std::uint64_t easy) {
  const std::uint64_t packed = bytes < kChunkBytesMax ? bytes * times : kChunkBytesMax;
  const std::uint64_t larger = easy > packed ? easy : packed;
  return larger < kChunkBytesMax ? larger : kChunkBytesMax;
}

/// The most bytes of a header message: kHeaderExpansionMax times the stored bytes, or kHeaderEasyBytes if that
/// is more. Real headers compress to a thirtieth at best, because ids and places differ.
constexpr std::uint64_t header_bytes_max(std::uint64_t stored_bytes) {
  return expanded_max(stored_bytes, kHeaderExpansionMax, kHeaderEasyBytes);
}

/// The most bytes of a chunk or index message whose record ends at byte `end_byte` of the file: kLargeExpansionMax
/// times end_byte, or kEasyBytes if that is more. All bytes before count, because bodies in regular rows compress to
/// almost nothing in a chunk, while the header or an earlier input holds each of them. RecordWriter compresses a
/// message less where it would exceed this limit.
constexpr std::uint64_t message_bytes_max(std::uint64_t end_byte) {
  return expanded_max(end_byte, kLargeExpansionMax, kEasyBytes);
}

inline constexpr int kNestingMax = 16;  ///< levels of Cap'n Proto pointers; the schema needs 6

}  // namespace tumble::replay
