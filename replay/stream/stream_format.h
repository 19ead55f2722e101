#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The bytes of a recorder's stream, as replay/recorder/tumble_recorder.c writes them: docs/recorder_stream.md.
namespace tumble::replay {

inline constexpr std::array<unsigned char, 16> kStreamMagic = {0x89, 't', 'u', 'm', 'b', 'l',  'e',  's',
                                                               't',  'r', 'e', 'a', 'm', '\r', '\n', 0x1a};
inline constexpr std::uint32_t kStreamMajor = 1;
inline constexpr std::size_t kStreamPreludeBytes = 24;    ///< magic, major and minor version
inline constexpr std::size_t kStreamFrameHeadBytes = 24;  ///< kind, length, number, hash

// Limits that a reader checks before it allocates.
inline constexpr std::uint64_t kStreamFrameBytesMax = 1ULL << 28;
inline constexpr std::uint64_t kStreamFramesMax = 1ULL << 28;
inline constexpr std::size_t kStreamNameBytesMax = 200;
inline constexpr std::uint32_t kStreamChannelsMax = 4096;

enum class StreamFrameKind : std::uint32_t {
  kHeader = 1,
  kStart = 2,  ///< all bodies as they are after a step: of the start, and of each part of a ring
  kStep = 3,
  kHashes = 4,  ///< a step of which only hashes were kept
  kRewind = 5,
  kSnapshot = 6,
  kEnd = 7,
};

enum class StreamRecordKind : std::uint8_t {
  kBody = 1,
  kRemove = 2,
  kPush = 3,
  kSetVelocity = 4,
  kSetGravity = 5,
  kInput = 6,
  kStates32 = 10,
  kStates64 = 11,
  kSame = 12,
  kContact = 20,
  kContact32 = 21,
  kPhase = 30,
  kNote = 40,
  kChannel = 50,
  kValue = 51,
  kMesh = 52,
};

/// The name of the snapshot by which a recorder that gives up says why: its bytes are a text, and no step follows.
inline constexpr const char* kStreamRefusedName = "tumble_recorder: refused";
inline constexpr std::size_t kStreamRefusalBytesMax = 1024;

/// The classes that a frame of hashes has a word for, in its order.
inline constexpr std::array<const char*, 5> kStreamClasses = {"inputs", "states", "contacts", "phase_hashes",
                                                              "channels"};

}  // namespace tumble::replay
