#include "explore/explain/explanation.hpp"

#include "report/field.hpp"
#include "text/paint.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace placedpar {

namespace {

std::string percent(Time part, Time whole) {
    return whole == Time{0} ? "-" : fmt::format("{:.1f} %", 100 * in_milliseconds(part) / in_milliseconds(whole));
}

Table accounts_of(const Explanation& explanation) {
    return table_of(explanation.accounts, [](const std::pair<const std::string, Account>& each) -> Row {
        const auto& [process, account] = each;
        auto part = [life = account.life()](std::size_t width, const std::string& name, Time time, const char* key) {
            return Field::right(width, name, percent(time, life)).as(key, time.count());
        };
        boost::json::object waiting_for;
        for (const auto& [partner, time] : account.waiting_for)
            waiting_for[partner] = time.count();
        std::string partner = account.most_waited_for();
        if (!partner.empty())
            partner += fmt::format(" ({:.3f})", in_milliseconds(account.waiting_for.at(partner)));
        return {Field::left(0, "process", process).as("process"),
                part(9, "computing", account.computing, "computing_ps"),
                part(13, "communicating", account.communicating, "communicating_ps"),
                part(11, "for partner", account.waiting, "waiting_ps"),
                part(7, "ready", account.ready, "ready_ps"),
                part(7, "delayed", account.delayed, "delayed_ps"),
                Field::left(0, "most waited for (ms)", partner).as("waiting_for_ps", waiting_for)};
    });
}

std::string link_direction(const LinkUse& link) { return link.from + " -> " + link.to; }

Row use_of(const char* key, const std::string& name, std::size_t width, Time used, Time whole, const Field& waits) {
    return {Field::left(width, "processor, link or bus", name).as(key),
            Field::right(8, "busy", percent(used, whole)).as("busy_ps", used.count()),
            Field::right(8, "idle", percent(whole - used, whole)).as("idle_ps", (whole - used).count()), waits};
}

Field waits(const std::string& text) { return Field::right(7, "waits to", text); }

/// Returns the sum of the waiting times of all masters of a bus.
Time masters_waited(const BusUse& bus) {
    Time waited{};
    for (const BusMasterUse& master : bus.masters)
        waited += master.waited;
    return waited;
}

Time waited_to(const LinkUse& link, const Explanation& explanation) {
    auto found = explanation.waits_at_links.find(link_direction(link));
    return found == explanation.waits_at_links.end() ? Time{0} : found->second;
}

/// The rows that show how each part of the machine was used, by kind.
struct MachineRows {
    std::vector<Row> processors, links, buses;
};

MachineRows machine_of(const Explanation& explanation) {
    const RunReport& report = explanation.report;
    Time whole = report.result.time;
    std::size_t width = 24;
    for (const LinkUse& link : report.links)
        width = std::max(width, link_direction(link).size());
    MachineRows rows;
    for (const ProcessorUse& processor : report.processors)
        rows.processors.push_back(use_of("processor", processor.name, width, processor.busy, whole, waits("")));
    for (const LinkUse& link : report.links)
        if (Time waited = waited_to(link, explanation); link.bytes > 0)
            rows.links.push_back(use_of("link", link_direction(link), width, link.occupied, whole,
                                        waits(percent(waited, whole)).as("waits_to_ps", waited.count())));
    for (const BusUse& bus : report.buses) // the waits can exceed 100 %: several masters can wait at a time
        rows.buses.push_back(use_of("bus", bus.name, width, bus.busy, whole,
                                    waits("its masters waited " + percent(masters_waited(bus), whole))
                                        .as("masters_waited_ps", masters_waited(bus).count())));
    return rows;
}

std::string print_machine(const Explanation& explanation) {
    MachineRows rows = machine_of(explanation);
    Table table{use_of("", "", 24, {}, {}, waits("")), std::move(rows.processors)};
    for (std::vector<Row>* more : {&rows.links, &rows.buses})
        std::ranges::move(*more, std::back_inserter(table.rows));
    return table.text("\n");
}

/// Prints the rows with the greatest times, and the sum of the other rows.
std::string print_shares(const std::vector<PathShare>& shares, std::size_t most, Time whole) {
    Time rest = whole;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, shares.size()); ++i) {
        rest -= shares[i].time;
        out += fmt::format("{:>12.6f}  {:>7}  {}\n", in_milliseconds(shares[i].time), percent(shares[i].time, whole),
                           name_of(shares[i]));
    }
    if (shares.size() > most)
        out += fmt::format("{:>12.6f}  {:>7}  {} more\n", in_milliseconds(rest), percent(rest, whole),
                           shares.size() - most);
    return out;
}

