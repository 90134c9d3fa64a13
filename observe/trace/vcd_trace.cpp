#include "observe/trace/vcd_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace placedpar {

namespace {

/// The activities of a process that have a wire. Waiting for components has no wire, because the activities of the
/// components are on the wires of their process.
constexpr std::pair<Activity, const char*> wires_of_a_process[] = {
    {Activity::computing, "computes"},     {Activity::ready, "ready"},
    {Activity::inputting, "inputs"},       {Activity::outputting, "outputs"},
    {Activity::alternating, "alternates"}, {Activity::delayed, "delayed"},
    {Activity::after_work, "after_work"},  {Activity::stopped, "stopped"},
};

/// The number of wires that are reserved for each track: one for each activity. Most of these wires are not used.
constexpr std::uint32_t wires_of_a_track = 16;

std::uint32_t wire_of(std::size_t track, Activity activity) {
    return static_cast<std::uint32_t>(track) * wires_of_a_track + static_cast<std::uint32_t>(activity);
}

/// Returns the wire's code: its number, with the characters from `!` to `~` as digits.
std::string code_of(std::uint32_t wire) {
    constexpr std::uint32_t characters = '~' - '!' + 1;
    std::string code;
    do {
        code += static_cast<char>('!' + wire % characters);
        wire /= characters;
    } while (wire > 0);
    return code;
}

/// Returns the name as an identifier of letters, digits and _: "t_0_link_1_u_link_0" for "t[0].link[1] -> u.link[0]".
std::string identifier(const std::string& name) {
    std::string result;
    for (char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            result += c;
        else if (!result.empty() && result.back() != '_')
            result += '_';
    while (!result.empty() && result.back() == '_')
        result.pop_back();
    return result.empty() || std::isdigit(static_cast<unsigned char>(result[0])) ? "_" + result : result;
}

/// Makes the names of one scope unique.
class ScopeNames {
public:
    /// Returns an unused identifier for the name. A number distinguishes names such as `a[1]` and `a_1`, which would
    /// give the same identifier.
    std::string take(const std::string& name) {
        std::string plain = identifier(name), unique = plain;
        for (int number = 2; !taken_.insert(unique).second; ++number)
            unique = fmt::format("{}_{}", plain, number);
        return unique;
    }

private:
    std::set<std::string> taken_;
};

std::string scope(const std::string& name) { return "$scope module " + name + " $end\n"; }

const std::string& name_in_scope(const Track& track) {
    static const std::string busy = "busy";
    return track.place.kind == Track::Kind::processor ? busy : track.name;
}

constexpr const char* end_of_scope = "$upscope $end\n";

} // namespace

VcdTrace::VcdTrace(OutputFile& file, const Tracks& tracks) : file_(file), tracks_(tracks) {}

void VcdTrace::write(const Slice& slice) {
    if (slice.activity == Activity::joining)
        return;
    std::uint32_t wire = wire_of(tracks_.all()[slice.track].outermost, slice.activity);
    changes_.push_back({slice.begin, wire, 1});
    if (!slice.open)
        changes_.push_back({slice.end, wire, -1});
}

void VcdTrace::finish(Time begin, Time end, const std::string& why) {
    file_.write("$version PlacedPar $end\n$timescale 1 ps $end\n");
    file_.write(fmt::format("$comment {} at {} $end\n", why, to_string(end)));
    declare();
    write_changes(begin, end);
}

void VcdTrace::declare() {
    file_.write(scope("machine"));
    std::size_t last_node = Tracks::none;
    ScopeNames nodes, names;
    for (std::size_t number : tracks_.drawn()) {
        const Track& track = tracks_.all()[number];
        if (track.outermost != number)
            continue;
        if (std::size_t before = std::exchange(last_node, track.place.node); before != last_node) {
            file_.write(before == Tracks::none ? "" : end_of_scope);
            file_.write(scope(nodes.take(tracks_.nodes()[last_node])));
            names = {};
        }
        declare(number, track.place.kind, names.take(name_in_scope(track)));
    }
    file_.write(last_node == Tracks::none ? "" : end_of_scope);
    file_.write(fmt::format("{}$enddefinitions $end\n", end_of_scope));
}

void VcdTrace::declare(std::size_t track, Track::Kind kind, const std::string& name) {
    if (kind == Track::Kind::processor || kind == Track::Kind::bus)
        return declare_wire(wire_of(track, Activity::executing), name);
    if (kind == Track::Kind::link)
        return declare_wire(wire_of(track, Activity::carrying), name);
    file_.write(scope(name));
    for (const auto& [activity, wire_name] : wires_of_a_process)
        declare_wire(wire_of(track, activity), wire_name);
    file_.write(end_of_scope);
}

void VcdTrace::declare_wire(std::uint32_t number, const std::string& name) {
    wires_[number];
    file_.write(fmt::format("$var wire 1 {} {} $end\n", code_of(number), name));
}

void VcdTrace::write_changes(Time begin, Time end) {
    std::ranges::stable_sort(changes_, {}, &Change::at);
    auto next = changes_.cbegin();
    next = make_changes(next, begin);
    file_.write(fmt::format("#{}\n$dumpvars\n", begin.count()));
    for (auto& [number, wire] : wires_)
        file_.write(value_change(number, wire));
    file_.write("$end\n");
    while (next != changes_.cend() && next->at < end)
        next = write_moment(next);
    make_changes(next, end);
    file_.write(fmt::format("#{}\n", end.count()));
    for (auto& [number, wire] : wires_)
        if (wire.is_on() != wire.shown)
            file_.write(value_change(number, wire));
}

/// Applies the changes up to and including `until`. Returns the first later change.
VcdTrace::Changes::const_iterator VcdTrace::make_changes(Changes::const_iterator next, Time until) {
    for (; next != changes_.cend() && next->at <= until; ++next)
        wires_[next->wire].tracks += next->by;
    return next;
}

/// Writes the changes of one time. A wire changes at most once at a time, so an activity that takes no time is
/// invisible.
VcdTrace::Changes::const_iterator VcdTrace::write_moment(Changes::const_iterator first) {
    auto next = make_changes(first, first->at);
    std::string changes;
    for (auto change = first; change != next; ++change)
        if (Wire& wire = wires_[change->wire]; wire.is_on() != wire.shown)
            changes += value_change(change->wire, wire);
    if (!changes.empty())
        file_.write(fmt::format("#{}\n{}", first->at.count(), changes));
    return next;
}

std::string VcdTrace::value_change(std::uint32_t number, Wire& wire) {
    wire.shown = wire.is_on();
    return fmt::format("{:d}{}\n", wire.shown, code_of(number));
}

} // namespace placedpar
