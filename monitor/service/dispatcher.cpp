#include "monitor/service/dispatcher.hpp"

#include "monitor/memory/settled_estimates.hpp"
#include "monitor/protocol/answers.hpp"
#include "monitor/protocol/link_words.hpp"
#include "monitor/service/alarms_json.hpp"
#include "monitor/service/clock.hpp"
#include "monitor/service/netlist_searches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace placedpar::monitor {

using namespace identification;

namespace {

/// Detects an HTTP request. A foreign web page can make the operator's browser send a request to this service. The
/// service would take the lines of the request's body for messages of a control system.
bool is_http(std::string_view line) { return line.ends_with(" HTTP/1.1") || line.ends_with(" HTTP/1.0"); }

} // namespace

Dispatcher::Dispatcher(Diagnoses& diagnoses, StateStore* store, const ServiceLimits& limits, web::Token token,
                       std::function<void(const std::string&)> say, NetlistSearches* searches)
    : diagnoses_(diagnoses), limits_(limits), token_(std::move(token)), say_(say), peers_(limits), places_(limits),
      persistence_(store, outbox_, std::move(say)), searches_(searches) {
    if (store)
        alarms_.restore(store->noted_alarms());
    std::multimap<std::uint64_t, std::string, std::greater<>> by_samples;
    for (const auto& [name, diagnosis] : diagnoses_.all())
        by_samples.emplace(diagnosis.samples(), name);
    for (const auto& [samples, name] : by_samples)
        places_.restored(name, samples, MachinePlaces::Clock::now());
}

void Dispatcher::enter(Client& client) {
    auto may_come = [](std::size_t may_stay) { return may_stay + std::max<std::size_t>(1, may_stay / 4); };
    auto of_peer = [&](const Client& each) { return each.caller.peer == client.caller.peer; };
    auto require = [&](std::size_t most, const std::function<bool(const Client&)>& counted) {
        if (clients_.those(counted).size() < may_come(most))
            return;
        auto silent = clients_.those([&](const Client& each) { return counted(each) && !each.hello; });
        if (Client* other = giving_way(silent, client.caller.peer, true))
            evict(*other, "this connection has sent no hello yet, and is closed to make room for another client");
    };
    require(limits_.clients_per_peer, of_peer);
    require(limits_.clients, [](const Client&) { return true; });
    client.heard = LoadMeter::Clock::now();
    client.trusted = !token_.wanted();
    clients_.enter(client);
}

void Dispatcher::evict(Client& client, const std::string& why, const std::string& right) {
    outbox_.send(client, error_line(0, BadMessage("", why, right)));
    outbox_.finish(client);
}

Client* Dispatcher::giving_way(const std::vector<Client*>& those, const std::string& peer, bool preferred) {
    std::vector<Occupant> places;
    for (const Client* each : those)
        places.push_back({each->caller.peer, each->keeps_place, false, each->has_samples, each->heard});
    auto found = gives_way(places, peer, preferred);
    return found ? those[*found] : nullptr;
}

bool Dispatcher::may_keep_place(const std::string& peer) const {
    auto kept = clients_.those([](const Client& each) { return each.hello && each.keeps_place; });
    auto own = std::ranges::count_if(kept, [&](const Client* each) { return each->caller.peer == peer; });
    return kept.size() < most_kept(limits_.clients) &&
           static_cast<std::size_t>(own) < most_kept(limits_.clients_per_peer);
}

void Dispatcher::require_place(Client& client, const Hello& hello) {
    const std::string& peer = client.caller.peer;
    bool control = hello.role == Role::control;
    const Client* held = control ? clients_.control_of(hello.machine) : nullptr;
    if (held && held->caller.peer == peer) { // the client replaces a connection of its own peer
        client.keeps_place = held->keeps_place;
        return;
    }
    client.keeps_place = control && places_.known(hello.machine) && may_keep_place(peer);
    auto require = [&](std::size_t most, const char* option, const std::function<bool(const Client&)>& counted) {
        auto others = clients_.those([&](const Client& each) { return each.hello && counted(each); });
        if (client.leaving || others.size() < most)
            return;
        if (Client* other = giving_way(others, peer, client.keeps_place))
            evict(*other, client.keeps_place
                              ? "this connection is closed to make room for a client of a known machine"
                              : "this connection is closed to make room for a peer with fewer connections");
        else
            evict(client, fmt::format("the number of clients has reached its limit of {}", most),
                  fmt::format("a connection at a later time; {} allows more clients", option));
    };
    require(limits_.clients_per_peer, "--max-clients-per-peer",
            [&](const Client& each) { return each.caller.peer == peer; });
    if (!held)
        require(limits_.clients, "--max-clients", [](const Client&) { return true; });
}

