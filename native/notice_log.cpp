#include "native/notice_log.hpp"

#include "runtime/channel.hpp"
#include "runtime/surroundings.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace placedpar::native {

namespace {

/// Returns the number of a key in a table. Adds the key if it is new.
template <class Numbers, class Key>
std::uint32_t number_in(std::vector<Key>& table, Numbers& numbers, const Key& key) {
    const auto [found, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(table.size()));
    if (is_new)
        table.push_back(key);
    return found->second;
}

} // namespace

/// Returns `now`, or 1 ns after the last notice if that is later, so that no activity has the length 0.
Time NoticeLog::later_than_last(Time now) {
    constexpr Time shortest = std::chrono::nanoseconds(1);
    return last_ = std::max(now, last_ + shortest);
}

/// Returns the present time of the wall clock. The kernel's own time stands still while a process runs, because the
/// kernel reads the clock only when a wait begins or ends.
Time NoticeLog::read_clock() { return later_than_last(kernel_.surroundings()->now()); }

void NoticeLog::add(Notice notice) {
    if (notices_.full_at || notice.at > until_)
        return;
    if (notices_.all.size() < most_)
        notices_.all.push_back(notice);
    else
        notices_.full_at = notice.at;
}

/// Records a change of activity. Becoming ready is not recorded: a wait lasts until the process runs again.
void NoticeLog::turns(const Process& process, Activity activity, Time now) {
    if (activity == Activity::ready)
        return;
    const Time at = activity == Activity::starting ? read_clock() : later_than_last(now);
    Notice notice{.at = at, .process = number_of(process), .activity = static_cast<std::uint8_t>(activity)};
    if (is_waiting(activity)) {
        notice.subject = number_of_awaited(process);
        notice.awaits_timer = process.awaits_timer();
    }
    add(notice);
    if (activity == Activity::ended)
        living_.erase(process.ordinal());
}

void NoticeLog::communicated(const AnyChannel& channel, Time) {
    const Process *from = channel.outputter(), *to = channel.inputter();
    const Notice::Kind kind = has(from) && has(to) ? Notice::Kind::local_message : Notice::Kind::crossing_message;
    if (has(from))
        add_part(channel, *from, Activity::outputting, kind);
    if (has(to))
        add_part(channel, *to, Activity::inputting, kind);
}

void NoticeLog::add_part(const AnyChannel& channel, const Process& process, Activity activity, Notice::Kind kind) {
    const std::uint32_t subject = number_of(channel);
    add({.at = read_clock(),
         .process = number_of(process),
         .subject = subject,
         .number = messages_[subject][activity == Activity::inputting]++,
         .kind = kind,
         .activity = static_cast<std::uint8_t>(activity)});
}

void NoticeLog::over(Time now) { notices_.over = std::max(now, last_); }

std::uint32_t NoticeLog::number_of(const Process& process) {
    const auto [found, is_new] = living_.try_emplace(process.ordinal(), 0);
    if (is_new)
        found->second = number_in(notices_.processes, processes_, process.path());
    return found->second;
}

std::uint32_t NoticeLog::number_of(const AnyChannel& channel) {
    const std::uint32_t number = number_in(notices_.channels, channels_, channel.name());
    if (number == messages_.size())
        messages_.emplace_back();
    return number;
}

std::uint32_t NoticeLog::number_of_awaited(const Process& process) {
    std::vector<std::uint32_t> channels;
    for (const AnyChannel* channel : process.awaited_channels())
        channels.push_back(number_of(*channel));
    return number_in(notices_.awaited, awaited_, channels);
}

} // namespace placedpar::native
