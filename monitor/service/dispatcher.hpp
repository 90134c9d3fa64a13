#pragma once

#include "monitor/memory/diagnoses.hpp"
#include "monitor/service/client_registry.hpp"
#include "monitor/service/load_meter.hpp"
#include "monitor/service/metrics.hpp"
#include "monitor/service/peers.hpp"
#include "monitor/service/persistence.hpp"
#include "monitor/service/places.hpp"
#include "monitor/service/token.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// Takes the clients' messages to the diagnoses and the answers back. Knows nothing of sockets. One overload of
/// answer() for each message of the protocol.
class Dispatcher {
public:
    /// `store` may be null: nothing is kept. `say` is given sentences for the operator. REQUIRES: the limits outlive
    /// it.
    Dispatcher(Diagnoses& diagnoses, StateStore* store, const ServiceLimits& limits, Token token,
               std::function<void(const std::string&)> say);

    /// Lets it in. Where too many are about to say hello, one of the peer with most of them is closed for it.
    void enter(Client& client);
    void leave(Client& client);
    /// A line of the client. Answers go to it, and to the others that watch its machine.
    void take(Client& client, std::string_view line);
    /// Sends loads when they are due; tells clients whether all is kept. To be called a few times a second.
    void tick();
    /// How far the state file has come, or what has been lost.
    void note(const WriteProgress& progress);
    /// To all clients, which are then closed.
    void say_goodbye();
    /// Keeps everything. Throws UserError.
    void finish() { persistence_.finish(alarms_); }

    ServiceSnapshot snapshot() const;

    /// Without those that are about to be closed.
    std::size_t clients() const { return clients_.size(); }

private:
    void answer(Client&, const Hello&, std::string_view line);
    void answer(Client&, const identification::ConfigurationChange&, std::string_view line);
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
    /// Throws BadMessage, and has the client closed, when the token is not the right one.
    void check_token(Client& client, const std::string& token);
    void require_trusted(const Client& client, const Message& message) const;
    /// Throws BadMessage when the hello would take more than its peer may have. Makes room for a new machine.
    void require_allowance(const Client& client, const Hello& hello);
    /// Has the client closed when as many have said hello as may and none gives way to it.
    void require_place(Client& client, const Hello& hello);
    /// May the place of one more connection of this peer be kept?
    bool may_keep_place(const std::string& peer) const;
    /// The one of these that gives way to another client of the peer; null: none does.
    static Client* giving_way(const std::vector<Client*>& those, const std::string& peer, bool preferred);
    void evict(Client& client, const std::string& why, const std::string& right = "to come again");
    bool is_idle(const std::string& machine) const { return clients_.staying(machine) == 0; }
    void forget(const std::string& machine);
    /// Those that nobody has been connected to for long.
    void forget_newcomers();
    /// Forgets the machine that gives way to a new one of this peer, if one does, and closes its connections.
    void make_room(const std::string& peer, bool only_own);
    void change_alarm(Client& client, const AlarmName& name, std::optional<Entry> change, const std::string& what);
    identification::Diagnosis& diagnosis_of(Client& client) const;
    identification::Diagnosis& controlled_by(Client& client) const;
    void tell_load(Client& client, LoadMeter::Clock::time_point now);
    void tell_kept(Client& client);
    void tell_watchers(const std::string& machine, const std::string& line,
                       const std::function<bool(const Hello&)>& to);
    void tell_alarms(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome);
    /// Of the alarms that have been raised or cleared.
    void add_history(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome,
                     std::vector<Entry>& history);
    void note_cleared(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& forgotten);
    Load load() const;

    Diagnoses& diagnoses_;
    LoadMeter meter_;
    const ServiceLimits& limits_;
    Token token_;
    std::function<void(const std::string&)> say_;
    Peers peers_;
    MachinePlaces places_;
    ClientRegistry clients_;
    Outbox outbox_;
    AlarmBoard alarms_;
    Persistence persistence_;
};

} // namespace placedpar::monitor
