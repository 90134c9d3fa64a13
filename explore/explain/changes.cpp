#include "explore/explain/changes.hpp"

#include "explore/stated_vals.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "text/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace placedpar {

namespace {

constexpr std::int64_t fastest = 1'000'000'000; ///< greatest clock (Hz) and link speed (bits/s) in a netlist
constexpr std::size_t most_alone = 10;          ///< largest number of single parts of each kind that are varied
constexpr std::size_t most_nodes_in_full = 256; ///< in networks with more nodes, fewer changes are tried
constexpr std::size_t most_alone_of_many = 3;   ///< replaces `most_alone` in larger networks

/// Attributes of a bus that cost time. The time-out is not among them, because it matters only if a device does not
/// respond.
constexpr std::array bus_times{"cycle", "bytecycle", "grant"};

/// The attribute for the cycles of a memory access. It is never reduced to 0, which stands for the processor's usual
/// value.
constexpr const char* memory_cycles = "memorycycles";
constexpr const char* router_cycles = "router_cycles"; // matters only if channels travel in packets
constexpr const char* cycles_on_chip = "1";

struct Factor {
    const char* faster;
    const char* less;
    double by; ///< factor of the speed; 0: as fast as the language allows
};
constexpr std::array<Factor, 3> factors{{
    {.faster = "10 % faster", .less = "a tenth less", .by = 1.1},
    {.faster = "twice as fast", .less = "half", .by = 2},
    {.faster = "as fast as can be", .less = "none", .by = 0},
}};

std::string faster(std::int64_t rate, const Factor& factor) {
    auto wanted = static_cast<std::int64_t>(std::llround(static_cast<double>(rate) * factor.by));
    return std::to_string(factor.by == 0 ? fastest : std::min(wanted, fastest));
}

/// Returns a smaller constant: 0.9 times the constant for the factor 1.1, half of the constant for the factor 2,
/// otherwise 0.
std::string less(std::int64_t constant, const Factor& factor) {
    double share = factor.by == 0 ? 0 : factor.by == 2 ? 0.5 : 0.9;
    return std::to_string(std::llround(static_cast<double>(constant) * share));
}

/// Returns a shorter time in ns; at least `least`, the least time that a netlist accepts.
std::string shorter(std::int64_t time, std::int64_t least, const Factor& factor) {
    auto wanted = factor.by == 0 ? least : std::llround(static_cast<double>(time) / factor.by);
    return std::to_string(std::max<std::int64_t>(wanted, least));
}

std::string array_of(const std::string& name) { return name.substr(0, name.find('[')); }

std::string as_array(const std::string& name) { return array_of(name) + (name.find('[') < name.size() ? "[]" : ""); }

/// Returns the names of the parts that were used longest, at most `most` parts, the longest use first. `spent` returns
/// the time of a use.
template <class Uses, class Name, class Spent>
std::vector<std::string> busiest(std::size_t most, const Uses& uses, Name name, Spent spent) {
    std::vector<std::pair<Time, std::string>> by_time;
    for (const auto& use : uses)
        if (Time time = spent(use); time > Time{0})
            by_time.emplace_back(-time, name(use));
    std::ranges::sort(by_time);
    std::vector<std::string> names;
    for (const auto& [time, each] : by_time)
        if (names.size() < most && std::ranges::find(names, each) == names.end())
            names.push_back(each);
    return names;
}

class Changes {
public:
    Changes(const Network& network, const RunReport& report, const DeclaredWith& declared)
        : network_(network), report_(report), declared_(declared), now_(declared({})) {}

    std::vector<Change> all() && {
        add_processors();
        add_memory();
        add_links();
        add_buses();
        add_processes();
        add_constants();
        add_vals();
        if (network_.nodes.size() > most_nodes_in_full)
            std::erase_if(changes_, [](const Change& each) {
                return is_extreme(each, factors.front()) || is_extreme(each, factors.back());
            });
        leave_out_repeated();
        return std::move(changes_);
    }

private:
    /// Leaves out changes that set the same as an earlier one: a constant that only one process has is also what this
    /// process computes.
    void leave_out_repeated() {
        std::set<Overrides> known;
        std::erase_if(changes_, [&known](const Change& each) { return !known.insert(each.set).second; });
    }

