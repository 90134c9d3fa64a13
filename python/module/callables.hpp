#pragma once

#include "gaprocs/islands.hpp"
#include "python/module/interpreter.hpp"

namespace placedpar::python {

/// The first exception of a policy or fitness in Python. The library reports only its text.
using PolicyFailure = std::shared_ptr<SharedObject>;

/// Sets a policy of the settings from its name in a netlist, such as "tournament(3)", or from a function in Python.
/// REQUIRES: the step is one of placedpar.search(); the caller holds the lock whenever the policy is used.
void set_policy(IslandsSettings&, const std::string& step, const pybind11::object& policy, const PolicyFailure&);

} // namespace placedpar::python