void Dispatcher::leave(Client& client) {
    outbox_.drop(client);
    clients_.leave(client);
    if (!client.hello)
        return;
    const std::string& machine = client.hello->machine;
    say_(fmt::format("{}: {} disconnected", machine, client.caller.name));
    if (diagnoses_.knows(machine))
        places_.heard(machine, diagnoses_.named(machine).samples(), MachinePlaces::Clock::now());
}

void Dispatcher::take(Client& client, std::string_view line) {
    if (client.leaving)
        return;
    auto begin = client.heard = LoadMeter::Clock::now();
    try {
        if (is_http(line))
            return turn_away_browser(client);
        Message message = parse_message(line);
        require_trusted(client, message);
        std::visit([&](const auto& each) { answer(client, each, line); }, message);
    } catch (const BadMessage& bad) {
        outbox_.send(client, error_line(client.lines(), bad));
    } catch (const RefusedSample& refused) {
        outbox_.send(client, error_line(client.lines(), BadMessage(refused)));
    }
    meter_.count_work(LoadMeter::Clock::now() - begin);
}

void Dispatcher::turn_away_browser(Client& client) {
    say_(fmt::format("{} sent an HTTP request", client.caller.name));
    outbox_.send(client, error_line(client.lines(),
                                    BadMessage("", "the line is an HTTP request",
                                               "one JSON object in each line; browsers find the page at the port of "
                                               "--http")));
    outbox_.finish(client);
}

Diagnosis& Dispatcher::diagnosis_of(Client& client) const {
    if (!client.hello)
        throw BadMessage("type", "this connection has sent no hello yet",
                         "first {\"type\":\"hello\",\"version\":1,\"machine\":\"name\"}");
    return diagnoses_.named(client.hello->machine);
}

Diagnosis& Dispatcher::controlled_by(Client& client) const {
    Diagnosis& diagnosis = diagnosis_of(client);
    if (client.hello->role != Role::control)
        throw BadMessage("type", "a watcher may only ask; it may not send samples or changes",
                         "status, load, ping or bye; \"role\":\"control\" in hello");
    return diagnosis;
}

void Dispatcher::check_token(Client& client, const std::string& token) {
    if (!token_.wanted() || token_.is(token)) {
        client.trusted = true;
        return;
    }
    say_(fmt::format("{} sent a wrong token or no token", client.caller.name));
    outbox_.send(client, error_line(client.lines(), BadMessage("token", "the token is wrong",
                                                               "the token in the file of --token-file")));
    outbox_.finish(client);
}

void Dispatcher::require_trusted(const Client& client, const Message& message) const {
    if (!client.trusted && !std::holds_alternative<Hello>(message) && !std::holds_alternative<TokenOffer>(message))
        throw BadMessage("token", "not authenticated", "{\"type\":\"token\",\"token\":\"...\"} first");
}

void Dispatcher::require_allowance(const Client& client, const Hello& hello) {
    if (hello.role != Role::control)
        return;
    const std::string& peer = client.caller.peer;
    if (!diagnoses_.knows(hello.machine)) {
        if (places_.introduced_by(peer) >= limits_.machines_per_peer)
            make_room(peer, true);
        if (places_.introduced_by(peer) >= limits_.machines_per_peer)
            throw BadMessage(
                "machine",
                fmt::format("{} has announced as many machines as it may: {}", peer, limits_.machines_per_peer),
                "one of these machines; --max-machines-per-peer allows more");
        if (diagnoses_.full())
            make_room(peer, false);
    } else if (clients_.control_of(hello.machine) && !peers_.take_over(peer, Peers::Clock::now()))
        throw BadMessage(
            "machine",
            fmt::format("the takeovers by {} have reached the limit of {} a minute", peer, limits_.takeovers_per_peer),
            "a pause before the next takeover; --max-takeovers allows more takeovers");
}

void Dispatcher::forget(const std::string& machine) {
    diagnoses_.forget(machine);
    alarms_.forget(machine);
    places_.forgotten(machine);
    persistence_.forget(machine);
    if (searches_)
        searches_->forget(machine);
}