    void add_clocks(Change::Of of, const std::string& what, const std::set<std::size_t>& nodes) {
        if (nodes.empty() || !clocks_known_.insert(nodes).second)
            return;
        for (const Factor& factor : factors) {
            Change change{of, what, factor.faster, {}};
            for (std::size_t node : nodes)
                change.set[network_.nodes[node].name + ".clock"] =
                    faster(network_.nodes[node].integer("clock"), factor);
            changes_.push_back(std::move(change));
        }
    }

    /// Returns whether the change has the smallest or the greatest factor. Runs of a large network take long, so only
    /// the middle factor is tried in a large network.
    static bool is_extreme(const Change& change, const Factor& factor) {
        return change.change == factor.faster || change.change == factor.less;
    }

    bool has_clock(std::size_t node) const {
        return node != nowhere && network_.nodes[node].attributes.contains("clock");
    }

    void add_processors() {
        std::set<std::size_t> all;
        std::map<std::string, std::set<std::size_t>> arrays, alone;
        for (std::size_t node = 0; node < network_.nodes.size(); ++node)
            if (has_clock(node)) {
                all.insert(node);
                alone[network_.nodes[node].name] = {node};
            }
        for (const ProcessInstance& process : network_.processes)
            if (has_clock(process.node))
                arrays[as_array(process.name)].insert(process.node);
        add_clocks(Change::Of::all, "all processors", all);
        for (const auto& [name, nodes] : arrays)
            add_clocks(nodes.size() == 1 ? Change::Of::alone : Change::Of::array,
                       (nodes.size() == 1 ? "processor of " : "processors of ") + name, nodes);
        for (const std::string& name : busiest(most_alone_, report_.processors, std::mem_fn(&ProcessorUse::name),
                                               std::mem_fn(&ProcessorUse::busy)))
            add_clocks(Change::Of::alone, "processor " + name, alone[name]);
    }

    void add_memory() {
        Change change{Change::Of::all, "memory of all processors", "as fast as on the chip", {}};
        for (const Node& node : network_.nodes)
            if (node.attributes.contains(memory_cycles))
                change.set[key_of(node.name, memory_cycles, true)] = cycles_on_chip;
        if (!change.set.empty())
            changes_.push_back(std::move(change));
    }

    /// Returns the name in `--set` of an element's attribute or parameter. `by_all`: every element that has it gets the
    /// same value, so a single setting without the element's name serves, unless a `val` has the attribute's name.
    std::string key_of(const std::string& owner, const std::string& name, bool by_all) const {
        return by_all && !vals_.contains(name) ? name : owner + "." + name;
    }

    static void set_speed(Change& change, const LinkConnection& wire, const Factor& factor) {
        for (const std::string& name : wire.names_for_set)
            change.set[name + ".linkspeed"] = faster(wire.bits_per_second, factor);
    }

    std::span<const LinkConnection> wires() const {
        return std::span(network_.connections).first(network_.count_wires());
    }

    /// Returns the wires that are varied alone; each wire has both of its ends as keys. Connections that a program
    /// makes during the run are left out, since several of them may share a wire.
    std::map<std::string, const LinkConnection*> wires_by_end() const {
        std::map<std::string, const LinkConnection*> by_end;
        for (const LinkConnection& wire : wires())
            if (!wire.at_run_time)
                by_end[link_name(network_.nodes, wire.a)] = by_end[link_name(network_.nodes, wire.b)] = &wire;
        return by_end;
    }

    void add_links() {
        const auto by_end = wires_by_end();
        if (!wires().empty() && (wires().size() > 1 || by_end.empty()))
            add_all_links();
        for (const std::string& from :
             busiest(most_alone_, report_.links, std::mem_fn(&LinkUse::from), std::mem_fn(&LinkUse::occupied)))
            if (const auto wire = by_end.find(from); wire != by_end.end())
                add_link(*wire->second);
    }

