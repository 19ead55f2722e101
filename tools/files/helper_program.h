#pragma once

#include <string>

namespace tumble::tools {

/// The path of a program that lies beside this one; empty if there is none.
std::string helper_program(const std::string& name);

}  // namespace tumble::tools
