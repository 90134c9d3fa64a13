#include "explore/study/study_names.hpp"

#include "explore/load.hpp"
#include "explore/occam_program.hpp"
#include "explore/stated_vals.hpp"
#include "explore/study/measure.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "netlist/language/names_in_text.hpp"
#include "netlist/network/names.hpp"
#include "report/kinds_report.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace placedpar {

namespace {

/// Adds a setting of an element, and the setting of all elements that have the attribute or parameter.
void add_setting(StudyNames& names, const std::string& element, const ParameterDescription& described,
                 const Location& at) {
    const StudyName name{print_parameter(described, described.default_value), at, described.choices};
    names.settings.emplace(element + "." + described.name, name);
    names.settings.emplace(described.name, name);
}

void add_attributes(StudyNames& names, const std::string& element, const std::vector<AttributeDescription>& attributes,
                    const Location& at) {
    for (const AttributeDescription& each : attributes)
        add_setting(names, element, each.value, at);
}

void add_process(StudyNames& names, const ProcessInstance& process, const Catalogue& catalogue) {
    const ProcessKind* const kind = catalogue.find(process.kind);
    names.programs[process.kind].at = process.declared;
    for (const ParameterDescription& each : kind ? kind->parameters : std::vector<ParameterDescription>()) {
        const auto given = process.given.find(each.name);
        add_setting(names, std::string(base_name(process.name)), each,
                    given == process.given.end() ? process.declared : given->second);
    }
}

/// Adds the elements of a network; of an array, only the first element.
void add_elements(StudyNames& names, const Network& network, const Catalogue& catalogue) {
    std::set<std::string, std::less<>> known;
    for (const Node& each : network.nodes)
        if (known.emplace(base_name(each.name)).second)
            add_attributes(names, std::string(base_name(each.name)), each.kind->attributes, each.declared);
    for (const LinkConnection& each : network.connections)
        if (!each.name.empty() && known.emplace(base_name(each.name)).second)
            add_attributes(names, std::string(base_name(each.name)), connection_attributes(), each.connected);
    for (const ProcessInstance& each : network.processes)
        if (known.emplace(base_name(each.name)).second)
            add_process(names, each, catalogue);
}

void add_constants(StudyNames& names, const Network& network, const ReadOptions& options) {
    const NetlistSyntax syntax = read_syntax(load_shown_input(network.source_path).file, options.include_folders);
    for (const auto& [name, value] : stated_vals(network)) {
        const NetlistName* const declared = syntax.find(name);
        names.settings[name] = {fmt::format("val {} {};\n", name, value), declared ? declared->at : Location{}, {}};
    }
}

/// Adds the measures, with the places of the processes and nodes that have them.
void add_measures(StudyNames& names, const Network& network, const Catalogue& catalogue,
                  const ProblemRegistry& problems) {
    PossibleMeasures possible;
    possible.add(network, catalogue, problems);
    possible.add("price");
    std::map<std::string, Location, std::less<>> declared;
    for (const Node& each : network.nodes)
        declared.emplace(base_name(each.name), each.declared);
    for (const ProcessInstance& each : network.processes)
        declared.emplace(base_name(each.name), each.declared);
    for (const auto& [name, about] : possible.abouts()) {
        const auto found = declared.find(name.substr(0, name.find('.')));
        names.measures[name] = {
            fmt::format("{}: {}\n", name, about), found == declared.end() ? Location{} : found->second, {}};
    }
}

} // namespace

std::optional<StudyNames> names_for_study(const std::filesystem::path& netlist, const ReadOptions& options,
                                          const Catalogue& catalogue, const ProblemRegistry& problems) {
    ReadOptions read = options;
    read.make_netlist = netlist_maker({});
    try {
        const Network network = load_network(ParsedNetlist(netlist, read), {}, catalogue, [](const std::string&) {});
        StudyNames names;
        add_elements(names, network, catalogue);
        add_constants(names, network, options);
        add_measures(names, network, catalogue, problems);
        return names;
    } catch (const UserError&) { // the study's check reports the error
        return std::nullopt;
    }
}

} // namespace placedpar
