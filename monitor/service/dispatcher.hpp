#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/service/client_registry.hpp"
#include "monitor/service/load_meter.hpp"
#include "monitor/service/metrics.hpp"
#include "monitor/service/peers.hpp"
#include "monitor/service/persistence.hpp"
#include "monitor/service/places.hpp"
#include "web/token.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// The centre of the monitor: passes the clients' messages to the diagnoses of their machines (excavators), and sends
/// the answers. It uses no sockets. Each message of the protocol has its overload of answer().
class Dispatcher {
public:
    /// If `store` is null, nothing is stored. `say` receives messages for the operator. If `searches` is null, no
    /// simulated transputers search the machines' movements. REQUIRES: the limits outlive this object.
    Dispatcher(Diagnoses& diagnoses, StateStore* store, const ServiceLimits& limits, web::Token token,
               std::function<void(const std::string&)> say, NetlistSearches* searches = nullptr);

    /// Admits a client. If its peer (the computer or user from which it comes), or all peers together, have too many
    /// clients, closes a client that has sent no hello yet.
    void enter(Client& client);
    void leave(Client& client);
    /// Processes a line from the client. Answers go to the client and to other clients that watch its machine.
    void take(Client& client, std::string_view line);
    /// Sends load reports when they are due, and tells clients whether everything is stored. Call this function a few
    /// times a second.
    void tick();
    /// Processes a progress report of the state file's writer.
    void note(const WriteProgress& progress);
    /// Sends the answer of simulated transputers to the clients of the machine.
    void tell(const NetlistAnswer& answer);
    /// Sends a last message to all clients and closes them.
    void say_goodbye();
    /// Stores everything. Throws UserError.
    void finish() { persistence_.finish(alarms_); }

    ServiceSnapshot snapshot() const;

    /// Returns the number of clients, without clients that are about to be closed.
    std::size_t clients() const { return clients_.size(); }

private:
    void answer(Client&, const Hello&, std::string_view line);
    template <typename Change>
    void configure(Client&, const Change&, std::string_view line);
    void answer(Client&, const identification::ConfigurationChange&, std::string_view line);
    void answer(Client&, const identification::RecognisedConfiguration&, std::string_view line);
    void answer(Client&, const identification::ExcavatorSample&, std::string_view line);
    void answer(Client&, const identification::Baseline&, std::string_view line);
    void answer(Client&, const StatusRequest&, std::string_view line);
    void answer(Client&, const LoadRequest&, std::string_view line);
    void answer(Client&, const Ping&, std::string_view line);
    void answer(Client&, const Bye&, std::string_view line);
    void answer(Client&, const AlarmsRequest&, std::string_view line);
    void answer(Client&, const TokenOffer&, std::string_view line);
    void answer(Client&, const Forget&, std::string_view line);
    void answer(Client&, const Acknowledge&, std::string_view line);
    void answer(Client&, const Shelve&, std::string_view line);

    void turn_away_browser(Client& client);
    /// Throws BadMessage and closes the client if the token is wrong.
    void check_token(Client& client, const std::string& token);
    void require_trusted(const Client& client, const Message& message) const;
    /// Throws BadMessage if the hello would exceed the limits of its peer. Makes room for a new machine.
    void require_allowance(const Client& client, const Hello& hello);
    /// Closes the client if the limit of clients is reached and no other client can be closed instead.
    void require_place(Client& client, const Hello& hello);
    /// Returns whether one more client of this peer may get a place that no newcomer can take.
    bool may_keep_place(const std::string& peer) const;
    /// Returns the client among `those` to close in favour of another client of `peer`; null if none may be closed.
    static Client* giving_way(const std::vector<Client*>& those, const std::string& peer, bool preferred);
    void evict(Client& client, const std::string& why, const std::string& right = "a new connection");
    bool is_idle(const std::string& machine) const { return clients_.staying(machine) == 0; }
    void forget(const std::string& machine);
    /// Forgets machines that have sent no sample and had no client for `newcomer_s`.
    void forget_newcomers();
    /// If all places for machines are taken, forgets a machine in favour of a new machine of this peer, and closes the
    /// forgotten machine's clients.
    void make_room(const std::string& peer, bool only_own);
    void change_alarm(Client& client, const AlarmName& name, std::optional<Entry> change, const std::string& what);
    identification::Diagnosis& diagnosis_of(Client& client) const;
    identification::Diagnosis& controlled_by(Client& client) const;
    void tell_load(Client& client, LoadMeter::Clock::time_point now);
    void tell_kept(Client& client);
    void tell_watchers(const std::string& machine, const std::string& line,
                       const std::function<bool(const Hello&)>& to);
    void tell_alarms(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome);
    /// Appends to `history` an entry for each alarm that was raised or cleared.
    void add_history(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome,
                     std::vector<Entry>& history);
    void note_cleared(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& forgotten);
    Load load() const;

    Diagnoses& diagnoses_;
    LoadMeter meter_;
    const ServiceLimits& limits_;
    web::Token token_;
    std::function<void(const std::string&)> say_;
    Peers peers_;
    MachinePlaces places_;
    ClientRegistry clients_;
    Outbox outbox_;
    AlarmBoard alarms_;
    Persistence persistence_;
    NetlistSearches* searches_;
};

} // namespace placedpar::monitor