std::string path_heading(const std::string& title) {
    return painted(Paint::heading, fmt::format("\n{:>12}  {:>7}  {}\n", "ms", "share", title));
}

std::string why_not_kept() {
    return fmt::format("it has more than {} parts; end the run earlier with --until, or shorten it with --set",
                       most_path_points);
}

std::string print_path(const Explanation& explanation) {
    if (explanation.path_too_long)
        return fmt::format("\ncritical path: too long to keep: {}\n", why_not_kept());
    Time whole = explanation.report.result.time;
    std::vector<PathShare> by_array = shares_by_array(explanation.path), alone = shares_of(explanation.path);
    std::string out = path_heading("critical path") + print_shares(by_array, 12, whole);
    out +=
        fmt::format("{:>12.6f}  {:>7}  sum, which equals the length of the run\n", in_milliseconds(whole), "100.0 %");
    if (alone.size() > by_array.size())
        out += path_heading("longest parts of the path") + print_shares(alone, 8, whole);
    return out;
}

std::string settings(const Overrides& set) {
    if (set.size() > 3)
        return fmt::format("--set {}={} and {} more", set.begin()->first, set.begin()->second, set.size() - 1);
    std::string out;
    for (const auto& [name, value] : set)
        out += fmt::format("{}--set {}={}", out.empty() ? "" : " ", name, value);
    return out;
}

std::string name_of(const Change& change) { return change.what + " " + change.change; }

std::string print_answer(const Answer& answer, Time whole) {
    std::string result =
        answer.completed()
            ? fmt::format("{:>12.6f}  {:>8}", in_milliseconds(answer.time), percent(whole - answer.time, whole))
            : fmt::format("{:>22}", answer.refused.empty() ? name_of(answer.outcome) : "refused");
    std::string out = fmt::format("{}  {}  [{}]\n", result, name_of(answer.change), settings(answer.change.set));
    return answer.why.empty() ? out : out + fmt::format("{:>24}slower by {}\n", "", answer.why);
}

std::string remark_on_slower(bool any) {
    return any ? "A run can be slower although a part is faster or more processes share the work: messages then arrive "
                 "in another\norder, and the users of a shared processor, link or bus take turns in another order "
                 "(Graham's anomaly, Braess's\nparadox).\n"
               : "";
}

/// Prints the greatest gains, then all changes that make the run slower, and the number of changes that make hardly any
/// difference.
std::string print_answers(const Explanation& explanation) {
    constexpr std::size_t most = 24;
    Time whole = explanation.report.result.time;
    if (!explanation.not_tried.empty())
        return fmt::format("\nwhat if: no change of the machine was tried: {}\n", explanation.not_tried);
    if (explanation.answers.empty())
        return "";
    std::string out = painted(Paint::heading, fmt::format("\n{:>12}  {:>8}  {}\n", "ms", "gain", "what if"));
    std::size_t gains = 0, same = 0;
    bool slower = false;
    for (const Answer& answer : explanation.answers) {
        bool gains_here = answer.completed() && answer.time < whole;
        if (!differs(answer, whole))
            ++same;
        else if (!gains_here || ++gains <= most)
            out += print_answer(answer, whole);
        slower = slower || (differs(answer, whole) && !answer.why.empty());
    }
    if (gains > most)
        out += fmt::format("changes that gain less than these: {} (--json lists all)\n", gains - most);
    if (same > 0)
        out += fmt::format("changes that make a difference of less than 0.1 %: {}\n", same);
    if (explanation.left_out > 0)
        out +=
            fmt::format("changes that were not tried, because the command was interrupted: {}\n", explanation.left_out);
    return out + remark_on_slower(slower);
}

/// Returns whether the change shortens the run by at least 0.1 %.
bool gains(const Answer& answer, Time whole) {
    return answer.completed() && answer.time < whole && differs(answer, whole);
}

