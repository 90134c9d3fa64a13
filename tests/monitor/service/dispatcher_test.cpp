#include "monitor/service/dispatcher.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::monitor;

namespace {

/// A connection that keeps what the service sends to it.
struct HeardClient : Client {
    explicit HeardClient(const std::string& peer) { caller = {peer, peer, ""}; }
    void send(std::string_view line) override { said += line; }
    void finish() override { finished = true; }
    void greeted() override {}
    bool finishing() const override { return finished; }
    std::size_t lines() const override { return 1; }
    std::size_t queued_bytes() const override { return 0; }
    void hold(std::ptrdiff_t) override {}

    std::string said;
    bool finished = false;
};

/// A service that starts with these machines, with this many samples each, from a state file.
struct Restarted {
    Restarted(std::vector<std::string> machines, std::uint64_t samples) {
        for (const std::string& name : machines) {
            const auto kind = identification::excavator_parameters(hydraulics::Parameters::excavator());
            auto state = identification::Diagnosis(name, kind, diagnoses.settings(), 1).state();
            state.samples = samples;
            diagnoses.add(std::move(state));
        }
        dispatcher = std::make_unique<Dispatcher>(diagnoses, nullptr, limits, web::Token(), [](const std::string&) {});
    }
    HeardClient& hello(const std::string& machine, const std::string& peer) {
        HeardClient& client = *clients.emplace_back(std::make_unique<HeardClient>(peer));
        dispatcher->enter(client);
        dispatcher->take(client, fmt::format(R"({{"type":"hello","version":1,"machine":"{}"}})", machine));
        return client;
    }

    ServiceLimits limits;
    Diagnoses diagnoses{identification::DiagnosisSettings{}, 1, limits.machines};
    std::unique_ptr<Dispatcher> dispatcher;
    std::vector<std::unique_ptr<HeardClient>> clients;
};

} // namespace

TEST_CASE("a machine of the state file gets a connection even if 256 peers hold all places") {
    Restarted service({"site", "other-site"}, 10);
    for (std::size_t i = 0; i < service.limits.clients; ++i)
        CHECK(service.hello(fmt::format("flood-{}", i), fmt::format("10.0.0.{}", i)).said.find("welcome") !=
              std::string::npos);
    const HeardClient& site = service.hello("site", "192.0.2.1");
    CHECK(site.said.find("\"welcome\"") != std::string::npos);
    CHECK_FALSE(site.finished);
    CHECK(service.clients.front()->said.find(
              "this connection is closed to make room for a client of a known machine") != std::string::npos);
    const HeardClient& stranger = service.hello("stranger", "192.0.2.1");
    CHECK(stranger.said.find("has reached its limit of 256") != std::string::npos);
    for (std::size_t i = 0; i < 1000; ++i)
        service.hello(fmt::format("flood-{}", i), fmt::format("10.0.{}.{}", 1 + i / 250, i % 250));
    CHECK_FALSE(site.finished); // the machine keeps its place
    CHECK(service.hello("other-site", "192.0.2.2").said.find("\"welcome\"") != std::string::npos);
}

TEST_CASE("a machine without samples keeps no place, even if the state file has it") {
    Restarted service({"site"}, 0);
    for (std::size_t i = 0; i < service.limits.clients; ++i)
        service.hello(fmt::format("flood-{}", i), fmt::format("10.0.0.{}", i));
    CHECK(service.hello("site", "192.0.2.1").said.find("has reached its limit of 256") != std::string::npos);
}
