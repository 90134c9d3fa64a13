#include "python/module/module.hpp"
#include "python/module/interpreter.hpp"
#include "python/module/signals.hpp"
#include "report/manifest.hpp"
#include "text/user_error.hpp"

/// Makes the part of the package that is in C++. Users call the functions in python/placedpar/, which call this part.
PYBIND11_MODULE(_core, module) {
    using namespace placedpar::python;
    module.attr("version") = placedpar::version;
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const placedpar::UserError& error) {
            PyErr_SetString(error_named("Error").ptr(), error.what());
        }
    });
    add_operations(module);
    add_networks(module);
    add_random(module);
    add_searches(module);
    add_studies(module);
    add_identifications(module);
    pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(end_all_runs));
}
