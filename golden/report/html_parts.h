#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "golden/report/html_text.h"
#include "tumble/golden/case_result.h"

/// Small parts that every section of the page is made of.
namespace tumble::golden {

/// Words between two tags: element("<h3>", words, "</h3>\n").
Html element(Html::Markup open, std::string_view words, Html::Markup close);

/// A list, a sentence an item; empty for none.
Html list_of(const std::vector<std::string>& sentences);

/// "✓ exact passed", with its colour.
Html chip(const char* name, Outcome outcome);

/// A cell of a table. name: its column's, which narrow screens show beside it.
Html cell(std::string_view name, std::string_view words, bool is_number = false);

/// The classes and words of an outcome.
const char* class_of(Outcome outcome);  ///< "none", "pass", "fail"
const char* mark_of(bool passed);       ///< "✓ ", "✕ "
std::string words_of(Outcome outcome);  ///< "✓ passed"

}  // namespace tumble::golden
