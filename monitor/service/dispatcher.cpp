#include "monitor/service/dispatcher.hpp"

#include "monitor/protocol/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace placedpar::monitor {

using namespace identification;

namespace {

/// The state file is written no more often than this, even if it is due: on a full disk, or under extreme load.
constexpr std::chrono::seconds between_writes{1};

} // namespace

void Dispatcher::leave(Client& client) {
    clients_.erase(&client);
    if (!client.hello)
        return;
    const std::string& machine = client.hello->machine;
    of_machine_[machine].erase(&client);
    if (of_machine_[machine].empty())
        of_machine_.erase(machine);
    if (auto found = control_.find(machine); found != control_.end() && found->second == &client)
        control_.erase(found);
}

void Dispatcher::take(Client& client, std::string_view line) {
    auto begin = LoadMeter::Clock::now();
    try {
        Message message = parse_message(line);
        std::visit([&](const auto& each) { answer(client, each, line); }, message);
    } catch (const BadMessage& bad) {
        client.send(error_line(client.lines(), bad));
    } catch (const RefusedSample& refused) {
        client.send(error_line(client.lines(), BadMessage(refused)));
    }
    meter_.count_work(LoadMeter::Clock::now() - begin);
}

Diagnosis& Dispatcher::diagnosis_of(Client& client) const {
    if (!client.hello)
        throw BadMessage("type", "no hello yet", "first {\"type\":\"hello\",\"version\":1,\"machine\":\"name\"}");
    return diagnoses_.named(client.hello->machine);
}

Diagnosis& Dispatcher::controlled_by(Client& client) const {
    Diagnosis& diagnosis = diagnosis_of(client);
    if (client.hello->role != Role::control)
        throw BadMessage("type", "a watcher may ask, not tell",
                         "status, load, ping or bye; \"role\":\"control\" in hello");
    return diagnosis;
}

void Dispatcher::answer(Client& client, const Hello& hello, std::string_view line) {
    if (client.hello)
        throw BadMessage("type", fmt::format("this connection is about \"{}\" already", client.hello->machine),
                         "another connection");
    Diagnosis& diagnosis = diagnoses_.greet(hello);
    client.hello = hello;
    client.greeted();
    of_machine_[hello.machine].insert(&client);
    if (hello.role == Role::control) {
        record(hello.machine, line, 0);
        // The old connection may be half open, its control system long gone.
        if (Client* other = std::exchange(control_[hello.machine], &client)) {
            other->send(plain_line("closing", "another control system has said hello for this machine"));
            other->finish();
        }
    }
    client.send(welcome_line(diagnosis, diagnoses_.seed()));
}

void Dispatcher::answer(Client& client, const ConfigurationChange& change, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    diagnosis.change(change);
    record(diagnosis.name(), line, 0);
    tell_watchers(diagnosis.name(), configured_line(diagnosis), [](const Hello&) { return true; });
}

void Dispatcher::answer(Client& client, const ExcavatorSample& sample, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    SampleOutcome outcome = diagnosis.take(sample);
    meter_.count_sample(outcome.generations);
    record(diagnosis.name(), line, outcome.generations);
    tell_watchers(diagnosis.name(), estimates_line(diagnosis, outcome, diagnoses_.settings()), [&](const Hello& hello) {
        return hello.answers == Answers::all || (hello.answers == Answers::moved && outcome.generations > 0);
    });
    tell_alarms(diagnosis, outcome);
}

void Dispatcher::answer(Client& client, const Baseline& baseline, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    SampleOutcome outcome = diagnosis.set_baseline(baseline);
    record(diagnosis.name(), line, 0);
    client.send(status_line(diagnosis, diagnoses_.settings()));
    tell_alarms(diagnosis, outcome);
}

void Dispatcher::answer(Client& client, const StatusRequest&, std::string_view) {
    client.send(status_line(diagnosis_of(client), diagnoses_.settings()));
}

