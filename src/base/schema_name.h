#pragma once

#include <string>
#include <string_view>

namespace tumble {

/// The name of the JSON Schema of what a command prints with --json: the $id of schema/json/COMMAND.schema.json. The
/// number in it is the schema's version, which moves where a member goes away or changes its meaning.
inline std::string schema_name(std::string_view command) { return "urn:tumble:json:1:" + std::string(command); }

}  // namespace tumble
