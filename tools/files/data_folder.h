#pragma once

#include <filesystem>

namespace tumble::tools {

/// The folder with `golden/cases` and `bench/scenes` that belongs to this program: `share/tumble` beside the folder of
/// an installed program, wherever the installation was moved; else the source folder that the program was built from.
/// Empty if there is neither.
std::filesystem::path data_folder();

}  // namespace tumble::tools