    /// Adds the changes of all links: by one setting if all links are equally fast, otherwise by one for each link.
    void add_all_links() {
        const auto speed = wires().front().bits_per_second;
        const bool same = !vals_.contains("linkspeed") &&
                          std::ranges::all_of(wires(), [&](const auto& each) { return each.bits_per_second == speed; });
        for (const Factor& factor : factors) {
            Change change{Change::Of::all, "all links", factor.faster, {}};
            if (same)
                change.set["linkspeed"] = faster(speed, factor);
            for (const LinkConnection& wire : wires())
                if (!same)
                    set_speed(change, wire, factor);
            changes_.push_back(std::move(change));
        }
    }

    /// Adds the changes of a link, unless they have been added. Both directions of the link may be among the busiest.
    void add_link(const LinkConnection& wire) {
        if (!links_known_.insert(&wire).second)
            return;
        for (const Factor& factor : factors) {
            Change change{
                Change::Of::alone,
                fmt::format("link {} - {}", link_name(network_.nodes, wire.a), link_name(network_.nodes, wire.b)),
                factor.faster,
                {}};
            set_speed(change, wire, factor);
            changes_.push_back(std::move(change));
        }
    }

    void add_bus_times(Change::Of of, const std::string& what, const std::map<std::string, const Node*>& buses) {
        for (const Factor& factor : factors) {
            Change change{of, what, factor.faster, {}};
            for (const auto& [name, bus] : buses)
                for (const char* time : bus_times)
                    change.set[name + "." + time] = shorter(bus->integer(time), least_of(*bus, time), factor);
            changes_.push_back(std::move(change));
        }
    }

    static std::int64_t least_of(const Node& node, const char* attribute) {
        return static_cast<std::int64_t>(node.kind->attribute(attribute)->value.least.value_or(0));
    }

    static bool is_bus(const Node& node) {
        return std::ranges::all_of(bus_times, [&](const char* time) { return node.attributes.contains(time); });
    }

    void add_buses() {
        std::map<std::string, const Node*> buses;
        for (const Node& node : network_.nodes)
            if (is_bus(node))
                buses[node.name] = &node;
        if (buses.size() > 1)
            add_bus_times(Change::Of::all, "all buses", buses);
        for (const std::string& name :
             busiest(most_alone_, report_.buses, std::mem_fn(&BusUse::name), std::mem_fn(&BusUse::busy)))
            if (auto bus = buses.find(name); bus != buses.end())
                add_bus_times(Change::Of::alone, "bus " + name, {*bus});
    }

    static bool is_cost(const std::string& name) {
        return name == "channelcall" || name == "conversion" || name.find("bytes") != std::string::npos ||
               (name.find("cycles") != std::string::npos && name != memory_cycles && name != router_cycles);
    }

    static std::optional<std::int64_t> cost_of(const std::string& name, const Value& value) {
        const auto* integer = std::get_if<std::int64_t>(&value);
        return integer && is_cost(name) && *integer > 0 ? std::optional(*integer) : std::nullopt;
    }

    /// Adds changes that reduce the computing time of a process: reductions of its parameters in cycles. REQUIRES: the
    /// process shares its processor with others. If it is alone on its processor, a faster clock has the same effect.
    void add_process(const ProcessInstance& process) {
        for (const Factor& factor : factors) {
            Change change{Change::Of::alone, "what " + process.name + " computes", factor.less, {}};
            for (const auto& [name, value] : process.parameters)
                if (auto cost = cost_of(name, value); cost && name.find("cycles") != std::string::npos)
                    set_less(change, process.name + "." + name, *cost, factor);
            if (!change.set.empty())
                changes_.push_back(std::move(change));
        }
    }

    bool shares_processor(const ProcessInstance& process) const {
        return process.node != nowhere &&
               std::ranges::count(network_.processes, process.node, &ProcessInstance::node) > 1;
    }

