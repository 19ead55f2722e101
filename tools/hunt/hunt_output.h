#pragma once

#include <string>

#include "golden/hunt/corpus.h"
#include "golden/hunt/folder.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// One finding, a line or two.
void print_finding(const hunt::Finding& finding);

/// The table of relations and the findings in groups. folder: names files; empty: nothing was kept.
void print_hunt(const hunt::HuntState& state, const std::string& folder);

/// The judged scenes of a folder.
void print_corpus(const hunt::CorpusResult& result);

void print_relations();
Json relations_json();

}  // namespace tumble::tools
