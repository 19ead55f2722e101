#pragma once

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <kj/exception.h>

#include <exception>
#include <span>
#include <string>

#include "replay/codec/zstd_frame.h"
#include "replay/format/limits.h"
#include "tumble/sim/result.h"

/// Converts Cap'n Proto messages to bytes and back, and its exceptions to Errors. Included by codecs only.
namespace tumble::replay {

/// Encodes one message in the flat form of Cap'n Proto. Errors (kCannotFinish): out of memory.
template <class Root, class Fill>
Result<MessageBytes> write_message(std::size_t first_segment_bytes, Fill fill) {
  try {
    capnp::MallocMessageBuilder builder(static_cast<unsigned>(first_segment_bytes / sizeof(capnp::word) + 1024));
    fill(builder.initRoot<Root>());
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
