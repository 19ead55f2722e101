#pragma once

#include "schema/log.capnp.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/result.h"

/// Names and shapes of bodies, as structs of the schema and back. Included by codecs only. Errors (kDamaged):
/// a value that no writer produces; a shape that its hash does not name.
namespace tumble::replay {

void encode(const Shape& shape, schema::Shape::Builder out);
Result<Shape> decode(schema::Shape::Reader in);

void encode(const BodyInfo& info, schema::BodyInfo::Builder out);
Result<BodyInfo> decode(schema::BodyInfo::Reader in);

}  // namespace tumble::replay
