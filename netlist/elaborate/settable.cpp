#include "netlist/elaborate/settable.hpp"

#include "netlist/elaborate/attributes.hpp"
#include "netlist/elaborate/declared_type.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

using Members = std::vector<SettableMember>;
using SharedMembers = std::shared_ptr<const Members>;

constexpr std::size_t most_names_in_a_list = 12, most_groups_in_a_list = 8;

std::string list_of(std::vector<std::string> names, std::size_t most) {
    std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more == 0 ? "" : fmt::format(" and {} more", more));
}

std::string list_of_members(const Settable& element) {
    bool cut = element.members->size() > most_names_in_a_list && element.kind != nullptr;
    return list_of(names_in(*element.members), most_names_in_a_list) +
           (cut ? fmt::format(", see {} kinds {}", program_name(), element.kind->name) : "");
}

void add(Members& members, const ParameterDescription& description) {
    members.push_back({description.name, &description, description.type == ParameterType::text});
}

Members members_of(const std::vector<AttributeDescription>& attributes) {
    Members members;
    for (const AttributeDescription& attribute : attributes)
        add(members, attribute.value);
    return members;
}

Members members_of(const ProcessKind* kind, const Interface* interface) {
    Members members;
    if (kind != nullptr)
        for (const ParameterDescription& parameter : kind->parameters)
            add(members, parameter);
    else if (interface != nullptr)
        for (const ParameterDeclaration& declared : interface->parameters)
            members.push_back({declared.name, nullptr,
                               element_type(declared) == ParameterType::text && element_dimensions(declared) == 0});
    members.push_back({"priority"});
    return members;
}

/// Returns the attributes of each connection that an option can set. They depend on whether the connection joins links
/// or attaches a master to a bus.
std::vector<SharedMembers> members_of_connections(const Draft& draft) {
    const Members all = members_of(connection_attributes());
    const auto of_none = std::make_shared<const Members>(),
               of_wire = std::make_shared<const Members>(all.begin(), all.begin() + 2),
               of_master = std::make_shared<const Members>(all.begin() + 2, all.end());
    std::vector<SharedMembers> members(draft.connections.size(), of_none);
    for (const DraftWire& wire : draft.wires)
        if (wire.connection != nowhere)
            members[wire.connection] = of_wire;
    for (const DraftAttachment& each : draft.attachments)
        if (each.connection != nowhere && draft.nodes[each.node].kind->is_master())
            members[each.connection] = of_master;
    return members;
}

/// Returns a text with the names of the elements and what can be set in them. Elements with equal attributes and
/// parameters form a group, which is followed by these. An array is listed by its name without subscripts.
std::string groups_of(const std::vector<Settable>& elements, std::size_t category) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups; ///< members, and names of the elements
    for (const Settable& each : elements) {
        if (each.thing.index() != category || each.members->empty())
            continue;
        std::string members = list_of_members(each), name(base_name(each.name));
        auto group = std::ranges::find(groups, members, [](const auto& known) { return known.first; });
        if (group == groups.end())
            group = groups.insert(group, {members, {}});
        if (std::ranges::find(group->second, name) == group->second.end())
            group->second.push_back(name);
    }
    std::vector<std::string> texts;
    for (const auto& [members, names] : groups)
        texts.push_back(fmt::format("{} ({})", list_of(names, most_groups_in_a_list), members));
    return list_of(texts, most_groups_in_a_list);
}

} // namespace

std::string SettableMember::what_it_takes() const {
    if (description == nullptr)
        return name == "priority" ? "expected HIGH or LOW" : "";
    static constexpr const char* types[] = {"an integer", "a number", "a string"};
    bool has_range = description->least || description->most;
    return fmt::format("expected {}{}", types[static_cast<int>(description->type)],
                       has_range ? " " + range_of(*description) : "");
}

const char* Settable::noun() const {
    static constexpr const char* nouns[] = {"node", "connection", "process"};
    return nouns[thing.index()];
}

const char* Settable::noun_of_member() const {
    return std::holds_alternative<DraftProcess*>(thing) ? "parameter" : "attribute";
}

std::string Settable::text_of_members() const {
    return members->empty() ? "it has nothing that can be set" : "it has " + list_of_members(*this);
}

bool Settable::has(const std::string& name, bool as_every_element) const {
    const auto* connection = std::get_if<DraftConnection*>(&thing);
    if (as_every_element && connection != nullptr && name == "linkspeed")
        return (*connection)->bits_per_second.has_value();
    const auto* node = std::get_if<Node*>(&thing);
    return member(name) != nullptr ||
           (node != nullptr ? has_node_attribute(**node, name) : connection == nullptr && is_process_attribute(name));
}

void Settable::set(const Setting& setting, Reporter& reporter) const {
    if (const auto* node = std::get_if<Node*>(&thing))
        apply_node_attribute(**node, setting, reporter);
    else if (const auto* connection = std::get_if<DraftConnection*>(&thing))
        apply_connection_attributes(**connection, {setting}, reporter);
    else
        std::get<DraftProcess*>(thing)->overrides.push_back(setting);
}

std::vector<Settable> settable_elements(Draft& draft, const Catalogue& catalogue) {
    std::map<const void*, SharedMembers> known;
    auto shared = [&](const void* key, const auto&... of) {
        SharedMembers& members = known[key];
        if (members == nullptr)
            members = std::make_shared<const Members>(members_of(of...));
        return members;
    };
    std::vector<Settable> all;
    for (Node& node : draft.nodes)
        if (node.kind->has_attributes())
            all.push_back({node.name, &node, shared(&*node.kind, node.kind->attributes)});
    const std::vector<SharedMembers> of_connections = members_of_connections(draft);
    for (std::size_t i = 0; i < of_connections.size(); ++i)
        all.push_back({draft.connections[i].name, &draft.connections[i], of_connections[i]});
    for (DraftProcess& process : draft.processes) {
        const ProcessKind* kind = catalogue.find(process.kind);
        const Interface* interface = kind == nullptr ? process.interface.get() : nullptr;
        const void* key = kind == nullptr ? static_cast<const void*>(interface) : kind;
        all.push_back({process.name, &process, shared(key, kind, interface), kind});
    }
    return all;
}

std::vector<SecondPlace> what_can_be_set(const std::vector<std::pair<std::string, Constant>>& vals,
                                         const std::vector<Settable>& all) {
    std::vector<SecondPlace> notes;
    std::vector<std::string> values;
    for (const auto& [name, value] : vals)
        values.push_back(fmt::format("{} = {}", name, shown(value)));
    auto note = [&](const std::string& heading, const std::string& what) {
        if (!what.empty())
            notes.push_back({heading + what, {}});
    };
    note("vals: ", list_of(values, most_names_in_a_list));
    note("processes and their parameters: ", groups_of(all, 2));
    note("nodes and their attributes: ", groups_of(all, 0));
    note("connections and their attributes: ", groups_of(all, 1));
    return notes;
}

} // namespace placedpar