void Dispatcher::answer(Client& client, const LoadRequest&, std::string_view) {
    client.greeted();
    client.send(load());
}

void Dispatcher::answer(Client& client, const Ping&, std::string_view) {
    client.greeted();
    client.send(plain_line("pong"));
}

void Dispatcher::answer(Client& client, const Bye&, std::string_view) {
    client.send(plain_line("closing", "bye"));
    client.finish();
}

void Dispatcher::tell_watchers(const std::string& machine, std::string_view line,
                               const std::function<bool(const Hello&)>& to) {
    for (Client* client : of_machine_[machine])
        if (to(*client->hello))
            client->send(line);
}

void Dispatcher::tell_alarms(const Diagnosis& diagnosis, const SampleOutcome& outcome) {
    auto everybody = [](const Hello&) { return true; };
    for (const Alarm& alarm : outcome.raised)
        tell_watchers(diagnosis.name(), alarm_line(diagnosis, alarm, true), everybody);
    for (const Alarm& alarm : outcome.cleared)
        tell_watchers(diagnosis.name(), alarm_line(diagnosis, alarm, false), everybody);
}

void Dispatcher::record(const std::string& machine, std::string_view line, std::size_t generations) {
    if (!store_)
        return;
    try {
        store_->record(machine, line, generations);
        recorded_ = true;
    } catch (const std::exception& error) {
        note_keeping(error.what()); // the diagnosis goes on: it is worth more than its memory
    }
}

void Dispatcher::journal_failed(const std::string& trouble) {
    store_->journal_failed();
    note_keeping(trouble);
}

void Dispatcher::write_state() {
    auto now = LoadMeter::Clock::now();
    if (!store_ || !store_->due() || now - last_write_ < between_writes)
        return;
    last_write_ = now;
    try {
        store_->write(diagnoses_);
        note_keeping("");
    } catch (const std::exception& error) {
        note_keeping(error.what());
    }
}

/// Tells the operator when it has changed.
void Dispatcher::note_keeping(const std::string& trouble) {
    Keeping before = keeping_;
    keeping_ = !store_->complete() ? Keeping::not_at_all : trouble.empty() ? Keeping::well : Keeping::in_journal;
    if (keeping_ == before)
        return;
    trouble_ = trouble;
    complain_(keeping_ == Keeping::well         ? "the state file is written again, with all that is known"
              : keeping_ == Keeping::in_journal ? fmt::format("{}; going on with the journal", trouble)
                                                : fmt::format("{}; going on, but a restart would forget", trouble));
}

std::size_t Dispatcher::clients() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(clients_, [](const Client* client) { return !client->finishing(); }));
}

std::string Dispatcher::load() const {
    Load load = meter_.load();
    load.clients = clients();
    load.machines = diagnoses_.all().size();
    for (const Client* client : clients_)
        load.queued_bytes += client->queued_bytes();
    return load_line(load);
}

void Dispatcher::tick() {
    meter_.tick();
    write_state();
    auto now = LoadMeter::Clock::now();
    for (Client* client : clients_)
        if (client->hello) {
            tell_kept(*client);
            tell_load(*client, now);
        }
}

void Dispatcher::tell_kept(Client& client) {
    bool kept = keeping_ != Keeping::not_at_all;
    if (std::exchange(client.told_kept, kept) != kept)
        client.send(kept_line(kept, kept ? "" : trouble_));
}

void Dispatcher::tell_load(Client& client, LoadMeter::Clock::time_point now) {
    double every_s = client.hello->load_every_s;
    if (every_s > 0 && std::chrono::duration<double>(now - client.last_load).count() >= every_s) {
        client.last_load = now;
        client.send(load());
    }
}

void Dispatcher::say_goodbye() {
    for (Client* client : clients_) {
        client->send(plain_line("closing", "the monitor stops"));
        client->finish();
    }
}

} // namespace placedpar::monitor