void Dispatcher::forget_newcomers() {
    auto patience =
        std::chrono::duration_cast<MachinePlaces::Clock::duration>(std::chrono::duration<double>(limits_.newcomer_s));
    for (const std::string& machine : places_.unused_since(MachinePlaces::Clock::now() - patience))
        if (is_idle(machine))
            forget(machine);
}

void Dispatcher::make_room(const std::string& peer, bool only_own) {
    auto machine = places_.gives_way(peer, only_own, [&](const std::string& each) { return is_idle(each); });
    if (!machine)
        return;
    for (Client* client : clients_.of(*machine))
        if (!client->leaving)
            evict(*client, "this machine is forgotten to make room for a peer with fewer machines");
    if (std::uint64_t samples = diagnoses_.named(*machine).samples(); samples > 0)
        say_(fmt::format("{}: forgotten to make room for a new machine; number of its samples: {}", *machine, samples));
    forget(*machine);
}

void Dispatcher::answer(Client& client, const Hello& hello, std::string_view) {
    if (client.hello)
        throw BadMessage("type", fmt::format("this connection already has the machine \"{}\"", client.hello->machine),
                         "another connection");
    if (!client.trusted)
        check_token(client, hello.token);
    if (client.leaving)
        return;
    require_place(client, hello);
    if (client.leaving)
        return;
    require_allowance(client, hello);
    bool known = diagnoses_.knows(hello.machine);
    SampleOutcome forgotten;
    if (known && hello.anew)
        forgotten.cleared = diagnoses_.named(hello.machine).alarms();
    if (hello.anew && searches_)
        searches_->forget(hello.machine);
    Diagnosis& diagnosis = diagnoses_.greet(hello);
    if (!known)
        places_.introduced(hello.machine, client.caller.peer, MachinePlaces::Clock::now());
    places_.heard(hello.machine, diagnosis.samples(), MachinePlaces::Clock::now());
    client.hello = hello;
    client.greeted();
    Client* other = clients_.join(client);
    if (hello.role == Role::control)
        persistence_.save(diagnosis);
    if (other) { // the old connection may be half open if its control system has gone
        outbox_.send(*other, plain_line("closing", "another control system has taken over this machine"));
        outbox_.finish(*other);
    }
    say_(fmt::format("{}: {} {}{}", hello.machine, client.caller.name,
                     hello.role == Role::control ? "is its control system" : "watches",
                     other ? fmt::format(", in place of {}", other->caller.name) : ""));
    outbox_.send(client, welcome_line(diagnosis, diagnoses_.seed()));
    client.told_kept = persistence_.well();
    if (!client.told_kept) // sent after the welcome, which may wait for the disk
        outbox_.send(client, kept_line(persistence_.well(), persistence_.trouble()));
    if (hello.role == Role::control)
        note_cleared(diagnosis, forgotten);
}

/// Clears the alarms of a machine whose data is deleted, because no later event would clear these alarms.
void Dispatcher::note_cleared(const Diagnosis& diagnosis, const SampleOutcome& forgotten) {
    std::vector<Entry> history;
    add_history(diagnosis, forgotten, history);
    for (Entry& entry : history)
        persistence_.change_history(std::move(entry));
    tell_alarms(diagnosis, forgotten);
}

template <typename Change>
void Dispatcher::configure(Client& client, const Change& change, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    SettledEstimates settled(diagnosis);
    const SampleOutcome outcome = diagnosis.change(change);
    std::vector<Entry> history;
    std::ranges::move(settled.ended(diagnosis, now_at()), std::back_inserter(history));
    add_history(diagnosis, outcome, history);
    persistence_.record(client, diagnosis.name(), line, 0, std::move(history));
    tell_watchers(diagnosis.name(), configured_line(diagnosis), [](const Hello&) { return true; });
    tell_alarms(diagnosis, outcome);
    if (searches_)
        searches_->follow(diagnosis);
}

void Dispatcher::answer(Client& client, const ConfigurationChange& change, std::string_view line) {
    configure(client, change, line);
}

void Dispatcher::answer(Client& client, const RecognisedConfiguration& change, std::string_view line) {
    if (!controlled_by(client).can_recognise())
        throw BadMessage("configuration", "it is \"auto\", but the time between samples does not suit the recognition",
                         "\"a\" to \"e\", or a period_s of .02 s, or of a fraction of .02 s, in hello");
    configure(client, change, line);
}

