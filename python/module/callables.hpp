#pragma once

#include "gaprocs/islands.hpp"
#include "python/module/interpreter.hpp"

namespace placedpar::python {

/// The first exception of a policy or fitness in Python. The library reports only the text of the exception.
using PolicyFailure = std::shared_ptr<SharedObject>;

/// Changes a setting of placedpar.search(). A policy is given by its name in a netlist, such as "tournament(3)", or as
/// a function in Python. REQUIRES: the caller holds the lock whenever the policy is used.
void change(IslandsSettings&, const std::string& name, const pybind11::object& value, const PolicyFailure&);

} // namespace placedpar::python
