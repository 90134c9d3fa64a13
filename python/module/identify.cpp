#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/identify/identify_record.hpp"
#include "explore/identify/record_text.hpp"
#include "python/module/network.hpp"
#include "python/module/signals.hpp"
#include "text/refused_text.hpp"

#include <boost/json.hpp>
#include <pybind11/stl.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// Returns the report as JSON, the text for people, and the warnings about the readings.
py::tuple identify(std::string_view text, IdentifySettings settings) {
    settle_way(settings);
    boost::json::object json;
    std::string printed, of_machine;
    std::vector<Diagnostic> warnings;
    try {
        InterruptedByKeyboard interruption;
        const py::gil_scoped_release unlocked;
        identify_record(settings, record_of_text(text, interruption, warnings),
                        {json, true, [&printed](const std::string& more) { printed += more; },
                         [&of_machine](const std::string& more) { of_machine += more; }, [](const std::string&) {}});
    } catch (const RefusedText& unfit) {
        raise("RecordError", "", as_dicts(unfit.diagnostics()));
    }
    heed_signals();
    return py::make_tuple(boost::json::serialize(json), printed, as_dicts(warnings), of_machine);
}

} // namespace

void add_identifications(py::module_& module) {
    using Settings = IdentifySettings;
    py::class_<Settings> settings(module, "IdentifySettings");
    settings.def(py::init<>());
    for (const auto& [name, text] : {std::pair{"links", &Settings::links},
                                     {"configuration", &Settings::configuration},
                                     {"way", &Settings::way},
                                     {"offset", &Settings::offset},
                                     {"areas_from", &Settings::areas},
                                     {"missing", &Settings::missing},
                                     {"machine", &Settings::machine},
                                     {"coding", &Settings::coding},
                                     {"side", &Settings::side},
                                     {"columns_from", &Settings::columns_from}})
        settings.def_readwrite(name, text);
    for (const auto& [name, number] : {std::pair{"bits", &Settings::bits},
                                       {"population", &Settings::population},
                                       {"trials", &Settings::trials},
                                       {"window", &Settings::window},
                                       {"elite", &Settings::elite},
                                       {"samples", &Settings::samples}})
        settings.def_readwrite(name, number);
    settings.def_readwrite("columns", &Settings::columns);
    settings.def_readwrite("seed", &Settings::seed);
    settings.def_readwrite("bias", &Settings::bias);
    settings.def_readwrite("rising", &Settings::rising);
    module.def("identify", identify);
}

} // namespace placedpar::python
