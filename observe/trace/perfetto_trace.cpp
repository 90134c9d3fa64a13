#include "observe/trace/perfetto_trace.hpp"

#include "text/utf8.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

std::string json_text(const std::string& text) { return as_json(boost::json::serialize(boost::json::string(text))); }

/// Prints a time in microseconds, the format's unit, with six decimals, which keep every picosecond.
std::string microseconds(Time t) {
    constexpr std::int64_t picoseconds = 1'000'000;
    return fmt::format("{}.{:06}", t.count() / picoseconds, t.count() % picoseconds);
}

/// Returns the names of the partners. If a partner is not known yet, the name of the channel stands in its place.
std::string partners_of(const Slice& slice, const char* joined_by) {
    std::vector<std::string> partners;
    for (const Awaited& awaited : slice.awaited)
        partners.push_back(awaited.partner.empty() ? awaited.channel : awaited.partner);
    return fmt::format("{}", fmt::join(partners, joined_by));
}

/// Returns the name of an alternation. More than three partners are listed only among the arguments.
std::string name_of_alternation(const Slice& slice) {
    constexpr std::size_t most_named = 3;
    std::size_t count = slice.awaited.size();
    std::string name = count > most_named ? fmt::format("alternates between {} channels", count)
                                          : "alternates: input from " + partners_of(slice, " or ");
    return count == 0 ? "waits for its timer" : name + (slice.awaits_timer ? ", or its timer" : "");
}

/// Returns the name of an input. A process of the machine that has no packet to send waits on no channel.
std::string name_of_input(const Slice& slice) {
    return slice.awaited.empty() ? "waits for packets to send" : "inputs from " + partners_of(slice, " ");
}

/// Category and name of a slice in a viewer, which derives the colour from the name.
struct Shown {
    const char* category;
    std::string name;
};

Shown shown(const Slice& slice) {
    switch (slice.activity) {
    case Activity::executing: return {"processor", slice.subject};
    case Activity::carrying: return {"link", slice.subject};
    case Activity::ready: return {"ready", "waits for its processor"};
    case Activity::computing: return {"compute", "computes"};
    case Activity::delayed: return {"wait", "waits for its timer"};
    case Activity::outputting: return {"wait", "outputs to " + partners_of(slice, " ")};
    case Activity::inputting: return {"wait", name_of_input(slice)};
    case Activity::alternating: return {"wait", name_of_alternation(slice)};
    case Activity::joining: return {"wait", "waits for its components"};
    case Activity::after_work: return {"wait", "waits for the end of the work"};
    case Activity::stopped: return {"wait", "has stopped"};
    case Activity::halted:
    case Activity::ended:
    case Activity::starting:
    case Activity::moving:
    case Activity::arbitrating: break;
    }
    throw std::logic_error("a slice has an activity that no track shows");
}

std::string described(const Awaited& awaited) {
    return fmt::format(R"({{"channel":{},"partner":{}}})", json_text(awaited.channel),
                       json_text(awaited.partner.empty() ? "none yet" : awaited.partner));
}

/// Returns the slice's arguments: the bytes that a link carries, or the channels of a wait. Returns "" for a slice
/// without arguments.
std::string arguments(const Slice& slice) {
    if (slice.activity == Activity::carrying && !slice.open)
        return fmt::format(R"({{"bytes":{}}})", slice.bytes);
    if (slice.awaited.empty())
        return "";
    if (slice.activity != Activity::alternating)
        return described(slice.awaited.front());
    std::vector<std::string> channels;
    for (const Awaited& awaited : slice.awaited)
        channels.push_back(described(awaited));
    return fmt::format(R"({{"channels":[{}]}})", fmt::join(channels, ","));
}

std::string name_of(const Track& track) {
    return (track.place.kind == Track::Kind::processor ? "processor " : "") + track.name;
}

} // namespace

PerfettoTrace::PerfettoTrace(OutputFile& file, const Tracks& tracks) : file_(file), tracks_(tracks) {
    file_.write("{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n");
}

void PerfettoTrace::add(const std::string& event) {
    if (!std::exchange(is_first_, false))
        file_.write(",\n");
    file_.write(event);
}

/// Returns the numbers of the track's process and thread in the format. The numbers are above 0, because viewers
/// reserve 0. All numbers are different, because a thread with the number of its process would be drawn first.
std::string PerfettoTrace::place(std::size_t track) const {
    return fmt::format(R"("pid":{},"tid":{})", tracks_.all()[track].place.node + 1, tracks_.nodes().size() + 1 + track);
}

void PerfettoTrace::write(const Slice& slice) {
    const auto [category, name] = shown(slice);
    std::string event = fmt::format(R"({{"ph":"{}","name":{},"cat":"{}",{},"ts":{})", slice.open ? 'B' : 'X',
                                    json_text(name), category, place(slice.track), microseconds(slice.begin));
    if (!slice.open)
        event += fmt::format(R"(,"dur":{})", microseconds(slice.end - slice.begin));
    if (std::string more = arguments(slice); !more.empty())
        event += R"(,"args":)" + more;
    add(event + "}");
}

