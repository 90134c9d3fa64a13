#include "monitor/service/persistence.hpp"

#include "monitor/service/clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar::monitor {

namespace {

/// The shortest and the longest pause before data is stored anew. Storing anew copies the states of all machines, so
/// each pause is longer than the previous pause.
constexpr std::chrono::seconds first_pause{1}, longest_pause{16};

std::string going_on(const std::string& trouble) {
    return fmt::format("{}; the service continues, but a restart would lose the unwritten state", trouble);
}

} // namespace

Persistence::Persistence(StateStore* store, Outbox& outbox, std::function<void(const std::string&)> complain)
    : store_(store), outbox_(outbox), complain_(std::move(complain)), trouble_(store ? store->trouble() : "") {
    if (!well())
        complain_(going_on(trouble_));
}

void Persistence::record(Client& from, const std::string& machine, std::string_view line, std::size_t generations,
                         std::vector<Entry> history) {
    if (!store_)
        return;
    outbox_.wait_for(store_->record(machine, line, generations, std::move(history)));
    outbox_.hold(from, line.size()); // even a client that asks for no answers must not be faster than the disk
    store_->relieve();
}

void Persistence::save(const identification::Diagnosis& diagnosis) {
    if (store_)
        outbox_.wait_for(store_->save(diagnosis));
}

void Persistence::forget(const std::string& machine) {
    if (store_)
        outbox_.wait_for(store_->forget(machine));
}

void Persistence::change_history(Entry entry) {
    if (store_)
        outbox_.wait_for(store_->change_history(std::move(entry)));
}

bool Persistence::note(const WriteProgress& progress) {
    store_->note(progress);
    bool was_well = well();
    if (store_->complete())
        trouble_.clear();
    else if (!progress.trouble.empty())
        trouble_ = progress.trouble;
    if (well() == was_well)
        return false;
    pause_ = first_pause;
    next_attempt_ = Clock::now() + pause_;
    complain_(well() ? "the state file can be written again and now has the complete state" : going_on(trouble_));
    return true;
}

void Persistence::tick(const AlarmBoard& alarms) {
    if (!store_ || store_->keeping() || Clock::now() < next_attempt_)
        return;
    pause_ = std::min(2 * pause_, longest_pause);
    next_attempt_ = Clock::now() + pause_;
    store_->write_anew(alarms.all(), now_at());
}

void Persistence::finish(const AlarmBoard& alarms) {
    if (!store_)
        return;
    store_->write_anew(alarms.all(), now_at());
    store_->finish();
}

} // namespace placedpar::monitor
