#include "netlist/complete/complete.hpp"
#include "netlist/complete/settable.hpp"
#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace placedpar {

namespace {

/// Gives what options set to the nodes, connections and processes that they are for.
class ElementOverrides {
public:
    explicit ElementOverrides(Completion& c) : c_(c) {}

    /// What is said of one element goes before what is said of all, wherever it stands.
    void run() {
        std::vector<const DraftOverride*> order;
        for (const DraftOverride& option : c_.draft.overrides)
            order.push_back(&option);
        std::ranges::stable_sort(order, std::ranges::greater{}, [](const auto* each) { return precision_of(*each); });
        std::map<const DraftOverride*, SetByOption> done;
        for (const DraftOverride* option : order)
            attempt([&] { done.emplace(option, set(*option)); });
        c_.network.set = c_.draft.set;
        for (const DraftOverride& option : c_.draft.overrides)
            if (auto found = done.find(&option); found != done.end() && !found->second.elements.empty())
                c_.network.set.push_back(std::move(found->second));
    }

private:
    /// How closely the option says what it sets: of every element that has it, of an array, of an element.
    static std::size_t precision_of(const DraftOverride& option) {
        return option.element.empty() ? 0 : 1 + subscripts_of(option.element).size();
    }

    SetByOption set(const DraftOverride& option) {
        if ((option.element.empty() && option.member == "length") ||
            base_name(option.element) == free_name(wires_by_default))
            name_wires();
        if ((option.element.empty() && (option.member == "level" || option.member == "release")) ||
            base_name(option.element) == free_name(attachments_by_default))
            name_attachments();
        std::vector<Settable> named = elements_of(option), having;
        std::ranges::copy_if(named, std::back_inserter(having),
                             [&](const Settable& each) { return each.has(option.member, option.element.empty()); });
        if (having.empty())
            refuse(option, named);
        std::string name = option.element + (option.element.empty() ? "" : ".") + option.member;
        SetByOption done{name, option.value.typed, {}};
        for (const Settable& each : having)
            if (set_once(option, each))
                done.elements.push_back(each.name);
        return done;
    }

    std::vector<Settable> elements_of(const DraftOverride& option) const {
        std::vector<Settable> all = settable_elements(c_);
        std::erase_if(all, [&](const Settable& each) {
            return !option.element.empty() && each.name != option.element &&
                   !each.name.starts_with(option.element + "[");
        });
        return all;
    }

    /// False where an option that says it more precisely has set it.
    bool set_once(const DraftOverride& option, const Settable& element) {
        auto [first, is_new] = done_.emplace(std::pair(element.name, option.member), &option);
        if (!is_new && precision_of(*first->second) > precision_of(option))
            return false;
        if (!is_new) {
            c_.reporter.error(option.at, fmt::format("\"{}\" of \"{}\" is set twice", option.member, element.name), "",
                              {{"set first here", first->second->at}});
            throw StatementRefused{};
        }
        auto value =
            option.value.take(element.takes_text(option.member), element.what_it_takes(option.member), c_.reporter);
        element.set({option.member, std::move(value), option.value.at}, c_.reporter);
        return true;
    }

    static constexpr const char *wires_by_default = "wire", *attachments_by_default = "attachment";

    /// What an option can set of a wire are the attributes of a connection, and so of one that has a name.
    void name_wires() {
        std::string name = free_name(wires_by_default);
        std::int64_t number = 0;
        for (DraftWire& wire : c_.draft.wires)
            if (wire.connection == nowhere)
                wire.connection = add_connection(element_name(name, {number++}), wire.at);
    }

    /// The same of a master's place on a bus.
    void name_attachments() {
        std::string name = free_name(attachments_by_default);
        std::int64_t number = 0;
        for (DraftAttachment& each : c_.draft.attachments)
            if (each.connection == nowhere && c_.network.nodes[each.node].kind->is_master())
                each.connection = add_connection(element_name(name, {number++}), each.at);
    }

    std::size_t add_connection(std::string name, const Location& at) {
        c_.draft.connections.push_back({std::move(name), at, {}, {}, at, {}});
        return c_.draft.connections.size() - 1;
    }

    std::string free_name(const std::string& wanted) const {
        std::vector<Settable> all = settable_elements(c_);
        auto taken = [&](const std::string& name) {
            return std::ranges::any_of(all, [&](const Settable& each) { return base_name(each.name) == name; }) ||
                   find_named(c_.draft.edge_channels, name) != nullptr || c_.catalogue.node_types().contains(name);
        };
        std::string name = wanted;
        for (int number = 2; taken(name); ++number)
            name = fmt::format("{}_{}", wanted, number);
        return name;
    }

