#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "golden/hunt/corpus.h"
#include "golden/hunt/folder.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// One finding, a line or two.
void print_finding(const hunt::Finding& finding);

/// The table of relations and the findings in groups. folder: names files; empty: nothing was kept.
/// count: of the scenes of all shards; none: the time ends the hunt.
void print_hunt(const hunt::HuntState& state, const std::string& folder, std::optional<std::uint64_t> count);

/// The judged scenes of a folder.
void print_corpus(const hunt::CorpusResult& result);

void print_relations();
Json relations_json();

}  // namespace tumble::tools
