#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

// Parts of the module whose functions no other part uses.

void add_identifications(pybind11::module_&);
void add_searches(pybind11::module_&);
/// Adds sweeps and explanations.
void add_studies(pybind11::module_&);

} // namespace placedpar::python
