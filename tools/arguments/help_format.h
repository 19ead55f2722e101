#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tumble::tools {

/// Help as one reads it: "--seconds S" without what it excludes and needs, descriptions broken before column 100.
class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace tumble::tools
