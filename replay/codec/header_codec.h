#pragma once

#include "replay/codec/zstd_frame.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The message of the header record. The format version is in the prelude, so decode_header() leaves it 0.
Result<MessageBytes> encode_header(const LogHeader& header);
Result<LogHeader> decode_header(const MessageBytes& message);

}  // namespace tumble::replay
