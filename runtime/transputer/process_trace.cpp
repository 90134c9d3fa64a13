#include "runtime/transputer/process_trace.hpp"

#include "runtime/kernel.hpp"
#include "runtime/transputer/words.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::transputer {

ProcessTrace::ProcessTrace(Kernel& kernel, const Core& core, const std::string& place, Naming process, Naming channel)
    : kernel_(kernel), core_(core), place_(place), name_of_process_(std::move(process)),
      name_of_channel_(std::move(channel)) {}

void ProcessTrace::changes(Word workspace, Core::ProcessChange change, Word channel) {
    using ProcessChange = Core::ProcessChange;
    const std::string process = name_of_process_(workspace);
    const Time now = core_.local_time();
    switch (change) {
    case ProcessChange::gets_processor: running_ = process; return add({now, process, Activity::computing});
    case ProcessChange::becomes_ready:
        if (core_.is_running() && workspace == core_.registers().workspace)
            leave(process); // the process is interrupted
        return add({now, process, Activity::ready});
    case ProcessChange::communicated:
        return add({.at = now, .process = process, .activity = Activity::ready, .partner = running_});
    case ProcessChange::enables_channel: return void(enabled_[workspace].insert(channel));
    case ProcessChange::needs_no_wait: return void(enabled_.erase(workspace));
    case ProcessChange::waits_in_alt: return wait(workspace, Activity::alternating, enabled_by(workspace), false);
    case ProcessChange::waits_for_time: {
        const std::vector<Word> channels = enabled_by(workspace);
        return wait(workspace, channels.empty() ? Activity::delayed : Activity::alternating, channels, true);
    }
    case ProcessChange::waits_for_input: return wait(workspace, Activity::inputting, {channel}, false);
    case ProcessChange::waits_for_output: return wait(workspace, Activity::outputting, {channel}, false);
    case ProcessChange::stops: return wait(workspace, Activity::stopped, {}, false);
    case ProcessChange::ends: leave(process); return add({now, process, Activity::ended});
    }
}

void ProcessTrace::wait(Word workspace, Activity activity, const std::vector<Word>& channels, bool awaits_timer) {
    const std::string process = name_of_process_(workspace);
    leave(process);
    Notice notice{core_.local_time(), process, activity};
    notice.awaits_timer = awaits_timer;
    for (const Word each : channels) {
        users_[each][activity == Activity::outputting] = process;
        notice.awaited.push_back(awaited(each, activity == Activity::outputting));
    }
    add(std::move(notice));
}

/// Records that the running process leaves the processor. If its workspace has now another name, the trace shows the
/// end of the process with the former name.
void ProcessTrace::leave(const std::string& process) {
    if (running_ != process && !running_.empty())
        add({core_.local_time(), running_, Activity::ended});
    running_ = "";
}

std::vector<Word> ProcessTrace::enabled_by(Word workspace) {
    const auto found = enabled_.find(workspace);
    if (found == enabled_.end())
        return {};
    const std::vector<Word> result(found->second.begin(), found->second.end());
    enabled_.erase(found);
    return result;
}

/// Returns the names of a channel and of the process that used its other end last. For a link's channel, the second
/// name is the same as the first.
AwaitedByProgram ProcessTrace::awaited(Word channel, bool outputs) {
    const std::string name = name_of_channel_(channel);
    return {name, hard_channel(channel) >= 0 ? name : users_[channel][!outputs]};
}

void ProcessTrace::add(Notice notice) {
    if (notices_.empty())
        kernel_.future().reschedule(*this, std::max(notice.at, kernel_.now()), EventQueue::turn);
    notices_.push_back(std::move(notice));
}

void ProcessTrace::happen() noexcept {
    while (!notices_.empty() && notices_.front().at <= kernel_.now()) {
        const Notice& first = notices_.front();
        kernel_.trace()->program_turns(
            {first.process, place_, first.activity, first.awaited, first.awaits_timer, first.partner}, kernel_.now());
        notices_.pop_front();
    }
    if (!notices_.empty())
        kernel_.future().schedule(*this, notices_.front().at, EventQueue::turn);
}

} // namespace placedpar::transputer