std::string print_gain(const Answer& answer, Time whole) {
    return fmt::format("  {}: {} less time\n", name_of(answer.change), percent(whole - answer.time, whole));
}

/// Prints how the critical path is divided among activities: "computing 97.6 %, communicating 2.4 %". Leaves out
/// activities with less than a thousandth of the run.
std::string print_kinds_of_time(const Explanation& explanation) {
    Time whole = explanation.report.result.time;
    std::string out;
    for (const PathShare& share : shares_by_activity(explanation.path))
        if (share.time >= whole / 1000)
            out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name_on_path(share.activity),
                               percent(share.time, whole));
    return out.empty() ? "" : fmt::format("  on the critical path: {}\n", out);
}

/// The groups of changes: everything of a kind faster, a single part faster, more processes or processors, the fastest
/// links. The verdict names the best change of each group.
enum class Group { everything, part, number, links, none };

Group group_of(const Change& change) {
    if (change.of == Change::Of::number)
        return Group::number;
    if (change.what == "all links" && change.change == "as fast as can be")
        return Group::links;
    if (change.change != "twice as fast" || change.of == Change::Of::constant)
        return Group::none;
    return change.of == Change::Of::all ? Group::everything : Group::part;
}

/// Prints the activities on the critical path, then the changes with gains, the greatest gain first. Prints only the
/// best change of each of three groups: all parts of a kind twice as fast; a single part twice as fast; links as fast
/// as the language allows. Also prints each number of processes or processors that shortens the run if it is raised by
/// one.
std::string print_verdict(const Explanation& explanation) {
    Time whole = explanation.report.result.time;
    std::string out = print_kinds_of_time(explanation);
    std::set<Group> printed{Group::none};
    for (const Answer& answer : explanation.answers) // the greatest gain first
        if (Group group = group_of(answer.change); gains(answer, whole) && !printed.contains(group)) {
            out += print_gain(answer, whole);
            if (group != Group::number)
                printed.insert(group);
        }
    return out.empty() ? "" : painted(Paint::heading, "what holds it back\n") + out;
}

boost::json::object answer_json(const Answer& answer) {
    boost::json::object set;
    for (const auto& [name, value] : answer.change.set)
        set[name] = value;
    boost::json::object json{{"what", name_of(answer.change)}, {"set", std::move(set)}};
    if (!answer.refused.empty()) {
        json["refused"] = answer.refused;
        return json;
    }
    json["ended"] = name_of(answer.outcome);
    json["time_ps"] = answer.time.count();
    if (!answer.why.empty())
        json["slower_by"] = answer.why;
    return json;
}

} // namespace

std::string print_explanation(const Explanation& explanation, const Network& network) {
    const RunResult& result = explanation.report.result;
    return fmt::format("{}: {} at {}\n", network.source_path, name_of(explanation.report.outcome()),
                       to_string(result.time)) +
           print_verdict(explanation) + print_path(explanation) + print_answers(explanation) +
           accounts_of(explanation).text("\n") + print_machine(explanation);
}

boost::json::object explanation_json(const Explanation& explanation, const Network& network) {
    boost::json::array path, answers;
    for (const PathPart& part : explanation.path)
        path.push_back(boost::json::object{{"step", name_on_path(part.activity)},
                                           {"subject", part.subject},
                                           {"begin_ps", part.begin.count()},
                                           {"end_ps", part.end.count()}});
    for (const Answer& answer : explanation.answers)
        answers.push_back(answer_json(answer));
    const RunResult& result = explanation.report.result;
    const MachineRows machine = machine_of(explanation);
    boost::json::object json{{"netlist", network.source_path},
                             {"ended", name_of(explanation.report.outcome())},
                             {"time_ps", result.time.count()},
                             {"processes", json_of(accounts_of(explanation).rows)},
                             {"processors", json_of(machine.processors)},
                             {"links", json_of(machine.links)},
                             {"buses", json_of(machine.buses)},
                             {"critical_path", std::move(path)},
                             {"what_if", std::move(answers)}};
    if (explanation.path_too_long)
        json["not_kept"] = why_not_kept();
    if (!explanation.not_tried.empty())
        json["not_tried"] = explanation.not_tried;
    return json;
}

} // namespace placedpar
