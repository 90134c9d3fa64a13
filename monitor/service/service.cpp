#include "monitor/service/service.hpp"

#include "monitor/protocol/answers.hpp"
#include "monitor/service/connection.hpp"
#include "monitor/service/dispatcher.hpp"
#include "monitor/service/netlist_searches.hpp"
#include "monitor/service/site.hpp"
#include "monitor/service/systemd.hpp"
#include "text/user_error.hpp"
#include "web/listener.hpp"
#include "web/token.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::monitor {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::chrono::milliseconds tick_period{100};

web::Token token_for(const ServiceSettings& settings) {
    if (!settings.token_file.empty())
        return web::Token(settings.token_file);
    if ((settings.port || settings.http_port) && !web::is_loopback(settings.address))
        throw UserError(fmt::format("--address {}: anyone who can reach this address could change the diagnosis "
                                    "of any machine; add --token-file FILE, or use an address of this computer "
                                    "only, such as 127.0.0.1",
                                    settings.address));
    return {};
}

} // namespace

class Service::Loop {
public:
    Loop(const ServiceSettings& settings, Log& log)
        : settings_(settings), log_(log), ticker_(io_), signals_(io_),
          diagnoses_(settings.diagnosis, settings.seed, settings.limits.machines) {
        settings.diagnosis.validate();
        doors_.reserve(3);
        if (settings.port)
            doors_.push_back(web::Listener::at_port(io_, settings.address, *settings.port, "--port"));
        web::Token token = token_for(settings);
        if (!settings.state.empty()) {
            store_.emplace(settings.state, diagnoses_, settings.limits.history);
            if (!store_->said().empty())
                log_.say(store_->said());
        }
        if (settings.http_port)
            page_door_.emplace(web::Listener::at_port(io_, settings.address, *settings.http_port, "--http"));
        if (!settings.unix_path.empty())
            doors_.push_back(web::Listener::at_path(io_, settings.unix_path));
        auto say = [this](const std::string& sentence) { log_.say(sentence); };
        if (settings.netlist)
            searches_.emplace(settings.netlist, settings.diagnosis.bits, io_,
                              [this](const NetlistAnswer& answer) { dispatcher_->tell(answer); });
        dispatcher_.emplace(diagnoses_, store_ ? &*store_ : nullptr, settings_.limits, token, say,
                            searches_ ? &*searches_ : nullptr);
        site_.emplace(io_, *dispatcher_, store_ ? &*store_ : nullptr, std::move(token),
                      web::HostNames(settings.address, settings.host_names), say);
        if (store_)
            store_->start([this](WriteProgress progress) {
                asio::post(io_, [this, progress = std::move(progress)] { dispatcher_->note(progress); });
            });
    }

    std::uint16_t port() const { return settings_.port ? doors_.front().port() : std::uint16_t{0}; }
    std::uint16_t http_port() const { return page_door_ ? page_door_->port() : std::uint16_t{0}; }

    void heed_signals() {
        signals_.add(SIGINT);
        signals_.add(SIGTERM);
        if (!log_.is_terminal())
            signals_.add(SIGHUP);
        heed_next_signal();
    }

    void run() {
        for (web::Listener& door : doors_)
            door.open([this](web::Listener::Socket socket, const web::Caller& caller) {
                welcome(std::move(socket), caller);
            });
        if (page_door_)
            page_door_->open([this](web::Listener::Socket socket, const web::Caller& caller) {
                site_->welcome(std::move(socket), caller);
            });
        if (std::string trouble = tell_systemd("READY=1"); !trouble.empty())
            log_.say(trouble); // only the first failure is reported, because later calls fail for the same reason
        tick();
        io_.run();
        dispatcher_->finish();
    }

    void stop() {
        asio::post(io_, [this] { stop_now(); });
    }

private:
    using Clock = std::chrono::steady_clock;

    /// A client whose messages go over a connection.
    class ConnectedClient final : public Client {
    public:
        explicit ConnectedClient(Connection& connection) : connection_(connection) {}
        void send(std::string_view line) override { connection_.send(line); }
        void finish() override { connection_.finish(); }
        void greeted() override { connection_.greeted(); }
        bool finishing() const override { return connection_.finishing(); }
        std::size_t lines() const override { return connection_.lines(); }
        std::size_t queued_bytes() const override { return connection_.queued_bytes(); }
        void hold(std::ptrdiff_t bytes) override { connection_.hold(bytes); }

