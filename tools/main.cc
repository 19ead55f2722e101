// The program `tumble`: run_program.cc is where it begins.
#include "tools/run_program.h"

int main(int argc, char** argv) { return static_cast<int>(tumble::tools::run_program({argv + 1, argv + argc})); }