    void add_processes() {
        std::map<std::string, Time> busy;
        for (const ProcessorUse& processor : report_.processors)
            busy[processor.name] = processor.busy;
        auto name = [](const ProcessInstance& process) { return process.name; };
        auto spent = [&](const ProcessInstance& process) {
            return shares_processor(process) ? busy[network_.nodes[process.node].name] : Time{0};
        };
        std::vector<std::string> names = busiest(most_alone_, network_.processes, name, spent);
        for (const ProcessInstance& process : network_.processes)
            if (std::ranges::find(names, process.name) != names.end())
                add_process(process);
    }

    /// Adds the setting of a reduced constant, unless rounding cancels the reduction, such as a tenth less than 4
    /// cycles.
    static void set_less(Change& change, const std::string& key, std::int64_t cost, const Factor& factor) {
        if (std::string lesser = less(cost, factor); lesser != std::to_string(cost))
            change.set[key] = lesser;
    }

    /// A constant: its value for each node or process in which it costs time, and the number of nodes and processes
    /// that have it with any value.
    struct Costs {
        std::map<std::string, std::int64_t> by_owner;
        std::size_t owners = 0;

        /// Returns whether it has the same value wherever it occurs.
        bool is_equal_everywhere() const {
            return owners == by_owner.size() && std::ranges::all_of(by_owner, [this](const auto& each) {
                       return each.second == by_owner.begin()->second;
                   });
        }
    };

    template <class Map>
    static void note_costs(const std::string& owner, const Map& values, std::map<std::string, Costs>& costs) {
        for (const auto& [name, value] : values) {
            ++costs[name].owners;
            if (auto cost = cost_of(name, value))
                costs[name].by_owner[owner] = *cost;
        }
    }

    void add_constants() {
        std::map<std::string, Costs> costs;
        for (const Node& node : network_.nodes)
            note_costs(node.name, node.attributes, costs);
        for (const ProcessInstance& process : network_.processes)
            note_costs(process.name, process.parameters, costs);
        for (const auto& [name, by_owner] : costs)
            for (const Factor& factor : factors)
                add_constant(name, by_owner, factor);
    }

    /// Adds the change of a constant. If the constant is equal everywhere, one setting changes all values; otherwise
    /// each node or process gets its own setting.
    void add_constant(const std::string& name, const Costs& costs, const Factor& factor) {
        const bool same = costs.is_equal_everywhere();
        Change change{Change::Of::constant, name, factor.less, {}};
        for (const auto& [owner, cost] : costs.by_owner)
            set_less(change, key_of(owner, name, same), cost, factor);
        if (!change.set.empty())
            changes_.push_back(std::move(change));
    }

    /// Returns whether the netlist with these settings declares more processes or processors. Returns true also for a
    /// netlist that is refused, because the refusal tells the user why there cannot be more.
    bool makes_more(const Overrides& set) const {
        Declared then = declared_(set);
        return then.processes > now_.processes || then.processors > now_.processors;
    }

    void add_vals() {
        constexpr std::size_t most_digits = 9;
        for (const auto& [name, expression] : vals_) {
            const auto value = parse_number<std::int64_t>(expression);
            if (!value || expression.size() > most_digits)
                continue;
            Overrides more{{name, std::to_string(*value + 1)}};
            if (makes_more(more))
                changes_.push_back({Change::Of::number, "one more of " + name + ":",
                                    fmt::format("{} instead of {}", *value + 1, *value), more});
        }
    }

    const Network& network_;
    const RunReport& report_;
    const DeclaredWith& declared_;
    const Declared now_;
    const std::map<std::string, std::string> vals_ = stated_vals(network_);
    const std::size_t most_alone_ = network_.nodes.size() > most_nodes_in_full ? most_alone_of_many : most_alone;
    std::vector<Change> changes_;
    std::set<std::set<std::size_t>> clocks_known_;
    std::set<const LinkConnection*> links_known_;
};

} // namespace

std::vector<Change> changes_of(const Network& network, const RunReport& report, const DeclaredWith& declared) {
    return Changes(network, report, declared).all();
}

} // namespace placedpar
