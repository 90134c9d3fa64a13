// This program measures the on-line diagnosis under load: first four links of one machine at 50 samples per second,
// then many machines, at the same rate and then as fast as the service answers. The service runs in its own thread, and
// clients use TCP as control systems do. Every pressure moves all the time, so the service makes generations for every
// sample. In practice transients are a small part of a machine's day.
//
//     monitor_load [SAMPLES [CLIENTS]]      samples of each client in each part; clients in the last three parts

#include "monitor/service/service.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/identification/on_line/transient.hpp"
#include "text/statistics.hpp"

#include <CLI/CLI.hpp>
#include <boost/asio.hpp>
#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace asio = boost::asio;
namespace json = boost::json;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

/// The time between the samples of a paced client. The times stated in the samples are always 20 ms apart.
std::chrono::milliseconds period{20};

struct Part {
    const char* name;
    const char* configuration;
    const char* active; // active links, as JSON
    std::vector<const char*> links;
    std::size_t clients;
    bool paced;
};

/// Returns a sample of a machine with the compliances below. The pressures swing by 300 psi at 0.8 Hz, so their slope
/// is 1066 psi/s rms.
std::string sample_line(const Part& part, std::size_t index) {
    using namespace placedpar;
    using namespace placedpar::hydraulics;
    using namespace placedpar::identification;
    static constexpr std::array<double, 4> compliances{0.0150, 0.0086, 0.0200, 0.0300};
    LinkSet active;
    for (const char* symbol : part.links)
        active.insert(*link_named(symbol));
    Transient transient(*configuration_named(part.configuration), active, compliances);
    transient.slope_psi_per_s.fill(0);
    transient.curvature_psi_per_s2 = 0;
    transient.swing_psi = 300;
    transient.swing_rad_per_s = 5;
    ExcavatorSample sample = transient.sample(0, index);
    std::string links;
    for (Link link : links_of(active)) {
        const Reading& reading = *sample.links[index_of(link)];
        const auto& areas = std::get<ValveAreas>(reading.valve);
        links += fmt::format(R"({}"{}":{{"inlet_psi":{:.6f},"angle_deg":{:.8f},"inlet_in2":{},"bypass_in2":{:.8f}}})",
                             links.empty() ? "" : ",", symbol_of(link), reading.inlet_psi, reading.angle_deg,
                             areas.inlet_in2, areas.bypass_in2);
    }
    return fmt::format("{{\"type\":\"sample\",\"time_s\":{:.2f},\"links\":{{{}}}}}\n", sample.time_s, links);
}

/// A control system that says hello and then sends samples, either at fixed intervals or as soon as the previous sample
/// is answered.
class ControlSystem : public std::enable_shared_from_this<ControlSystem> {
public:
    ControlSystem(asio::io_context& io, const Part& part, std::size_t number, std::size_t samples)
        : socket_(io), timer_(io), part_(part), name_(fmt::format("{}-{}", part.name, number)), samples_(samples) {}

    void start(const tcp::endpoint& service) {
        socket_.connect(service);
        socket_.set_option(tcp::no_delay(true));
        say(fmt::format("{{\"type\":\"hello\",\"version\":1,\"machine\":\"{}\"}}\n", name_));
        say(fmt::format("{{\"type\":\"configuration\",\"configuration\":\"{}\",\"active\":{}}}\n", part_.configuration,
                        part_.active));
        due_ = Clock::now();
        listen();
        next();
    }

    std::vector<double> latencies_ms;
    std::string last_answer, load;

private:
    void say(std::string line) {
        outgoing_.push_back(std::move(line));
        if (outgoing_.size() == 1)
            write();
    }
    void write() {
        asio::async_write(socket_, asio::buffer(outgoing_.front()),
                          [self = shared_from_this()](const boost::system::error_code& error, std::size_t) {
                              if (error)
                                  return;
                              self->outgoing_.pop_front();
                              if (!self->outgoing_.empty())
                                  self->write();
                          });
    }
    void next() {
        if (sent_ == samples_)
            return;
        sent_at_.push_back(Clock::now());
        say(sample_line(part_, sent_++));
        if (!part_.paced)
            return;
        due_ += period;
        timer_.expires_at(due_);
        timer_.async_wait([self = shared_from_this()](const boost::system::error_code&) { self->next(); });
    }
    void listen() {
        asio::async_read_until(socket_, incoming_, '\n',
                               [self = shared_from_this()](const boost::system::error_code& error, std::size_t) {
                                   if (error)
                                       return;
                                   std::istream in(&self->incoming_);
                                   std::string line;
                                   std::getline(in, line);
                                   self->hear(line);
                               });
    }
    void hear(const std::string& line) {
        if (line.starts_with("{\"type\":\"error\"")) {
            fmt::print(stderr, "{}\n", line);
            std::exit(1);
        }
        if (line.starts_with("{\"type\":\"estimates\"")) {
            latencies_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - sent_at_.front()).count());
            sent_at_.pop_front();
            last_answer = line;
            if (!part_.paced)
                next();
            if (latencies_ms.size() == samples_)
                say("{\"type\":\"load\"}\n");
        } else if (line.starts_with("{\"type\":\"load\"")) {
            load = line;
            socket_.close();
            return;
        }
        listen();
    }

    tcp::socket socket_;
    asio::steady_timer timer_;
    asio::streambuf incoming_;
    std::deque<std::string> outgoing_;
    std::deque<Clock::time_point> sent_at_;
    const Part& part_;
    std::string name_;
    std::size_t samples_, sent_ = 0;
    Clock::time_point due_;
};

