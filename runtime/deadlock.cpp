#include "runtime/deadlock.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/wait_cycle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <unordered_set>

namespace placedpar {

namespace {

using Processes = std::vector<const Process*>; ///< grouped by kernel, and in order of creation

/// Returns a number by which the processes of a run can be sorted: by kernel, and within a kernel by their creation.
std::uint64_t place_of(const Process& outermost, std::uint32_t ordinal) {
    return std::uint64_t{outermost.kernel().number()} << 32 | ordinal;
}
std::uint64_t place_of(const Process* process) { return place_of(process->outermost(), process->ordinal()); }

/// Returns the process that must act at a channel's end: the last user of the end. If this user was a component of a
/// PAR and has ended, returns its ancestor at the outermost level.
const Process* who_is(const AnyChannel::User& user, const Processes& living) {
    if (!user.outermost)
        return nullptr;
    const std::uint64_t place = place_of(*user.outermost, user.ordinal);
    auto found = std::ranges::lower_bound(living, place, {}, [](const Process* each) { return place_of(each); });
    // The address alone does not identify the process: a later component may have the address of a component that
    // ended.
    bool lives = found != living.end() && place_of(*found) == place && *found == user.process;
    return lives ? user.process : user.outermost;
}

std::string path_of(const AnyChannel& channel, const AnyChannel::User& user, const Processes& living) {
    const Process* process = who_is(user, living);
    if (const std::string device = process ? "" : channel.partner_device(); !device.empty())
        return device;
    if (!process)
        return "none yet";
    return process->path() + (process->ended() ? " (has ended)" : "");
}

bool halted(const Process& process) { return process.executive() && process.executive()->halted(); }

/// Adds the processes that must act before the outputting process can continue: usually the inputter. In a broadcast,
/// they are the processes at other channels that have not taken the message.
void add_awaited_by_output(const AnyChannel& channel, const Processes& living, Processes& partners) {
    auto held_up_by = channel.held_up_by();
    if (held_up_by.empty() || (channel.output_waits() && !channel.input_waits()))
        partners.push_back(who_is(channel.last_inputter(), living));
    for (const AnyChannel* other : held_up_by)
        partners.push_back(who_is(other->output_waits() ? other->last_inputter() : other->last_outputter(), living));
}

/// Returns the processes for which this process waits. A process that waits on several channels continues when one of
/// these processes acts.
Processes awaited_by(const Process& process, const Processes& living) {
    Processes partners;
    if (halted(process))
        return partners;
    for (const AnyChannel* channel : process.awaited_channels())
        if (process.activity() == Activity::outputting)
            add_awaited_by_output(*channel, living, partners);
        else
            partners.push_back(who_is(channel->last_outputter(), living));
    if (process.activity() == Activity::joining)
        for (const Process* other : living)
            if (other->parent() == &process)
                partners.push_back(other);
    std::erase_if(partners, [](const Process* partner) { return !partner || partner->ended(); });
    return partners;
}

/// Returns the channels on which a process waits. A process whose processor has halted may be ready, and then waits on
/// none.
std::span<const AnyChannel* const> channels_of_wait(const Process& process) {
    return process.activity() == Activity::ready ? std::span<const AnyChannel* const>{} : process.awaited_channels();
}

StuckProcess describe(const Process& process) {
    StuckProcess stuck{process.path(), halted(process) ? Activity::halted : process.activity(), {}, ""};
    for (const AnyChannel* channel : channels_of_wait(process))
        stuck.channels.push_back(channel->name());
    stuck.where = text_of(process.place_in_program());
    return stuck;
}

StuckChannel describe(const AnyChannel& channel, const Processes& living, std::string waiting) {
    return {channel.name(), path_of(channel, channel.last_outputter(), living),
            path_of(channel, channel.last_inputter(), living), std::move(waiting)};
}

/// Describes the channels in the order of the processes that wait on them.
std::vector<StuckChannel> describe_channels(const Processes& stuck, const Processes& living) {
    std::vector<StuckChannel> result;
    std::unordered_set<std::string_view> known;
    for (const Process* process : stuck)
        for (const AnyChannel* channel : channels_of_wait(*process))
            if (known.insert(channel->name()).second)
                result.push_back(
                    describe(*channel, living, process->activity() == Activity::outputting ? "outputter" : "inputter"));
    return result;
}

std::string names_of(const std::vector<const AnyChannel*>& channels) {
    std::vector<std::string> names;
    for (const AnyChannel* channel : channels)
        names.push_back(channel->name());
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Describes the outputs of broadcasts that wait until other channels take the same message. Outputs that wait for the
/// same channels share a text.
std::vector<std::string> describe_held_up(const Processes& stuck) {
    using Channels = std::vector<const AnyChannel*>;
    // Each entry has the channels whose outputs wait, and the channels for which they wait.
    std::vector<std::pair<Channels, Channels>> held_up;
    for (const Process* process : stuck)
        if (process->activity() == Activity::outputting)
            for (const AnyChannel* channel : process->awaited_channels())
                if (Channels by = channel->held_up_by(); !by.empty()) {
                    auto known = std::ranges::find(held_up, by, [](const auto& each) { return each.second; });
                    if (known == held_up.end())
                        known = held_up.insert(known, {{}, by});
                    known->first.push_back(channel);
                }
    std::vector<std::string> texts;
    for (const auto& [channels, by] : held_up)
        texts.push_back(fmt::format(
            "{}: the message waits until it is {} on {}, too, because one message goes to all these channels{}",
            names_of(channels), by.front()->output_waits() ? "taken" : "output", names_of(by),
            by.front()->output_waits() ? "" : ": output it on all of them in a PAR"));
    return texts;
}

/// Describes the channels on which one process gave up a message in the middle, but the other process still waits for
/// the rest.
std::vector<std::string> describe_unreset(const Processes& stuck, const Processes& living) {
    std::vector<std::string> texts;
    std::unordered_set<const AnyChannel*> known;
    for (const Process* process : stuck)
        for (const AnyChannel* channel : channels_of_wait(*process)) {
            const bool input = channel->input_must_be_reset();
            if ((!input && !channel->output_must_be_reset()) || !known.insert(channel).second)
                continue;
            const auto &left = channel->last_outputter(), &waits = channel->last_inputter();
            texts.push_back(fmt::format(
                "{}: no message can pass until {}, too, gives up its message and resets its end, because {} "
                "gave up the message in the middle",
                channel->name(), path_of(*channel, input ? waits : left, living),
                path_of(*channel, input ? left : waits, living)));
        }
    return texts;
}

} // namespace

const char* name_of(Activity activity) {
    switch (activity) {
    case Activity::delayed: return "waits for its timer";
    case Activity::outputting: return "outputs";
    case Activity::inputting: return "inputs";
    case Activity::alternating: return "alternates";
    case Activity::joining: return "waits for its components";
    case Activity::after_work: return "waits for the end of the work";
    case Activity::stopped: return "has stopped";
    case Activity::halted: return "is halted";
    case Activity::ended: return "has ended";
    case Activity::ready:
    case Activity::executing:
    case Activity::carrying:
    case Activity::computing:
    case Activity::starting:
    case Activity::moving:
    case Activity::arbitrating: break;
    }
    return "is ready";
}

namespace {

/// Describes the deadlock of the `stuck` processes. `living`: all processes that have not ended.
Deadlock deadlock_of(const Processes& stuck, const Processes& living) {
    Deadlock deadlock;
    const auto awaited = [&living](const Process* process) { return awaited_by(*process, living); };
    for (const Process* process : CycleSearch<const Process*, decltype(awaited)>(awaited).find(stuck))
        deadlock.cycle.push_back(process->path());
    deadlock.held_up = describe_held_up(stuck);
    std::ranges::move(describe_unreset(stuck, living), std::back_inserter(deadlock.held_up));
    for (const Process* process : stuck)
        deadlock.processes.push_back(describe(*process));
    deadlock.channels = describe_channels(stuck, living);
    return deadlock;
}

/// Returns whether the process waits for a known partner to come to the channel. If both processes already communicate,
/// they need only time, unless a link has lost a part of the message. If only the acknowledge is missing, no partner is
/// needed.
bool lacks_partner(const Process& process, const AnyChannel& channel) {
    bool known = channel.last_outputter().process && channel.last_inputter().process;
    switch (process.activity()) {
    case Activity::outputting:
        return known && (channel.output_is_lost() || (channel.output_waits() && !channel.input_waits()) ||
                         !channel.held_up_by().empty());
    case Activity::inputting:
        return known && channel.input_waits() &&
               (!channel.output_waits() || channel.output_is_lost() || !channel.held_up_by().empty());
    default: return known && (!channel.output_waits() || !channel.held_up_by().empty());
    }
}

/// Returns whether no process can make this process continue.
bool is_lost(const Process& process) {
    auto lost = [&](const AnyChannel* channel) {
        return process.activity() == Activity::outputting  ? channel->output_is_lost()
               : process.activity() == Activity::inputting ? channel->input_is_lost()
                                                           : false;
    };
    return halted(process) || process.activity() == Activity::stopped ||
           (!process.awaits_timer() && std::ranges::any_of(process.awaited_channels(), lost));
}

/// Returns true if this process can continue only by the action of known processes, or not at all.
bool needs_partner(const Process* process) {
    if (is_lost(*process))
        return true;
    switch (process->activity()) {
    case Activity::joining: return true;
    case Activity::outputting:
    case Activity::inputting:
    case Activity::alternating: break;
    default: return false;
    }
    auto channels = process->awaited_channels();
    return !process->awaits_timer() && !channels.empty() &&
           std::ranges::all_of(channels, [&](const AnyChannel* each) { return lacks_partner(*process, *each); });
}

} // namespace

Deadlock find_deadlock(const Kernel& kernel) { return find_deadlock(std::array{&kernel}); }

Deadlock find_deadlock(std::span<const Kernel* const> kernels) {
    Processes living;
    for (const Kernel* kernel : kernels)
        std::ranges::copy(kernel->living(), std::back_inserter(living));
    return deadlock_of(living, living);
}

std::vector<StuckChannel> users_of(std::span<const AnyChannel* const> channels, const Kernel& kernel) {
    const Processes living = kernel.living();
    std::vector<StuckChannel> users;
    for (const AnyChannel* channel : channels)
        users.push_back(describe(*channel, living, ""));
    return users;
}

/// Finds the largest set of waiting processes that wait only for each other or for processes that have ended.
std::optional<Deadlock> find_partial_deadlock(const Kernel& kernel) {
    auto living = kernel.living();
    Processes stuck;
    std::ranges::copy_if(living, std::back_inserter(stuck), needs_partner);
    auto can_go_on = [&](const Process* process) {
        return !is_lost(*process) && std::ranges::any_of(awaited_by(*process, living), [&](const Process* partner) {
            return !std::ranges::binary_search(stuck, partner->ordinal(), {}, &Process::ordinal);
        });
    };
    for (std::size_t before = 0; before != stuck.size();) {
        before = stuck.size();
        Processes left;
        std::ranges::remove_copy_if(stuck, std::back_inserter(left), can_go_on);
        stuck = std::move(left);
    }
    if (stuck.empty())
        return std::nullopt;
    return deadlock_of(stuck, living);
}

namespace {

/// Returns the text of the column "netlist" in a row, or the heading of this column if `row` is null. Returns "" if
/// there is no netlist.
template <class Rows>
std::string last_column(const Rows& rows, const typename Rows::value_type* row) {
    if (std::ranges::all_of(rows, [](const auto& each) { return each.netlist.empty(); }))
        return "";
    return row ? row->netlist : "netlist";
}

/// Formats a line of columns with the given widths. The last column is not padded.
std::string line_of(std::initializer_list<std::pair<std::string_view, int>> columns) {
    std::string line;
    for (const auto& [text, width] : columns)
        line += fmt::format("{:<{}} ", text, width);
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

std::string print(const std::vector<StuckProcess>& rows) {
    auto line = [](std::string_view process, std::string_view operation, std::string_view channel,
                   std::string_view program, std::string_view netlist) {
        return line_of({{process, 28}, {operation, 26}, {channel, 44}, {program, 24}, {netlist, 0}});
    };
    std::string out = line("process", "operation", "channel", "program", last_column(rows, nullptr));
    for (const StuckProcess& row : rows)
        out += line(row.path, name_of(row.activity), fmt::format("{}", fmt::join(row.channels, ", ")), row.where,
                    last_column(rows, &row));
    return out;
}

std::string print(const std::vector<StuckChannel>& rows) {
    auto line = [](std::string_view channel, std::string_view outputter, std::string_view inputter,
                   std::string_view waiting, std::string_view netlist) {
        return line_of({{channel, 44}, {outputter, 28}, {inputter, 28}, {waiting, 9}, {netlist, 0}});
    };
    std::string out = line("channel", "outputter", "inputter", "waiting", last_column(rows, nullptr));
    for (const StuckChannel& row : rows)
        out += line(row.name, row.outputter, row.inputter, row.waiting, last_column(rows, &row));
    return out;
}

/// Lists the processes that wait for a process that has ended, because such a wait is the usual cause of a deadlock
/// without a cycle.
std::string print_ended(const std::vector<StuckChannel>& rows) {
    constexpr std::string_view ended = " (has ended)";
    std::string out;
    for (const StuckChannel& row : rows) {
        const bool inputs = row.waiting == "inputter";
        std::string_view partner = inputs ? row.outputter : row.inputter;
        if (partner.ends_with(ended))
            out += fmt::format("no wait cycle: {} {} for ever, but {} has ended; do both processes expect the same "
                               "number of messages?\n",
                               inputs ? row.inputter : row.outputter, inputs ? "inputs" : "outputs",
                               partner.substr(0, partner.size() - ended.size()));
    }
    return out;
}

} // namespace

std::string Deadlock::text() const {
    std::string out;
    if (!cycle.empty())
        out += fmt::format("wait cycle: {} -> {}\n", fmt::join(cycle, " -> "), cycle.front());
    else
        out += print_ended(channels);
    for (const auto& why : held_up)
        out += fmt::format("held up: {}\n", why);
    out += "\n" + print(processes);
    if (!channels.empty())
        out += "\n" + print(channels);
    return out;
}

} // namespace placedpar
