#pragma once

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <kj/exception.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "replay/codec/zstd_frame.h"
#include "replay/format/limits.h"
#include "replay/format/little_endian.h"
#include "tumble/sim/result.h"

/// Converts Cap'n Proto messages to bytes and back, and its exceptions to Errors. Included by codecs only.
namespace tumble::replay {

/// Builds a message where its flat form will lie: behind the word that says how long the one segment is. A message
/// that is longer than expected goes on in further segments.
class FlatBuilder : public capnp::MessageBuilder {
 public:
  /// memory: of more than one word; all zero behind the first, as Cap'n Proto wants it. Must outlive the builder.
  explicit FlatBuilder(std::span<std::byte> memory)
      : memory_(memory), words_(memory.size() / sizeof(capnp::word) - 1) {}
  ~FlatBuilder() noexcept(false) override = default;

  kj::ArrayPtr<capnp::word> allocateSegment(capnp::uint minimum_words) override {
    if (!begun_ && minimum_words <= words_) {
      begun_ = true;
      return kj::arrayPtr(reinterpret_cast<capnp::word*>(memory_.data()) + 1, words_);
    }
    begun_ = true;
    const std::size_t words = std::max<std::size_t>(minimum_words, words_);
    words_ += words;
    more_.push_back(std::make_unique<std::uint64_t[]>(words));  // zeros
    return kj::arrayPtr(reinterpret_cast<capnp::word*>(more_.back().get()), words);
  }

  /// Bytes of the flat message in the memory, its first word included; 0 where one segment was not enough.
  std::size_t finish() {
    const auto segments = getSegmentsForOutput();
    if (!more_.empty() || segments.size() != 1) return 0;
    store(memory_.data(), std::uint64_t{segments[0].size()} << 32U);  // the number of segments less one, and the length
    return (segments[0].size() + 1) * sizeof(capnp::word);
  }

 private:
  std::span<std::byte> memory_;
  std::size_t words_;  // of all segments so far, which is what the next one gets
  bool begun_ = false;
  std::vector<std::unique_ptr<std::uint64_t[]>> more_;
};

/// Encodes one message in the flat form of Cap'n Proto. spare: memory to use again. Errors (kCannotFinish): out of
/// memory.
template <class Root, class Fill>
Result<MessageBytes> write_message(std::size_t first_segment_bytes, Fill fill, MessageBytes spare = {}) {
  try {
    MessageBytes flat((first_segment_bytes / sizeof(capnp::word) + 1025) * sizeof(capnp::word), std::move(spare));
    std::ranges::fill(flat.bytes(), std::byte{0});
    FlatBuilder builder(flat.bytes());
    fill(builder.initRoot<Root>());
    if (const std::size_t bytes = builder.finish(); bytes > 0) {
      flat.shorten(bytes);
      return flat;
    }
    const auto segments = builder.getSegmentsForOutput();
    MessageBytes message(capnp::computeSerializedSizeInWords(segments) * sizeof(capnp::word));
    kj::ArrayOutputStream stream(
        kj::arrayPtr(reinterpret_cast<kj::byte*>(message.bytes().data()), message.bytes().size()));
    capnp::writeMessage(stream, segments);
    return message;
  } catch (const kj::Exception& error) {
    return cannot_finish(std::string("cannot make a message: ") + error.getDescription().cStr());
  } catch (const std::exception& error) {
    return cannot_finish(std::string("cannot make a message: ") + error.what());
  }
}

/// Calls `read` with the root of a message and returns the Result of `read`. Cap'n Proto checks bounds when a field is
/// read, and throws. The traversal limit is the size of the message, so that no cycle of pointers and no shared list
/// can multiply the work. Each call of a pointer getter counts towards the limit, so codecs call each getter once.
template <class Root, class Read>
auto read_message(const MessageBytes& message, Read read) -> decltype(read(std::declval<typename Root::Reader>())) {
  try {
    capnp::ReaderOptions options;
    options.traversalLimitInWords = message.bytes().size() / sizeof(capnp::word) + 64;
    options.nestingLimit = kNestingMax;
    const auto* words = reinterpret_cast<const capnp::word*>(message.bytes().data());
    capnp::FlatArrayMessageReader reader(kj::arrayPtr(words, message.bytes().size() / sizeof(capnp::word)), options);
    return read(reader.getRoot<Root>());
  } catch (const kj::Exception& error) {
    return damaged(std::string("the message cannot be read: ") + error.getDescription().cStr());
  } catch (const std::bad_alloc&) {
    return cannot_finish("out of memory for a message of " + std::to_string(message.bytes().size()) + " bytes");
  } catch (const std::exception& error) {
    return damaged(std::string("the message cannot be read: ") + error.what());
  }
}

}  // namespace tumble::replay
