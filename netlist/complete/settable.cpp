#include "netlist/complete/settable.hpp"

#include "netlist/complete/declared_type.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "netlist/network/names.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

constexpr std::size_t most_names_in_a_list = 12, most_groups_in_a_list = 8;

std::string list_of(std::vector<std::string> names, std::size_t most) {
    std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more == 0 ? "" : fmt::format(" and {} more", more));
}

std::string list_of_members(const Settable& element) {
    std::vector<std::string> names = element.members();
    bool cut = names.size() > most_names_in_a_list && element.kind != nullptr;
    return list_of(std::move(names), most_names_in_a_list) +
           (cut ? fmt::format(", see {} kinds {}", program_name(), element.kind->name) : "");
}

std::vector<std::string> members_of(const Node& node) {
    std::vector<std::string> names;
    for (const AttributeDescription& attribute : node.kind->attributes)
        names.push_back(attribute.value.name);
    return names;
}

std::vector<std::string> members_of_connection(Settable::Connects connects) {
    switch (connects) {
    case Settable::Connects::wire: return {"linkspeed", "length"};
    case Settable::Connects::master: return {"level", "release"};
    case Settable::Connects::other: break;
    }
    return {};
}

std::vector<std::string> members_of(const DraftProcess& process, const ProcessKind* kind) {
    std::vector<std::string> names;
    if (kind != nullptr)
        names = names_in(kind->parameters);
    else if (process.interface)
        names = names_in(process.interface->parameters);
    names.emplace_back("priority");
    return names;
}

bool keeps(const Node& node, const std::string& member) { return has_node_attribute(node, member); }
bool keeps(const DraftConnection&, const std::string&) { return false; }
bool keeps(const DraftProcess&, const std::string& member) { return is_process_attribute(member); }

void set_in(Node& node, const Setting& setting, Reporter& reporter) { apply_node_attribute(node, setting, reporter); }
void set_in(DraftConnection& connection, const Setting& setting, Reporter& reporter) {
    apply_connection_attributes(connection, {setting}, reporter);
}
void set_in(DraftProcess& process, const Setting& setting, Reporter&) { process.overrides.push_back(setting); }

/// What each connection is used for.
std::vector<Settable::Connects> uses_of_connections(const Draft& draft, const std::vector<Node>& nodes) {
    std::vector<Settable::Connects> uses(draft.connections.size(), Settable::Connects::other);
    for (const DraftWire& wire : draft.wires)
        if (wire.connection != nowhere)
            uses[wire.connection] = Settable::Connects::wire;
    for (const DraftAttachment& each : draft.attachments)
        if (each.connection != nowhere && nodes[each.node].kind->is_master())
            uses[each.connection] = Settable::Connects::master;
    return uses;
}

std::string what_takes(const ParameterDescription& description) {
    static constexpr const char* types[] = {"an integer", "a number", "a string"};
    bool has_range = description.least || description.most;
    return fmt::format("it takes {}{}", types[static_cast<int>(description.type)],
                       has_range ? ": " + range_of(description) : "");
}

/// The elements of an array are one group, and so are others that have the same to set.
std::string groups_of(const std::vector<Settable>& elements, std::size_t category) {
    std::vector<std::pair<std::string, std::vector<std::string>>> groups; ///< members, names
    for (const Settable& each : elements) {
        std::string members = list_of_members(each), name(base_name(each.name));
        if (each.thing.index() != category || members.empty())
            continue;
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

const char* Settable::noun() const {
    static constexpr const char* nouns[] = {"node", "connection", "process"};
    return nouns[thing.index()];
}

const char* Settable::noun_of_member() const {
    return std::holds_alternative<DraftProcess*>(thing) ? "parameter" : "attribute";
}

std::vector<std::string> Settable::members() const {
    if (const auto* node = std::get_if<Node*>(&thing))
        return members_of(**node);
    if (const auto* process = std::get_if<DraftProcess*>(&thing))
        return members_of(**process, kind);
    return members_of_connection(connects);
}

std::string Settable::text_of_members() const {
    std::string names = list_of_members(*this);
    return names.empty() ? "it has nothing that can be set" : "it has " + names;
}

bool Settable::has(const std::string& member, bool as_every_element) const {
    const auto* connection = std::get_if<DraftConnection*>(&thing);
    if (as_every_element && connection != nullptr && member == "linkspeed")
        return (*connection)->bits_per_second.has_value();
    return std::ranges::count(members(), member) > 0 ||
           std::visit([&](const auto* each) { return keeps(*each, member); }, thing);
}

bool Settable::takes_text(const std::string& member) const {
    if (std::holds_alternative<DraftConnection*>(thing))
        return member == "release";
    const auto* process = std::get_if<DraftProcess*>(&thing);
    if (const auto* known = kind == nullptr ? nullptr : kind->parameter(member))
        return known->type == ParameterType::text;
    if (process == nullptr || !(*process)->interface)
        return false;
    const auto* declared = find_named((*process)->interface->parameters, member);
    return declared != nullptr && element_type(*declared) == ParameterType::text && element_dimensions(*declared) == 0;
}

std::string Settable::what_it_takes(const std::string& member) const {
    if (std::holds_alternative<DraftConnection*>(thing))
        return member == "length"    ? "it takes a number of metres"
               : member == "level"   ? "it takes an integer from 0 to 3"
               : member == "release" ? "it takes RWD or ROR"
                                     : "it takes an integer, in bit/s";
    const ParameterDescription* description = nullptr;
    if (const auto* node = std::get_if<Node*>(&thing)) {
        const auto* attribute = (*node)->kind->attribute(member);
        description = attribute == nullptr ? nullptr : &attribute->value;
    } else if (kind != nullptr) {
        description = kind->parameter(member);
    }
    if (description == nullptr)
        return member == "priority" ? "it takes HIGH or LOW" : "";
    return what_takes(*description);
}

void Settable::set(const Setting& setting, Reporter& reporter) const {
    std::visit([&](auto* each) { set_in(*each, setting, reporter); }, thing);
}

std::vector<Settable> settable_elements(Completion& c) {
    std::vector<Settable> all;
    for (Node& node : c.network.nodes)
        if (node.kind->has_attributes())
            all.push_back({node.name, &node});
    auto uses = uses_of_connections(c.draft, c.network.nodes);
    for (std::size_t i = 0; i < uses.size(); ++i)
        all.push_back({c.draft.connections[i].name, &c.draft.connections[i], nullptr, uses[i]});
    for (DraftProcess& process : c.draft.processes)
        all.push_back({process.name, &process, c.catalogue.find(process.kind)});
    return all;
}

std::vector<std::string> names_to_set(Completion& c) {
    std::vector<std::string> names;
    for (const auto& [name, value] : c.draft.vals)
        names.push_back(name);
    for (const Settable& each : settable_elements(c)) {
        std::ranges::copy(each.members(), std::back_inserter(names));
        names.emplace_back(base_name(each.name));
    }
    return names;
}

std::vector<std::string> what_can_be_set(Completion& c) {
    std::vector<Settable> all = settable_elements(c);
    std::vector<std::string> lines, vals;
    for (const auto& [name, value] : c.draft.vals)
        vals.push_back(fmt::format("{} = {}", name, shown(value)));
    auto add = [&](const std::string& heading, const std::string& what) {
        if (!what.empty())
            lines.push_back(heading + what);
    };
    add("vals: ", list_of(vals, most_names_in_a_list));
    add("processes and their parameters: ", groups_of(all, 2));
    add("nodes and their attributes: ", groups_of(all, 0));
    add("connections and their attributes: ", groups_of(all, 1));
    return lines;
}

} // namespace placedpar
