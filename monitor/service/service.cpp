#include "monitor/service/service.hpp"

#include "monitor/protocol/answers.hpp"
#include "monitor/service/connection.hpp"
#include "text/user_error.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <fmt/format.h>

#include <atomic>
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

tcp::acceptor listen(asio::io_context& io, const std::string& address, std::uint16_t port) {
    error_code error;
    asio::ip::address parsed = asio::ip::make_address(address, error);
    if (error)
        throw UserError(fmt::format("--address {}: it is no address, expected one such as 127.0.0.1 or ::1", address));
    tcp::acceptor acceptor(io);
    acceptor.open(tcp::endpoint(parsed, port).protocol(), error);
    if (!error)
        acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error)
        acceptor.bind({parsed, port}, error);
    if (!error)
        acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        throw UserError(fmt::format("cannot listen on {} port {}: {}; another --port, or 0 for any free one", address,
                                    port, error.message()));
    return acceptor;
}

} // namespace

class Service::Loop {
public:
    Loop(const ServiceSettings& settings, std::function<void(const std::string&)> say)
        : settings_(settings), say_(std::move(say)), acceptor_(listen(io_, settings.address, settings.port)),
          retry_(io_), ticker_(io_), signals_(io_),
          diagnoses_(settings.diagnosis, settings.seed, settings.limits.machines) {
        settings.diagnosis.validate();
        if (!settings.state.empty()) {
            store_.emplace(settings.state);
            if (std::string said = store_->restore(diagnoses_); !said.empty())
                say_(said);
        }
        dispatcher_.emplace(diagnoses_, store_ ? &*store_ : nullptr, say_);
    }

    std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

    void stop_at_signals() {
        signals_.add(SIGINT);
        signals_.add(SIGTERM);
        signals_.async_wait([this](const error_code& error, int) {
            if (!error)
                stop_now();
        });
    }

    void run() {
        accept();
        tick();
        io_.run();
        disk_.join();
        if (store_)
            store_->write(diagnoses_);
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

    private:
        Connection& connection_;
    };

    struct Guest {
        std::shared_ptr<Connection> connection;
        std::unique_ptr<ConnectedClient> client; ///< null: turned away
    };

    void accept() {
        acceptor_.async_accept([this](const error_code& error, tcp::socket socket) {
            if (stopping_)
                return;
            if (error) { // most likely too many open files: some client will go
                retry_.expires_after(std::chrono::milliseconds(100));
                retry_.async_wait([this](const error_code&) { accept_again(); });
                return;
            }
            welcome(std::move(socket));
            accept();
        });
    }
    void accept_again() {
        if (!stopping_)
            accept();
    }

    void welcome(tcp::socket socket) {
        // Those turned away linger until they have read why: their number is limited, too.
        if (guests_.size() >= 2 * settings_.limits.clients)
            return;
        error_code ignored;
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
        if (dispatcher_->clients() < settings_.limits.clients)
            let_in(guest);
        else
            turn_away(*connection);
    }

    void let_in(Guest& guest) {
        guest.client = std::make_unique<ConnectedClient>(*guest.connection);
        dispatcher_->enter(*guest.client);
        guest.connection->start();
    }

    void turn_away(Connection& connection) {
        connection.send(
            error_line(0, BadMessage("", fmt::format("there are {} clients already", settings_.limits.clients),
                                     "to come again later; --max-clients allows more")));
        connection.finish();
    }

    void take(Connection& from, std::string_view line) {
        if (auto& client = guests_.at(&from).client)
            dispatcher_->take(*client, line);
    }

    void leave(Connection& gone) {
        auto found = guests_.find(&gone);
        if (found == guests_.end())
            return;
        if (found->second.client)
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
        for (const auto& connection : connections) // which may leave meanwhile
            connection->tick(now);
        dispatcher_->tick();
        sync(now);
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

    void sync(Clock::time_point now) {
        if (!store_ || std::chrono::duration<double>(now - last_sync_).count() < settings_.sync_s || syncing_.load() ||
            !dispatcher_->anything_recorded())
            return;
        last_sync_ = now;
        syncing_ = true;
        asio::post(disk_, [this] {
            std::string trouble;
            try {
                store_->sync();
            } catch (const std::exception& error) {
                trouble = error.what();
            }
            syncing_ = false;
            if (!trouble.empty())
                asio::post(io_, [this, trouble] { dispatcher_->journal_failed(trouble); });
        });
    }

    void stop_now() {
        if (std::exchange(stopping_, true))
            return;
        error_code ignored;
        acceptor_.close(ignored);
        retry_.cancel();
        stop_at_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(settings_.limits.closing_s));
        dispatcher_->say_goodbye();
        if (guests_.empty())
            io_.stop();
    }

    ServiceSettings settings_;
    std::function<void(const std::string&)> say_;
    asio::io_context io_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer retry_, ticker_;
    asio::signal_set signals_;
    Diagnoses diagnoses_;
    std::optional<StateStore> store_;
    std::optional<Dispatcher> dispatcher_;
    std::map<Connection*, Guest> guests_;
    std::atomic<bool> syncing_{false};
    Clock::time_point last_sync_{}, stop_at_{};
    bool stopping_ = false;
    asio::thread_pool disk_{1};
};

Service::Service(const ServiceSettings& settings, std::function<void(const std::string&)> say)
    : loop_(std::make_unique<Loop>(settings, std::move(say))) {}

Service::~Service() = default;

std::uint16_t Service::port() const { return loop_->port(); }

void Service::stop_at_signals() { loop_->stop_at_signals(); }

void Service::run() { loop_->run(); }

void Service::stop() { loop_->stop(); }

} // namespace placedpar::monitor
