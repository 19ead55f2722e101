#pragma once

#include <cstdint>

/// Every count, length and size that a log states is checked against one of these, or against another field that was,
/// before memory is set aside for it. Raise one freely: older files stay readable.
namespace tumble::replay {

// Sizes of stored and decoded parts.
inline constexpr std::uint64_t kHeaderBytesMax = 1ULL << 30;  ///< decoded header: 4 million boxes of 200 bytes
inline constexpr std::uint64_t kChunkBytesMax = 1ULL << 30;   ///< decoded chunk: keyframe and columns
inline constexpr std::uint64_t kIndexBytesMax = 1ULL << 28;   ///< decoded index
/// zstd cannot pack more than a block of 128 KiB into 4 bytes, so a frame that claims more lies.
inline constexpr std::uint64_t kZstdExpansionMax = 32768;

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
inline constexpr int kNestingMax = 16;                       ///< of Cap'n Proto pointers; the schema needs 6

}  // namespace tumble::replay
