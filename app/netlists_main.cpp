// placedpar with only the commands for netlists. Other compilers build it for comparison.

#include "app/program.hpp"

int main(int argc, char** argv) { return placedpar::run_program(argc, argv, {}); }