void Dispatcher::answer(Client& client, const ExcavatorSample& sample, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    SettledEstimates settled(diagnosis);
    SampleOutcome outcome = diagnosis.take(sample);
    client.has_samples = true;
    if (places_.heard(diagnosis.name(), diagnosis.samples(), client.heard))
        client.keeps_place = may_keep_place(client.caller.peer);
    meter_.count_sample(outcome.generations);
    std::vector<Entry> history;
    std::ranges::move(settled.ended(diagnosis, now_at()), std::back_inserter(history));
    add_history(diagnosis, outcome, history);
    persistence_.record(client, diagnosis.name(), line, outcome.generations, std::move(history));
    tell_watchers(diagnosis.name(), estimates_line(diagnosis, outcome, diagnoses_.settings()), [&](const Hello& hello) {
        return hello.answers == Answers::all || (hello.answers == Answers::moved && outcome.generations > 0);
    });
    tell_alarms(diagnosis, outcome);
    if (searches_)
        searches_->follow(diagnosis);
}

void Dispatcher::answer(Client& client, const Baseline& baseline, std::string_view line) {
    Diagnosis& diagnosis = controlled_by(client);
    SampleOutcome outcome = diagnosis.set_baseline(baseline);
    std::vector<Entry> history;
    add_history(diagnosis, outcome, history);
    persistence_.record(client, diagnosis.name(), line, 0, std::move(history));
    outbox_.send(client, status_line(diagnosis, diagnoses_.settings()));
    tell_alarms(diagnosis, outcome);
}

void Dispatcher::answer(Client& client, const StatusRequest&, std::string_view) {
    outbox_.send(client, status_line(diagnosis_of(client), diagnoses_.settings()));
}

void Dispatcher::answer(Client& client, const LoadRequest&, std::string_view) {
    client.greeted();
    outbox_.send(client, load_line(load()));
}

void Dispatcher::answer(Client& client, const Ping&, std::string_view) {
    client.greeted();
    outbox_.send(client, plain_line("pong"));
}

void Dispatcher::answer(Client& client, const Bye&, std::string_view) {
    outbox_.send(client, plain_line("closing", "bye"));
    outbox_.finish(client);
}

void Dispatcher::answer(Client& client, const AlarmsRequest&, std::string_view) {
    client.greeted();
    outbox_.send(client, alarms_line(alarms_.all()));
}

void Dispatcher::answer(Client& client, const TokenOffer& offer, std::string_view) {
    check_token(client, offer.token);
    if (client.leaving)
        return;
    client.greeted();
    outbox_.send(client, plain_line("accepted"));
}

void Dispatcher::answer(Client& client, const Forget& order, std::string_view) {
    client.greeted();
    if (!diagnoses_.knows(order.machine))
        throw BadMessage("machine", fmt::format("unknown machine \"{}\"", order.machine), "a known machine");
    if (!is_idle(order.machine))
        throw BadMessage(
            "machine",
            fmt::format("\"{1}\" still has open connections: {0}", clients_.staying(order.machine), order.machine),
            "a machine without connections; for a machine in use, a hello with \"anew\":true");
    forget(order.machine);
    say_(fmt::format("{}: forgotten at the request of {}", order.machine, client.caller.name));
    outbox_.send(client, plain_line("forgotten", order.machine));
}

void Dispatcher::answer(Client& client, const Acknowledge& order, std::string_view) {
    change_alarm(client, order.alarm, alarms_.acknowledge(order.alarm, now_at()), "acknowledged");
}

void Dispatcher::answer(Client& client, const Shelve& order, std::string_view) {
    change_alarm(client, order.alarm, alarms_.shelve(order.alarm, now_at() + order.for_s, now_at()),
                 order.for_s > 0 ? fmt::format("shelved for {} s", order.for_s) : "no longer shelved");
}

