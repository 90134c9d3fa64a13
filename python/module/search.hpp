#pragma once

#include <pybind11/pybind11.h>

namespace placedpar::python {

void add_searches(pybind11::module_&);

} // namespace placedpar::python
