#pragma once

#include "python/module/interpreter.hpp"

#include "netlist/kinds/process_kind.hpp"

namespace placedpar::python {

/// Makes a process kind of a subclass of placedpar.Process. REQUIRES: the caller holds the lock. Throws UserError if
/// the class does not describe a kind.
ProcessKind kind_of(pybind11::handle process_class);

} // namespace placedpar::python
