// This program has only placedpar's commands for netlists. Tests build it with other compilers and compare its results.

#include "app/program.hpp"

int main(int argc, char** argv) { return placedpar::run_program(argc, argv, {}); }
