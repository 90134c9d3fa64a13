#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

/// Adds sweeps and explanations to the module.
void add_studies(pybind11::module_&);

} // namespace placedpar::python
