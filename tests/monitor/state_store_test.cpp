#include "app/monitor/machine_json.hpp"
#include "app/monitor/state_store.hpp"
#include "scratch.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::monitor;

namespace {

const std::string hello = R"({"type":"hello","version":1,"machine":"m"})",
                  configuration = R"({"type":"configuration","configuration":"a","active":["BO"]})";

std::string sample(int i) {
    double t = 0.020 * i;
    return fmt::format(R"({{"type":"sample","time_s":{},"links":{{"BO":{{"inlet_psi":{},"angle_deg":{},)"
                       R"("inlet_in2":0.1,"bypass_in2":0.03}}}}}})",
                       t, 1500 + 1700.1 * t - 300.3 * t * t, 2.7 * t + 0.1 * std::sin(40 * t));
}

Machines none() { return {DiagnosisSettings{}, 1, 10}; }

std::string text_of(const Machines& machines) {
    std::string text;
    for (const auto& [name, machine] : machines.all())
        text += boost::json::serialize(state_json(machine.state()));
    return text;
}

/// What the service does with a message.
void take(Machines& machines, StateStore& store, const std::string& message) {
    machines.replay("m", message);
    store.record("m", message, 5);
}

/// A store that saw a hello, a configuration and samples, and was never closed properly.
void run(const Scratch& scratch, Machines& machines, int samples) {
    StateStore store(scratch / "state");
    store.restore(machines);
    take(machines, store, hello);
    take(machines, store, configuration);
    for (int i = 0; i < samples; ++i)
        take(machines, store, sample(i));
}

} // namespace

TEST_CASE("a killed service comes back to the bit") {
    Scratch scratch;
    Machines before = none(), after = none();
    run(scratch, before, 20);
    CHECK(before.all().at("m").sets().begin()->second.state().generations > 0);
    std::string said = StateStore(scratch / "state").restore(after);
    CHECK(said.find("1 machine restored, 22 messages taken again") != std::string::npos);
    CHECK(text_of(after) == text_of(before));
    // What has been taken again is in the state file now.
    Machines again = none();
    CHECK(StateStore(scratch / "state").restore(again).find("taken again") == std::string::npos);
    CHECK(text_of(again) == text_of(before));
}

TEST_CASE("a torn journal loses its last message at most") {
    Scratch scratch;
    Machines whole = none();
    run(scratch, whole, 12);
    std::string journal = scratch.read("state.journal"), state = scratch.read("state");
    Machines shorter = none();
    {
        Scratch other;
        run(other, shorter, 11);
    }
    std::size_t last = journal.rfind('\n', journal.size() - 2) + 1;
    for (std::size_t size = last; size < journal.size(); size += 23) {
        scratch.write("state.journal", journal.substr(0, size));
        scratch.write("state", state);
        Machines restored = none();
        std::string said = StateStore(scratch / "state").restore(restored);
        CHECK(text_of(restored) == text_of(shorter));
        CHECK((said.find("torn") != std::string::npos) == (size > last));
    }
}

TEST_CASE("a kill between the state file and the journal repeats nothing") {
    Scratch scratch;
    Machines machines = none();
    run(scratch, machines, 12);
    std::string journal = scratch.read("state.journal");
    Machines restored = none();
    StateStore(scratch / "state").restore(restored); // writes the state file
    scratch.write("state.journal", journal);         // as if the journal had not been emptied
    Machines again = none();
    StateStore(scratch / "state").restore(again);
    CHECK(text_of(again) == text_of(machines));
}

TEST_CASE("files that do not fit are refused by name") {
    Scratch scratch;
    Machines machines = none();
    run(scratch, machines, 3);
    auto refused = [&](Machines&& others, const char* because) {
        CHECK_THROWS_WITH_AS(StateStore(scratch / "state").restore(others), doctest::Contains(because),
                             std::runtime_error);
    };
    refused({DiagnosisSettings{}, 2, 10}, "--seed 1");
    DiagnosisSettings small;
    small.search.population = 60;
    refused({small, 1, 10}, "--population 120");
    std::string state = scratch.read("state");
    scratch.write("state", "rubbish");
    refused(none(), "this state file cannot be used");
    scratch.write("state", state.substr(0, state.size() / 2));
    refused(none(), "this state file cannot be used");
    std::filesystem::remove(scratch / "state");
    refused(none(), "a later state file");
    scratch.write("state", state);
    CHECK_NOTHROW(StateStore(scratch / "state").restore(machines = none()));
}

TEST_CASE("machines are known with one set of parameters") {
    Machines machines = none();
    machines.replay("m", hello);
    machines.replay("m", configuration);
    CHECK_NOTHROW(machines.replay("m", hello));
    CHECK(machines.named("m").active() == LinkSet{MachineLink::boom});
    CHECK_THROWS_WITH_AS(machines.replay("m", R"({"type":"hello","version":1,"machine":"m","period_s":0.01})"),
                         doctest::Contains("other parameters"), BadMessage);
    machines.replay("m", R"({"type":"hello","version":1,"machine":"m","period_s":0.01,"anew":true})");
    CHECK(machines.named("m").active().empty());
    CHECK_THROWS_AS(machines.replay("x", R"({"type":"hello","version":1,"machine":"x","role":"watch"})"), BadMessage);
    for (int i = 1; i < 10; ++i)
        machines.replay("", fmt::format(R"({{"type":"hello","version":1,"machine":"m{}"}})", i));
    CHECK_THROWS_WITH_AS(machines.replay("", R"({"type":"hello","version":1,"machine":"eleventh"})"),
                         doctest::Contains("10 machines already"), BadMessage);
}