/// Stores the change of an alarm that a client demanded, and answers with all active alarms.
void Dispatcher::change_alarm(Client& client, const AlarmName& name, std::optional<Entry> change,
                              const std::string& what) {
    client.greeted();
    if (!change)
        throw BadMessage("alarm",
                         fmt::format("\"{}\" has no alarm \"{}\"{}{}", name.machine, name.kind,
                                     name.links.empty() ? "" : " of ", name.links),
                         "a present alarm, as {\"type\":\"alarms\"} lists it");
    persistence_.change_history(std::move(*change));
    say_(fmt::format("{}: alarm {} {} {} by {}", name.machine, name.kind, name.links, what, client.caller.name));
    outbox_.send(client, alarms_line(alarms_.all()));
}

void Dispatcher::tell(const NetlistAnswer& answer) {
    const std::string text = print_netlist_answer(answer);
    say_(fmt::format("{}: answer of the netlist's processes for {}, samples from {:.2f} to {:.2f} s: {}",
                     answer.machine, words_of(answer.set), answer.from_s, answer.to_s,
                     text.substr(0, text.find('\n'))));
    tell_watchers(answer.machine, netlist_line(answer),
                  [](const Hello& hello) { return hello.answers != Answers::none; });
}

void Dispatcher::tell_watchers(const std::string& machine, const std::string& line,
                               const std::function<bool(const Hello&)>& to) {
    for (Client* client : clients_.of(machine))
        if (to(*client->hello))
            outbox_.send(*client, line);
}

void Dispatcher::tell_alarms(const Diagnosis& diagnosis, const SampleOutcome& outcome) {
    auto tell = [&](const Alarm& alarm, bool raised) {
        if (alarms_.shelved(diagnosis.name(), alarm, now_at()))
            return;
        say_(fmt::format("{}: alarm {} {} {}: {}", diagnosis.name(), name_of(alarm.kind), words_of(alarm.links),
                         raised ? "raised" : "cleared", alarm.text));
        tell_watchers(diagnosis.name(), alarm_line(diagnosis, alarm, raised), [](const Hello&) { return true; });
    };
    for (const Alarm& alarm : outcome.raised)
        tell(alarm, true);
    for (const Alarm& alarm : outcome.cleared)
        tell(alarm, false);
}

void Dispatcher::add_history(const Diagnosis& diagnosis, const SampleOutcome& outcome, std::vector<Entry>& history) {
    for (const Alarm& alarm : outcome.raised)
        history.push_back(alarms_.raise(diagnosis, alarm, now_at()));
    for (const Alarm& alarm : outcome.cleared)
        history.push_back(alarms_.clear(diagnosis.name(), alarm, now_at()));
}

void Dispatcher::note(const WriteProgress& progress) {
    auto begin = LoadMeter::Clock::now();
    if (persistence_.note(progress))
        for (Client* client : clients_.all())
            if (client->hello)
                tell_kept(*client);
    outbox_.release(progress.transactions);
    meter_.count_turn(LoadMeter::Clock::now() - begin);
}

ServiceSnapshot Dispatcher::snapshot() const {
    return {&diagnoses_, load(), alarms_.all(), persistence_.well(), persistence_.trouble(), searches_};
}

Load Dispatcher::load() const {
    Load load = meter_.load();
    load.clients = clients();
    load.machines = diagnoses_.all().size();
    load.queued_bytes = clients_.queued_bytes();
    return load;
}

void Dispatcher::tick() {
    auto begin = LoadMeter::Clock::now();
    meter_.tick();
    persistence_.tick(alarms_);
    forget_newcomers();
    for (Client* client : clients_.all())
        if (client->hello) {
            tell_kept(*client);
            tell_load(*client, begin);
        }
    meter_.count_turn(LoadMeter::Clock::now() - begin);
}

/// Tells the client whether data is stored. Sends the message at once and not through the outbox, because the outbox
/// would hold the message back until data is stored.
void Dispatcher::tell_kept(Client& client) {
    if (std::exchange(client.told_kept, persistence_.well()) != persistence_.well())
        client.send(kept_line(persistence_.well(), persistence_.trouble()));
}

void Dispatcher::tell_load(Client& client, LoadMeter::Clock::time_point now) {
    double every_s = client.hello->load_every_s;
    if (every_s > 0 && std::chrono::duration<double>(now - client.last_load).count() >= every_s) {
        client.last_load = now;
        outbox_.send(client, load_line(load()));
    }
}

void Dispatcher::say_goodbye() {
    for (Client* client : clients_.all()) {
        outbox_.send(*client, plain_line("closing", "the monitor stops"));
        outbox_.finish(*client);
    }
}

} // namespace placedpar::monitor
