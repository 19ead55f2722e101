#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tumble/replay/byte_io.h"
#include "tumble/sim/result.h"

/// The tail of a recorder's stream: a file of fixed size beside it, "PATH.tail", which holds the frames that the
/// stream's file lacks yet. Where a recorder was killed, the two together are the stream: docs/recorder_stream.md.
namespace tumble::replay {

inline constexpr std::array<unsigned char, 16> kStreamTailMagic = {0x89, 't', 'u', 'm', 'b', 'l',  'e',  't',
                                                                   'a',  'i', 'l', 0,   0,   '\r', '\n', 0x1a};
inline constexpr const char* kStreamTailSuffix = ".tail";
inline constexpr std::size_t kStreamTailHeadBytes = 40;        ///< magic, tag, number and hash of the frame before
inline constexpr std::size_t kStreamTailBytesMax = 64U << 20;  ///< that a reader looks at; a recorder makes 1 MiB

/// A stream's bytes with those frames of `tail` behind its last whole frame that follow it in number and have right
/// hashes. Only `stream` where it is finished, or where `tail` is of another stream, is none, or has nothing new.
/// Errors: of reading `stream`.
Result<std::unique_ptr<ByteSource>> with_tail(std::unique_ptr<ByteSource> stream, const std::vector<std::byte>& tail);

/// Whether the file beside a stream's that has the name of its tail is one, and of this stream: frames that a file of
/// another session holds are passed over. False where a file cannot be read.
bool has_own_tail(const std::string& path);

/// Opens a stream's file together with its tail, if it has one. Errors: as open_file_source().
Result<std::unique_ptr<ByteSource>> open_stream_source(const std::string& path);

}  // namespace tumble::replay