double field(const std::string& line, const char* name) { return json::parse(line).at(name).to_number<double>(); }

/// Adds the bits of an answer's compliances to the fingerprint.
void mix(placedpar::Fingerprint& fingerprint, const std::string& answer) {
    json::value value = json::parse(answer);
    for (const auto& set : value.at("sets").as_object())
        for (const auto& link : set.value().at("links").as_object())
            if (const json::value& c = link.value().at("compliance_in3_per_psi"); c.is_number())
                fingerprint.mix(std::bit_cast<std::uint64_t>(c.to_number<double>()));
}

/// Runs a part, and prints its cost to the service. `state` is the folder of the state file; if it is empty, there is
/// no state file.
void run(const Part& part, std::size_t samples, const std::string& state) {
    placedpar::monitor::ServiceSettings settings;
    settings.limits.clients = settings.limits.clients_per_peer = part.clients + 1;
    settings.limits.machines_per_peer = settings.limits.machines;
    if (!state.empty())
        settings.state = fmt::format("{}/{}.state", state, part.name);
    placedpar::monitor::Log nowhere(-1);
    placedpar::monitor::Service service(settings, nowhere);
    std::thread thread([&] { service.run(); });
    asio::io_context io;
    std::vector<std::shared_ptr<ControlSystem>> systems;
    auto begin = Clock::now();
    for (std::size_t i = 0; i < part.clients; ++i) {
        systems.push_back(std::make_shared<ControlSystem>(io, part, i, samples));
        systems.back()->start({asio::ip::make_address("127.0.0.1"), service.port()});
    }
    io.run();
    double took_s = std::chrono::duration<double>(Clock::now() - begin).count();
    service.stop();
    thread.join();

    std::vector<double> latencies_ms;
    placedpar::Fingerprint fingerprint;
    double work_s = 0, cpu_s = 0, turn_s = 0;
    for (const auto& system : systems) {
        latencies_ms.insert(latencies_ms.end(), system->latencies_ms.begin(), system->latencies_ms.end());
        mix(fingerprint, system->last_answer);
        work_s = std::max(work_s, field(system->load, "work_s"));
        cpu_s = std::max(cpu_s, field(system->load, "cpu_s"));
        turn_s = std::max(turn_s, field(system->load, "longest_turn_s"));
    }
    std::sort(latencies_ms.begin(), latencies_ms.end());
    double count = static_cast<double>(latencies_ms.size());
    fmt::print("{:<22} {:>7} {:>10.0f} {:>9.1f} {:>9.1f} {:>11.1f} {:>9.2f} {:>9.2f} {:>9.2f} {:>10.2f}   {:016x}\n",
               part.name, part.clients, count / took_s, 100 * work_s / took_s, 100 * cpu_s / took_s,
               1e6 * cpu_s / count, placedpar::lower_median(latencies_ms), placedpar::quantile(latencies_ms, 0.99),
               latencies_ms.back(), 1e3 * turn_s, fingerprint.value());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) try {
    CLI::App command{
        "Measures the on-line diagnosis under load: its cost to the service, and the waiting time of clients"};
    std::size_t samples = 250, clients = 200;
    command.add_option("SAMPLES", samples, "number of samples of each client")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command.add_option("CLIENTS", clients, "number of clients in the last three parts")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    std::string state;
    command.add_option("--state", state, "store the state of the diagnosis in this folder, which must be empty")
        ->check(CLI::ExistingDirectory);
    int period_ms = 20;
    command.add_option("--period", period_ms, "time between the samples of a paced client, in ms")
        ->check(CLI::Range(1, 60000))
        ->capture_default_str();
    CLI11_PARSE(command, argc, argv);
    period = std::chrono::milliseconds(period_ms);
    const std::vector<Part> parts{
        {"four-links", "d", R"(["BU","BO","ST","SW"])", {"BU", "BO", "ST", "SW"}, 1, true},
        {"two-sets-of-two", "a", R"(["BU","BO","ST","SW"])", {"BU", "BO", "ST", "SW"}, 1, true},
        {"booms-at-rest", "a", R"([])", {"BO"}, clients, true},
        {"booms-at-50-per-s", "a", R"(["BO"])", {"BO"}, clients, true},
        {"booms-flat-out", "a", R"(["BO"])", {"BO"}, clients, false},
    };
    fmt::print("{} samples of each client, 5 generations of 120 individuals for each sample; a latency is the time "
               "from a sample to its answer\n",
               samples);
    fmt::print("{:<22} {:>7} {:>10} {:>9} {:>9} {:>11} {:>9} {:>9} {:>9} {:>10}   {}\n", "", "clients", "samples/s",
               "work [%]", "cpu [%]", "us a sample", "p50 [ms]", "p99 [ms]", "max [ms]", "turn [ms]", "fingerprint");
    for (const Part& part : parts)
        run(part, samples, state);
} catch (const std::exception& error) {
    fmt::print(stderr, "monitor_load: {}\n", error.what());
    return 1;
}
