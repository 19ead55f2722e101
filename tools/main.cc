// The program `tumble`. Start reading at run_program.cc.
#include "tools/run_program.h"

int main(int argc, char** argv) { return static_cast<int>(tumble::tools::run_program({argv + 1, argv + argc})); }
