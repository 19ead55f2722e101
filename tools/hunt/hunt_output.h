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
void print_hunt(const hunt::HuntState& state, const std::string& folder);

/// "nothing was judged: …", and why. count: of the scenes of all shards; none: the time ends the hunt. Precondition:
/// nothing_judged().
std::string nothing_judged_text(const hunt::HuntState& state, std::optional<std::uint64_t> count);
std::string nothing_judged_text(const hunt::CorpusResult& result);

/// The judged scenes of a folder.
void print_corpus(const hunt::CorpusResult& result);

void print_relations();
Json relations_json();

}  // namespace tumble::tools
