// placedpar with nothing but what is done with a netlist. Other compilers build it, to be compared.

#include "app/program.hpp"

int main(int argc, char** argv) { return placedpar::run_program(argc, argv, {}); }
