#include "serve/faults.hpp"

#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "occam/configuration/configuration.hpp"
#include "text/paint.hpp"

#include <boost/json.hpp>

namespace placedpar::serve {

namespace json = boost::json;

namespace {

json::object place_json(const Location& place) {
    return {{"file", place.file ? place.file->path() : ""}, {"line", place.line}, {"column", place.column}};
}

json::object fault_json(const Diagnostic& fault) {
    json::object object = place_json(fault.location);
    object["severity"] = fault.severity == Severity::error ? "error" : "warning";
    object["message"] = unpainted(fault.message);
    object["hint"] = unpainted(fault.hint);
    json::array others;
    for (const SecondPlace& each : fault.others) {
        others.push_back(place_json(each.location));
        others.back().as_object()["message"] = unpainted(each.message);
    }
    object["others"] = std::move(others);
    return object;
}

std::vector<Diagnostic> faults_of(const std::string& main) {
    if (is_occam(main))
        return faults_of_occam(main);
    ReadOptions options;
    options.make_netlist = occam::netlist_of_configuration;
    return read_netlist(main, known_kinds(known_problems(0)), {}, options).diagnostics;
}

} // namespace

json::array faults_json(const std::string& main) {
    json::array all;
    for (const Diagnostic& fault : faults_of(main))
        all.push_back(fault_json(fault));
    return all;
}

} // namespace placedpar::serve
