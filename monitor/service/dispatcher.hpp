#pragma once

#include "monitor/memory/machines.hpp"
#include "monitor/memory/state_store.hpp"
#include "monitor/protocol/load_meter.hpp"
#include "monitor/protocol/message.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// One who is connected, as the dispatcher sees him.
class Client {
public:
    virtual ~Client() = default;
    virtual void send(std::string_view line) = 0;
    /// Sends what is waiting and closes.
    virtual void finish() = 0;
    virtual void greeted() = 0;
    virtual bool finishing() const = 0;
    /// Lines that came from him, the present one included.
    virtual std::size_t lines() const = 0;
    virtual std::size_t queued_bytes() const = 0;

    std::optional<Hello> hello; // that he said
    std::chrono::steady_clock::time_point last_load;
    bool told_kept = true; // that what is known is kept
};

/// How what is known is kept: as it should be; in a journal that grows, since the state file cannot be written; or not
/// at all, so that a restart would forget.
enum class Keeping : unsigned char { well, in_journal, not_at_all };

/// Takes the clients' messages to the machines and the answers back. Knows nothing of sockets.
class Dispatcher {
public:
    /// `store` may be null: nothing is kept. `complain` is given sentences for the operator.
    Dispatcher(Machines& machines, StateStore* store, std::function<void(const std::string&)> complain)
        : machines_(machines), store_(store), complain_(std::move(complain)) {}

    void enter(Client& client) { clients_.insert(&client); }
    void leave(Client& client);
    /// A line of the client; answers go to whom they concern.
    void take(Client& client, std::string_view line);
    /// The state file and loads that are due, and whether all is kept. To be called a few times a second.
    void tick();
    /// What was recorded did not come to the disk.
    void journal_failed(const std::string& trouble);
    /// To all, who are then closed.
    void say_goodbye();
    /// Has anything been recorded since this was asked last?
    bool anything_recorded() { return std::exchange(recorded_, false); }

    /// Without those who are about to be closed.
    std::size_t clients() const;
    const LoadMeter& meter() const { return meter_; }

private:
    void answer(Client&, const Hello&, std::string_view line);
    void answer(Client&, const ConfigurationChange&, std::string_view line);
    void answer(Client&, const SampleMessage&, std::string_view line);
    void answer(Client&, const BaselineMessage&, std::string_view line);
    void answer(Client&, const StatusRequest&, std::string_view line);
    void answer(Client&, const LoadRequest&, std::string_view line);
    void answer(Client&, const Ping&, std::string_view line);
    void answer(Client&, const Bye&, std::string_view line);

    Machine& machine_of(Client& client) const;
    Machine& controlled_by(Client& client) const;
    void record(const std::string& machine, std::string_view line, std::size_t generations);
    void write_state();
    void note_keeping(const std::string& trouble);
    void tell_load(Client& client, LoadMeter::Clock::time_point now);
    void tell_kept(Client& client);
    void tell_watchers(const std::string& machine, std::string_view line, const std::function<bool(const Hello&)>& to);
    void tell_alarms(const Machine& machine, const SampleOutcome& outcome);
    std::string load() const;

    Machines& machines_;
    StateStore* store_;
    std::function<void(const std::string&)> complain_;
    LoadMeter meter_;
    std::set<Client*> clients_;
    std::map<std::string, std::set<Client*>> of_machine_;
    std::map<std::string, Client*> control_;
    bool recorded_ = false;
    Keeping keeping_ = Keeping::well;
    std::string trouble_;                     // with keeping it
    LoadMeter::Clock::time_point last_write_; // of the state file, or the attempt
};

} // namespace placedpar::monitor
