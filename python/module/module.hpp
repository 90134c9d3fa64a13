#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

// These functions add their parts of the module. No other part uses them.

void add_identifications(pybind11::module_&);
void add_networks(pybind11::module_&);
/// Adds the operations that a body yields. See python/placedpar/process.py for their use.
void add_operations(pybind11::module_&);
void add_random(pybind11::module_&);
void add_searches(pybind11::module_&);
/// Adds sweeps and explanations.
void add_studies(pybind11::module_&);

} // namespace placedpar::python
