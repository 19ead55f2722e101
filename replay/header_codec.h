#pragma once

#include "replay/step_record.h"
#include "replay/zstd_frame.h"
#include "src/base/result.h"

namespace tumble::replay {

/// The header record's message. Decoding leaves the format version to the caller, who knows the prelude.
Result<MessageBytes> encode_header(const LogHeader& header);
Result<LogHeader> decode_header(const MessageBytes& message);

}  // namespace tumble::replay
