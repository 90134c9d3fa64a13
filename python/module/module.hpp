#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

// Each of these functions adds a part to the Python module. Only module.cpp calls them.

void add_identifications(pybind11::module_&);
void add_networks(pybind11::module_&);
/// Adds the operations that the body of a process in Python yields, such as an input. See python/placedpar/process.py
/// for their use.
void add_operations(pybind11::module_&);
void add_random(pybind11::module_&);
void add_searches(pybind11::module_&);
/// Adds sweeps (many runs with different settings) and explanations of runs.
void add_studies(pybind11::module_&);

} // namespace placedpar::python
