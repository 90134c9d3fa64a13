#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

/// Adds the identification of compliances to the module.
void add_identifications(pybind11::module_&);

} // namespace placedpar::python
