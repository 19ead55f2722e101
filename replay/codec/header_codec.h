#pragma once

#include "replay/codec/zstd_frame.h"
#include "replay/format/step_record.h"
#include "src/base/result.h"

namespace tumble::replay {

/// The header record's message. Decoding leaves the format version to the caller, who knows the prelude.
Result<MessageBytes> encode_header(const LogHeader& header);
Result<LogHeader> decode_header(const MessageBytes& message);

}  // namespace tumble::replay
