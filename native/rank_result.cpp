#include "native/rank_result.hpp"

#include "runtime/packed_form.hpp"
#include "runtime/wait_cycle.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

namespace placedpar {

template <>
struct PackedForm<Measurement>
    : PackedMembers<Measurement, &Measurement::process, &Measurement::name, &Measurement::value, &Measurement::unit> {};
template <>
struct PackedForm<StuckProcess> : PackedMembers<StuckProcess, &StuckProcess::path, &StuckProcess::activity,
                                                &StuckProcess::channels, &StuckProcess::where> {};
template <>
struct PackedForm<StuckChannel> : PackedMembers<StuckChannel, &StuckChannel::name, &StuckChannel::outputter,
                                                &StuckChannel::inputter, &StuckChannel::waiting> {};
template <>
struct PackedForm<Deadlock> : PackedMembers<Deadlock, &Deadlock::processes, &Deadlock::channels> {};
template <>
struct PackedForm<RunResult>
    : PackedMembers<RunResult, &RunResult::ending, &RunResult::time, &RunResult::deadlock, &RunResult::never_ran> {};
template <>
struct PackedForm<native::Traffic>
    : PackedMembers<native::Traffic, &native::Traffic::messages, &native::Traffic::bytes> {};
template <>
struct PackedForm<native::RunPart>
    : PackedMembers<native::RunPart, &native::RunPart::result, &native::RunPart::measurements, &native::RunPart::waited,
                    &native::RunPart::rested, &native::RunPart::sent> {};
template <>
struct PackedForm<native::RankFailure> : PackedMembers<native::RankFailure, &native::RankFailure::time,
                                                       &native::RankFailure::is_defect, &native::RankFailure::text> {};
template <>
struct PackedForm<native::Notices>
    : PackedMembers<native::Notices, &native::Notices::all, &native::Notices::processes, &native::Notices::channels,
                    &native::Notices::awaited, &native::Notices::over, &native::Notices::full_at> {};
template <>
struct PackedForm<native::RankResult>
    : PackedMembers<native::RankResult, &native::RankResult::part, &native::RankResult::ends,
                    &native::RankResult::failure, &native::RankResult::notices, &native::RankResult::begun> {};

} // namespace placedpar

namespace placedpar::native {

namespace {

constexpr std::string_view no_user = "none yet";

/// Returns the users of the channels between ranks, by channel. Each rank knows only the user of its own end.
std::map<std::string_view, StuckChannel> users_between(const std::vector<RankResult>& results) {
    std::map<std::string_view, StuckChannel> users;
    for (const RankResult& result : results)
        for (const StuckChannel& end : result.ends) {
            StuckChannel& user = users.try_emplace(end.name, end).first->second;
            if (end.outputter != no_user)
                user.outputter = end.outputter;
            if (end.inputter != no_user)
                user.inputter = end.inputter;
        }
    return users;
}

std::string_view parent_of(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? "" : path.substr(0, slash);
}

/// Finds a cycle of processes that wait for each other in the tables of a joined report.
class WaitsInReport {
public:
    explicit WaitsInReport(const Deadlock& report) : report_(report) {
        for (std::size_t i = 0; i < report.processes.size(); ++i)
            processes_.emplace(report.processes[i].path, i);
        for (const StuckChannel& channel : report.channels)
            channels_.emplace(channel.name, &channel);
    }

    std::vector<std::string> cycle() const {
        std::vector<std::size_t> all(report_.processes.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = i;
        const auto awaited = [this](std::size_t process) { return awaited_by(process); };
        std::vector<std::string> paths;
        for (const std::size_t process : CycleSearch<std::size_t, decltype(awaited)>(awaited).find(all))
            paths.push_back(report_.processes[process].path);
        return paths;
    }

private:
    std::vector<std::size_t> awaited_by(std::size_t process) const {
        const StuckProcess& waiting = report_.processes[process];
        std::vector<std::size_t> partners;
        const auto add = [&](std::string_view path) {
            if (const auto found = processes_.find(path); found != processes_.end())
                partners.push_back(found->second);
        };
        for (const std::string& name : waiting.channels) {
            const StuckChannel& channel = *channels_.at(name);
            add(waiting.activity == Activity::outputting ? channel.inputter : channel.outputter);
        }
        if (waiting.activity == Activity::joining)
            for (const StuckProcess& other : report_.processes)
                if (parent_of(other.path) == waiting.path)
                    add(other.path);
        return partners;
    }

    const Deadlock& report_;
    std::map<std::string_view, std::size_t> processes_;
    std::map<std::string_view, const StuckChannel*> channels_;
};

/// Completes the report's channels between ranks with the users of both ends, and lists each channel once.
void complete_channels(Deadlock& deadlock, const std::vector<RankResult>& results) {
    const auto users = users_between(results);
    std::map<std::string, bool> known;
    std::erase_if(deadlock.channels, [&](const StuckChannel& each) { return !known.emplace(each.name, true).second; });
    for (StuckChannel& channel : deadlock.channels)
        if (const auto found = users.find(channel.name); found != users.end()) {
            channel.outputter = found->second.outputter;
            channel.inputter = found->second.inputter;
        }
}

} // namespace

MessageBytes packed(const RankResult& result) {
    MessageBytes bytes;
    pack(result, bytes);
    return bytes;
}

RankResult rank_result_from(std::span<const std::uint8_t> bytes) { return unpack<RankResult>(bytes); }

std::optional<Deadlock> join_deadlocks(const std::vector<RankResult>& results, const Network& network) {
    std::optional<Deadlock> joined;
    for (const RankResult& result : results)
        if (const std::optional<Deadlock>& part = result.part.result.deadlock) {
            joined.emplace(joined.value_or(Deadlock()));
            std::ranges::copy(part->processes, std::back_inserter(joined->processes));
            std::ranges::copy(part->channels, std::back_inserter(joined->channels));
        }
    if (!joined)
        return std::nullopt;
    sort_by_netlist(joined->processes, network);
    complete_channels(*joined, results);
    joined->cycle = WaitsInReport(*joined).cycle();
    return joined;
}

} // namespace placedpar::native
