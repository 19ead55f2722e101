#pragma once

#include <string>

#include "golden/hunt/folder.h"
#include "tools/output/text.h"

namespace tumble::tools {

/// One finding, a line or two.
void print_finding(const hunt::Finding& finding);

/// The table of relations and the findings in groups. folder: names files; empty: nothing was kept.
void print_hunt(const hunt::HuntState& state, const std::string& folder);

void print_relations();
Json relations_json();

}  // namespace tumble::tools
