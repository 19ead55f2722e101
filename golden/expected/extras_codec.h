#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "schema/golden.capnp.h"
#include "tumble/golden/expected_extras.h"
#include "tumble/golden/expected_setup.h"
#include "tumble/sim/result.h"

/// Channels and contacts in the message of a golden. Included by codecs only.
namespace tumble::golden {

void encode(const ExpectedExtras& extras, schema::Expected::Builder out);

/// steps: of the session. extras: none where the golden keeps none. Errors (kDamaged): sizes that do not fit, steps out
/// of order, names that no log can have.
Status decode(schema::Expected::Reader in, std::uint64_t steps, std::optional<ExpectedExtras>& extras);

void encode(const std::vector<BodyShape>& shapes, schema::Expected::Builder out);

/// shapes: none where the golden keeps none. Errors (kDamaged): ids out of order.
Status decode(schema::Expected::Reader in, std::optional<std::vector<BodyShape>>& shapes);

/// Likewise the setup. Errors. kBadInput: a header of a newer program. kDamaged: no header, or steps out of order.
Status encode(const ExpectedSetup& setup, schema::Expected::Builder out);
Status decode(schema::Expected::Reader in, std::optional<ExpectedSetup>& setup);

}  // namespace tumble::golden
