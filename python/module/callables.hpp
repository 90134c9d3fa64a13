#pragma once

#include "gaprocs/islands.hpp"
#include "python/module/interpreter.hpp"

namespace placedpar::python {

/// The first exception that a policy (a step of a genetic search) or a fitness function in Python has raised. The
/// library reports only the text of an exception, but the user shall get the exception itself.
using PolicyFailure = std::shared_ptr<SharedObject>;

/// Changes a setting of placedpar.search(). A policy is given by its name, such as "tournament(3)", or as a function in
/// Python. REQUIRES: the caller holds Python's global lock whenever the policy is used.
void change(IslandsSettings&, const std::string& name, const pybind11::object& value, const PolicyFailure&);

} // namespace placedpar::python