void PerfettoTrace::write(const MessageArrow& arrow) {
    std::string common = fmt::format(R"("name":{},"cat":"message","id":{})", json_text(arrow.channel), ++arrows_);
    add(fmt::format(R"({{"ph":"s",{},{},"ts":{}}})", common, place(arrow.from), microseconds(arrow.left)));
    add(fmt::format(R"({{"ph":"f","bp":"e",{},{},"ts":{}}})", common, place(arrow.to), microseconds(arrow.arrived)));
}

/// Returns the numbers for a thread of the critical path, which follow the numbers of all tracks; thread 0 has the
/// whole path.
std::string PerfettoTrace::place_on_path(std::size_t thread) const {
    std::size_t pid = tracks_.nodes().size() + tracks_.all().size() + 1;
    return fmt::format(R"("pid":{},"tid":{})", pid, pid + 1 + thread);
}

void PerfettoTrace::write_part(const PathPart& part, std::size_t thread) {
    add(fmt::format(R"({{"ph":"X","name":{},"cat":"critical path","cname":"terrible",{},"ts":{},"dur":{}}})",
                    json_text(name_on_path(part.activity, part.subject)), place_on_path(thread),
                    microseconds(part.begin), microseconds(part.end - part.begin)));
}

/// Writes a flow from the last picosecond of one part to the first picosecond of the next part.
void PerfettoTrace::write_step(const PathPart& from, std::size_t from_thread, const PathPart& to,
                               std::size_t to_thread) {
    std::string common = fmt::format(R"("name":"critical path","cat":"critical path","id":{})", ++arrows_);
    add(fmt::format(R"({{"ph":"s",{},{},"ts":{}}})", common, place_on_path(from_thread),
                    microseconds(from.end - Time{1})));
    add(fmt::format(R"({{"ph":"f","bp":"e",{},{},"ts":{}}})", common, place_on_path(to_thread),
                    microseconds(to.begin)));
}

void PerfettoTrace::draw_path(std::span<const PathPart> path) {
    auto thread = [this](const PathPart& part) { return tracks_.of_place(part.place) + 1; }; // 0 for no place
    const PathPart* before = nullptr;
    for (const PathPart& part : path) {
        write_part(part, 0);
        if (thread(part) == 0)
            continue;
        write_part(part, thread(part));
        if (before && thread(*before) != thread(part))
            write_step(*before, thread(*before), part, thread(part));
        before = &part;
    }
    if (!path.empty())
        write_path_names(path);
}

/// Writes the names of the path's threads, in the order in which the tracks of their places are drawn.
void PerfettoTrace::write_path_names(std::span<const PathPart> path) {
    std::set<std::size_t> places;
    for (const PathPart& part : path)
        places.insert(tracks_.of_place(part.place));
    places.erase(Tracks::none);
    add_name("process_name", place_on_path(0), R"("name":"critical path")");
    add_name("process_sort_index", place_on_path(0), R"("sort_index":-1)");
    add_name("thread_name", place_on_path(0), R"("name":"all of it")");
    add_name("thread_sort_index", place_on_path(0), R"("sort_index":0)");
    for (std::size_t order = 1; std::size_t track : tracks_.drawn())
        if (places.contains(track)) {
            add_name("thread_name", place_on_path(track + 1),
                     R"("name":)" + json_text("via " + name_of(tracks_.all()[track])));
            add_name("thread_sort_index", place_on_path(track + 1), fmt::format(R"("sort_index":{})", order++));
        }
}

void PerfettoTrace::add_name(const char* what, const std::string& where, const std::string& value) {
    add(fmt::format(R"({{"ph":"M","name":"{}",{},"args":{{{}}}}})", what, where, value));
}

void PerfettoTrace::finish(Time begin, Time end, const std::string& why) {
    if (tracks_.all().empty())
        return file_.write("\n]}\n");
    add(fmt::format(R"({{"ph":"i","s":"g","name":{},"cat":"end",{},"ts":{}}})", json_text(why), place(0),
                    microseconds(std::max(begin, end))));
    write_names();
    file_.write("\n]}\n");
}

void PerfettoTrace::write_names() {
    std::size_t last_node = Tracks::none, order = 0;
    for (std::size_t track : tracks_.drawn()) {
        std::size_t node = tracks_.all()[track].place.node;
        std::string where = place(track);
        auto say = [&](const char* what, const std::string& value) { add_name(what, where, value); };
        if (node != std::exchange(last_node, node)) {
            say("process_name", R"("name":)" + json_text(tracks_.nodes()[node]));
            say("process_sort_index", fmt::format(R"("sort_index":{})", node));
        }
        say("thread_name", R"("name":)" + json_text(name_of(tracks_.all()[track])));
        say("thread_sort_index", fmt::format(R"("sort_index":{})", order++));
    }
}

} // namespace placedpar