    private:
        Connection& connection_;
    };

    struct Guest {
        std::shared_ptr<Connection> connection;
        std::unique_ptr<ConnectedClient> client;
    };

    void welcome(web::Listener::Socket socket, const web::Caller& caller) {
        if (stopping_)
            return;
        // A closed connection stays until its client has read the reason, so the number of such connections is limited
        // too.
        auto lingers = [](const auto& guest) { return guest.first->finishing(); };
        if (guests_.size() >= 2 * settings_.limits.clients + 2) {
            auto found = std::ranges::find_if(guests_, lingers);
            if (found == guests_.end())
                return;
            std::shared_ptr<Connection>(found->second.connection)->close();
        }
        error_code ignored; // a Unix-domain socket has no such options
        socket.set_option(tcp::no_delay(true), ignored);
        socket.set_option(asio::socket_base::keep_alive(true), ignored);
        auto connection = std::make_shared<Connection>(
            std::move(socket), settings_.limits,
            Connection::Handlers{[this](Connection& from, std::string_view line) { take(from, line); },
                                 [](const std::string& wrong, const std::string& right) {
                                     return error_line(0, BadMessage("", wrong, right));
                                 },
                                 [this](Connection& gone) { leave(gone); }});
        Guest& guest = guests_[connection.get()];
        guest.connection = connection;
        auto client = std::make_unique<ConnectedClient>(*connection);
        client->caller = caller;
        dispatcher_->enter(*client);
        guest.client = std::move(client);
        connection->start();
    }

    void take(Connection& from, std::string_view line) { dispatcher_->take(*guests_.at(&from).client, line); }

    void leave(Connection& gone) {
        auto found = guests_.find(&gone);
        if (found == guests_.end())
            return;
        dispatcher_->leave(*found->second.client);
        guests_.erase(found);
        if (stopping_ && guests_.empty())
            io_.stop();
    }

    void tick() {
        auto now = Clock::now();
        std::vector<std::shared_ptr<Connection>> connections;
        for (const auto& [key, guest] : guests_)
            connections.push_back(guest.connection);
        for (const auto& connection : connections) // the loop uses a copy, because a connection may remove itself
            connection->tick(now);
        dispatcher_->tick();
        log_.tick();
        if (now >= next_sign_of_life_) {
            tell_systemd("WATCHDOG=1");
            next_sign_of_life_ = now + std::chrono::seconds(1);
        }
        if (stopping_ && now >= stop_at_) {
            io_.stop();
            return;
        }
        ticker_.expires_after(tick_period);
        ticker_.async_wait([this](const error_code& error) {
            if (!error)
                tick();
        });
    }

    void heed_next_signal() {
        signals_.async_wait([this](const error_code& error, int number) {
            if (error)
                return;
            if (number != SIGHUP)
                return stop_now();
            log_.reopen();
            heed_next_signal();
        });
    }

    void stop_now() {
        if (std::exchange(stopping_, true))
            return;
        for (web::Listener& door : doors_)
            door.close();
        if (page_door_)
            page_door_->close();
        site_->close();
        tell_systemd("STOPPING=1");
        stop_at_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(settings_.limits.closing_s));
        dispatcher_->say_goodbye();
        if (guests_.empty())
            io_.stop();
    }

    ServiceSettings settings_;
    Log& log_;
    asio::io_context io_{1};
    std::vector<web::Listener> doors_;
    std::optional<web::Listener> page_door_;
    asio::steady_timer ticker_;
    asio::signal_set signals_;
    Diagnoses diagnoses_;
    std::optional<StateStore> store_;
    std::optional<Dispatcher> dispatcher_;
    std::map<Connection*, Guest> guests_;
    std::optional<Site> site_;
    std::optional<NetlistSearches> searches_;
    Clock::time_point stop_at_{}, next_sign_of_life_{};
    bool stopping_ = false;
};

Service::Service(const ServiceSettings& settings, Log& log) : loop_(std::make_unique<Loop>(settings, log)) {}

Service::~Service() = default;

std::uint16_t Service::port() const { return loop_->port(); }

std::uint16_t Service::http_port() const { return loop_->http_port(); }

void Service::heed_signals() { loop_->heed_signals(); }

void Service::run() { loop_->run(); }

void Service::stop() { loop_->stop(); }

} // namespace placedpar::monitor