    [[noreturn]] void refuse(const DraftOverride& option, const std::vector<Settable>& named) {
        name_wires();
        name_attachments();
        if (option.element.empty())
            refuse_name(option);
        if (named.empty())
            refuse_element(option);
        const Settable& first = named.front();
        std::string meant = meant_by(option.member, first.members());
        report(option.member_at,
               fmt::format("the {} \"{}\" has no {} \"{}\"", first.noun(), option.element, first.noun_of_member(),
                           option.member),
               meant.empty() ? hint_at_other(option, first) : meant, {first.text_of_members()});
    }

    /// Where the processor of a process is meant, or the place of a master on its bus.
    std::string hint_at_other(const DraftOverride& option, const Settable& element) const {
        const auto* process = std::get_if<DraftProcess*>(&element.thing);
        if (process != nullptr && (*process)->node != nowhere) {
            Node& node = c_.network.nodes[(*process)->node];
            return hint_at(option, fmt::format("the node that \"{}\" is placed on", element.name), {node.name, &node});
        }
        for (const Settable& each : settable_elements(c_))
            if (each.connects == Settable::Connects::master && is_place_of(each, element))
                return hint_at(option, fmt::format("the place of \"{}\" on its bus", element.name), each);
        return "";
    }

    static std::string hint_at(const DraftOverride& option, const std::string& which, const Settable& other) {
        return other.has(option.member) ? fmt::format("{} has: --set {}.{}=...", which, other.name, option.member) : "";
    }

    bool is_place_of(const Settable& connection, const Settable& element) const {
        return std::ranges::any_of(c_.draft.attachments, [&](const DraftAttachment& each) {
            return each.connection != nowhere && c_.network.nodes[each.node].name == element.name &&
                   c_.draft.connections[each.connection].name == connection.name;
        });
    }

    /// A name by itself.
    [[noreturn]] void refuse_name(const DraftOverride& option) {
        const std::string& name = option.member;
        std::vector<Settable> all = settable_elements(c_);
        auto element = std::ranges::find(all, name, [](const Settable& each) { return base_name(each.name); });
        if (element != all.end())
            report(option.at, fmt::format("\"{}\" is a {}: say what of it to set", name, element->noun()),
                   fmt::format("--set {}.NAME=VALUE", name), {element->text_of_members()});
        if (c_.draft.vals_in_blocks.contains(name))
            report(option.at, fmt::format("the val \"{}\" is declared in a block", name),
                   "an option reaches vals outside of blocks");
        report(option.at, fmt::format("the netlist has no val, attribute or parameter \"{}\"", name),
               meant_by(name, names_to_set(c_)), what_can_be_set(c_));
    }

    static std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
        return name == "seed" ? "the seed of a run is an option of its own: --seed N" : did_you_mean(name, known);
    }

    static std::vector<std::string> names_of_elements(const std::vector<Settable>& elements) {
        std::vector<std::string> names;
        for (const Settable& each : elements)
            names.emplace_back(base_name(each.name));
        return names;
    }

    [[noreturn]] void refuse_element(const DraftOverride& option) {
        std::string_view name = base_name(option.element);
        std::vector<Settable> all = settable_elements(c_), array;
        std::ranges::copy_if(all, std::back_inserter(array),
                             [&](const Settable& each) { return base_name(each.name) == name; });
        if (array.empty())
            report(option.at, fmt::format("the netlist has no node, connection or process \"{}\"", name),
                   did_you_mean(name, names_of_elements(all)), what_can_be_set(c_));
        if (array.size() == 1 && array.front().name == name)
            report(option.at, fmt::format("\"{}\" is no array", name),
                   fmt::format("--set {}.{}=...", name, option.member));
        std::string more = array.size() == 1 ? "" : " to " + array.back().name;
        report(option.at, fmt::format("there is no \"{}\"", option.element),
               fmt::format("there is {}{}", array.front().name, more));
    }

    [[noreturn]] void report(const Location& at, std::string message, std::string hint,
                             const std::vector<std::string>& notes = {}) {
        std::vector<SecondPlace> others;
        for (const std::string& note : notes)
            others.push_back({note, {}});
        c_.reporter.error(at, std::move(message), std::move(hint), std::move(others));
        throw StatementRefused{};
    }

    Completion& c_;
    std::map<std::pair<std::string, std::string>, const DraftOverride*> done_; ///< by element and member
};

} // namespace

void complete_overrides(Completion& completion) {
    if (completion.draft.overrides.empty())
        completion.network.set = completion.draft.set;
    else
        ElementOverrides(completion).run();
}

} // namespace placedpar
