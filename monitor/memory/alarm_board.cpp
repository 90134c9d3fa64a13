#include "monitor/memory/alarm_board.hpp"

#include "monitor/protocol/link_words.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace {

KeptAlarm kept_alarm(const std::string& machine, const Alarm& alarm, double at) {
    KeptAlarm kept;
    kept.machine = machine;
    kept.kind = name_of(alarm.kind);
    kept.links = words_of(alarm.links);
    kept.text = alarm.text;
    kept.raised_at = at;
    return kept;
}

auto find_same(std::vector<KeptAlarm>& alarms, const KeptAlarm& alarm) {
    return std::ranges::find_if(alarms, [&](const KeptAlarm& each) { return each.same_as(alarm); });
}

} // namespace

void AlarmBoard::restore(std::vector<KeptAlarm> noted) {
    for (KeptAlarm& alarm : noted) {
        if (alarm.shelved_until)
            shelved_[alarm.machine].push_back(alarm);
        if (!alarm.cleared_at)
            open_[alarm.machine].push_back(std::move(alarm));
    }
}

std::optional<double> AlarmBoard::shelved_until(const KeptAlarm& alarm, double at) const {
    if (auto found = shelved_.find(alarm.machine); found != shelved_.end())
        for (const KeptAlarm& each : found->second)
            if (each.same_as(alarm) && *each.shelved_until > at)
                return each.shelved_until;
    return std::nullopt;
}

Entry AlarmBoard::raise(const Diagnosis& diagnosis, const Alarm& alarm, double at) {
    KeptAlarm raised = kept_alarm(diagnosis.name(), alarm, at);
    raised.raised_time_s = diagnosis.time_s();
    raised.shelved_until = shelved_until(raised, at);
    open_[raised.machine].push_back(raised);
    return raised;
}

Entry AlarmBoard::clear(const std::string& machine, const Alarm& alarm, double at) {
    KeptAlarm cleared = kept_alarm(machine, alarm, at);
    std::vector<KeptAlarm>& open = open_[machine];
    if (auto found = find_same(open, cleared); found != open.end()) {
        cleared = *found;
        open.erase(found);
    }
    cleared.cleared_at = at;
    return ChangedAlarm{cleared};
}

void AlarmBoard::forget(const std::string& machine) {
    open_.erase(machine);
    shelved_.erase(machine);
}

KeptAlarm* AlarmBoard::find(const AlarmName& name) {
    for (KeptAlarm& alarm : open_[name.machine])
        if (alarm.kind == name.kind && alarm.links == name.links)
            return &alarm;
    return nullptr;
}

std::optional<Entry> AlarmBoard::acknowledge(const AlarmName& name, double at) {
    KeptAlarm* alarm = find(name);
    if (!alarm)
        return std::nullopt;
    if (!alarm->acknowledged_at)
        alarm->acknowledged_at = at;
    return ChangedAlarm{*alarm};
}

std::optional<Entry> AlarmBoard::shelve(const AlarmName& name, double until, double at) {
    KeptAlarm* alarm = find(name);
    if (!alarm)
        return std::nullopt;
    std::vector<KeptAlarm>& shelf = shelved_[name.machine];
    std::erase_if(shelf, [&](const KeptAlarm& each) { return each.same_as(*alarm) || *each.shelved_until <= at; });
    alarm->shelved_until = until > at ? std::optional(until) : std::nullopt;
    if (alarm->shelved_until)
        shelf.push_back(*alarm);
    return ChangedAlarm{*alarm};
}

bool AlarmBoard::shelved(const std::string& machine, const Alarm& alarm, double at) const {
    return shelved_until(kept_alarm(machine, alarm, at), at).has_value();
}

const std::vector<KeptAlarm>& AlarmBoard::of(const std::string& machine) const {
    static const std::vector<KeptAlarm> none;
    auto found = open_.find(machine);
    return found == open_.end() ? none : found->second;
}

std::vector<KeptAlarm> AlarmBoard::all() const {
    std::vector<KeptAlarm> all;
    for (const auto& [machine, alarms] : open_)
        all.insert(all.end(), alarms.begin(), alarms.end());
    return all;
}

} // namespace placedpar::monitor
