#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/state_store.hpp"
#include "monitor/service/client.hpp"
#include "monitor/service/load_meter.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace placedpar::monitor {

/// How well what is known is kept over a restart.
enum class Keeping : unsigned char {
    well,
    in_journal, ///< the state file cannot be written: the journal grows
    not_at_all  ///< a restart would forget
};

/// Takes the clients' messages to the diagnoses and the answers back. Knows nothing of sockets. One overload of
/// answer() for each message of the protocol.
class Dispatcher {
public:
    /// `store` may be null: nothing is kept. `complain` is given sentences for the operator.
    Dispatcher(Diagnoses& diagnoses, StateStore* store, std::function<void(const std::string&)> complain)
        : diagnoses_(diagnoses), store_(store), complain_(std::move(complain)) {}

    void enter(Client& client) { clients_.insert(&client); }
    void leave(Client& client);
    /// A line of the client. Answers go to it, and to the others that watch its machine.
    void take(Client& client, std::string_view line);
    /// Writes the state file and sends loads when they are due; tells clients whether all is kept. To be called a few
    /// times a second.
    void tick();
    /// What was recorded has not reached the disk.
    void journal_failed(const std::string& trouble);
    /// To all clients, which are then closed.
    void say_goodbye();
    /// Has anything been recorded since the last call?
    bool anything_recorded() { return std::exchange(recorded_, false); }

    /// Without those that are about to be closed.
    std::size_t clients() const;

private:
    void answer(Client&, const Hello&, std::string_view line);
    void answer(Client&, const identification::ConfigurationChange&, std::string_view line);
    void answer(Client&, const identification::ExcavatorSample&, std::string_view line);
    void answer(Client&, const identification::Baseline&, std::string_view line);
    void answer(Client&, const StatusRequest&, std::string_view line);
    void answer(Client&, const LoadRequest&, std::string_view line);
    void answer(Client&, const Ping&, std::string_view line);
    void answer(Client&, const Bye&, std::string_view line);

    identification::Diagnosis& diagnosis_of(Client& client) const;
    identification::Diagnosis& controlled_by(Client& client) const;
    void record(const std::string& machine, std::string_view line, std::size_t generations);
    void write_state();
    void note_keeping(const std::string& trouble);
    void tell_load(Client& client, LoadMeter::Clock::time_point now);
    void tell_kept(Client& client);
    void tell_watchers(const std::string& machine, std::string_view line, const std::function<bool(const Hello&)>& to);
    void tell_alarms(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome);
    std::string load() const; ///< as a line

    Diagnoses& diagnoses_;
    StateStore* store_;
    std::function<void(const std::string&)> complain_;
    LoadMeter meter_;
    std::set<Client*> clients_;
    std::map<std::string, std::set<Client*>> of_machine_; ///< those that said hello
    std::map<std::string, Client*> control_;              ///< of each machine, its control system
    bool recorded_ = false;
    Keeping keeping_ = Keeping::well;
    std::string trouble_;                     ///< with keeping it
    LoadMeter::Clock::time_point last_write_; ///< of the state file, or the attempt
};

} // namespace placedpar::monitor
