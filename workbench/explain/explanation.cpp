#include "workbench/explain/explanation.hpp"

#include "text/paint.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

std::string percent(Time part, Time whole) {
    return whole == Time{0} ? "-" : fmt::format("{:.1f} %", 100 * in_milliseconds(part) / in_milliseconds(whole));
}

template <class Map, class Name>
std::size_t width_of_names(const Map& rows, Name name, std::size_t least) {
    for (const auto& row : rows)
        least = std::max(least, name(row).size());
    return least;
}

std::string print_accounts(const Explanation& explanation) {
    auto name = [](const auto& each) { return each.first; };
    std::size_t width = width_of_names(explanation.accounts, name, 7);
    std::string out = painted(
        Paint::heading, fmt::format("\n{:<{}}  {:>9}  {:>13}  {:>7}  {:>7}  {:>7}  most waited for (ms)\n", "process",
                                    width, "computing", "communicating", "waiting", "ready", "delayed"));
    for (const auto& [process, account] : explanation.accounts) {
        std::string partner = account.most_waited_for();
        out += fmt::format(
            "{:<{}}  {:>9}  {:>13}  {:>7}  {:>7}  {:>7}{}\n", process, width,
            percent(account.computing, account.life()), percent(account.communicating, account.life()),
            percent(account.waiting, account.life()), percent(account.ready, account.life()),
            percent(account.delayed, account.life()),
            partner.empty() ? ""
                            : fmt::format("  {} ({:.3f})", partner, in_milliseconds(account.waiting_for.at(partner))));
    }
    return out;
}

std::string print_use(const std::string& name, std::size_t width, Time used, Time whole) {
    return fmt::format("{:<{}}  {:>8}  {:>8}\n", name, width, percent(used, whole), percent(whole - used, whole));
}

std::string link_direction(const LinkUse& link) { return link.from + " -> " + link.to; }

std::string print_machine(const RunReport& report) {
    std::size_t width = width_of_names(report.links, link_direction, 24);
    std::string out = painted(Paint::heading,
                              fmt::format("\n{:<{}}  {:>8}  {:>8}\n", "processor, link or bus", width, "busy", "idle"));
    for (const ProcessorUse& processor : report.processors)
        out += print_use(processor.name, width, processor.busy, report.result.time);
    for (const LinkUse& link : report.links)
        if (link.bytes > 0)
            out += print_use(link_direction(link), width, link.occupied, report.result.time);
    for (const BusUse& bus : report.buses)
        out += print_use(bus.name, width, bus.busy, report.result.time);
    return out;
}

std::string print_path(const Explanation& explanation) {
    constexpr std::size_t most = 20;
    Time whole = explanation.report.result.time, rest{};
    std::string out = painted(Paint::heading, fmt::format("\n{:>12}  {:>7}  {}\n", "ms", "share", "critical path"));
    std::vector<PathShare> shares = shares_of(explanation.path);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (i < most)
            out += fmt::format("{:>12.6f}  {:>7}  {}{}{}\n", in_milliseconds(shares[i].time),
                               percent(shares[i].time, whole), name_of(shares[i].step),
                               shares[i].subject.empty() ? "" : ": ", shares[i].subject);
        else
            rest += shares[i].time;
    if (rest > Time{0})
        out += fmt::format("{:>12.6f}  {:>7}  {} more\n", in_milliseconds(rest), percent(rest, whole),
                           shares.size() - most);
    return out + fmt::format("{:>12.6f}  {:>7}  in all: the run's length to the picosecond\n", in_milliseconds(whole),
                             "100.0 %");
}

/// Why, as far as the run says it.
std::string remark(const Answer& answer, Time whole) {
    if (answer.ending != Ending::completed)
        return fmt::format("  ({})", name_of(answer.ending));
    return answer.time > whole ? "  (slower: see below)" : "";
}

std::string settings(const Overrides& set) {
    if (set.size() > 2)
        return fmt::format("--set {}={} and {} more", set.begin()->first, set.begin()->second, set.size() - 1);
    std::string out;
    for (const auto& [name, value] : set)
        out += fmt::format("{}--set {}={}", out.empty() ? "" : " ", name, value);
    return out;
}

/// Changes that make hardly a difference are only counted.
std::string print_answers(const Explanation& explanation) {
    Time whole = explanation.report.result.time;
    if (explanation.answers.empty())
        return "";
    std::string out = painted(Paint::heading, fmt::format("\n{:>12}  {:>8}  {}\n", "ms", "gain", "what if"));
    std::size_t same = 0;
    bool slower = false;
    for (const Answer& answer : explanation.answers) {
        bool differs = std::chrono::abs(answer.time - whole) >= whole / 1000;
        same += !differs;
        slower = slower || (differs && answer.time > whole);
        if (differs)
            out += fmt::format("{:>12.6f}  {:>8}  {}{}  [{}]\n", in_milliseconds(answer.time),
                               percent(whole - answer.time, whole), answer.change.what, remark(answer, whole),
                               settings(answer.change.set));
    }
    if (same > 0)
        out += fmt::format("{} more make a difference of less than 0.1 %\n", same);
    if (slower)
        out += "Slower though a part is faster: messages then come in another order, and what has to share a processor "
               "or a\n"
               "link takes turns in another order (Graham's anomaly, Braess's paradox); or more processes share the "
               "work.\n";
    return out;
}

boost::json::object account_json(const std::string& process, const Account& account) {
    boost::json::object waiting_for;
    for (const auto& [partner, time] : account.waiting_for)
        waiting_for[partner] = time.count();
    return {{"process", process},
            {"computing_ps", account.computing.count()},
            {"communicating_ps", account.communicating.count()},
            {"waiting_ps", account.waiting.count()},
            {"ready_ps", account.ready.count()},
            {"delayed_ps", account.delayed.count()},
            {"waiting_for_ps", std::move(waiting_for)}};
}

boost::json::object answer_json(const Answer& answer) {
    boost::json::object set;
    for (const auto& [name, value] : answer.change.set)
        set[name] = value;
    return {{"what", answer.change.what},
            {"set", std::move(set)},
            {"ended", name_of(answer.ending)},
            {"time_ps", answer.time.count()}};
}

} // namespace

std::string print_explanation(const Explanation& explanation, const Network& network) {
    const RunResult& result = explanation.report.result;
    return fmt::format("{}: {} at {}\n", network.source_path, name_of(result.ending), to_string(result.time)) +
           print_path(explanation) + print_answers(explanation) + print_accounts(explanation) +
           print_machine(explanation.report);
}

boost::json::object explanation_json(const Explanation& explanation, const Network& network) {
    boost::json::array accounts, path, answers;
    for (const auto& [process, account] : explanation.accounts)
        accounts.push_back(account_json(process, account));
    for (const PathPart& part : explanation.path)
        path.push_back(boost::json::object{{"step", name_of(part.step)},
                                           {"subject", part.subject},
                                           {"begin_ps", part.begin.count()},
                                           {"end_ps", part.end.count()}});
    for (const Answer& answer : explanation.answers)
        answers.push_back(answer_json(answer));
    const RunResult& result = explanation.report.result;
    return {{"netlist", network.source_path},   {"ended", name_of(result.ending)},  {"time_ps", result.time.count()},
            {"processes", std::move(accounts)}, {"critical_path", std::move(path)}, {"what_if", std::move(answers)}};
}

} // namespace placedpar
