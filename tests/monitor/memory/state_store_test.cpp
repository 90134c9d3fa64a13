#include "monitor/memory/diagnoses.hpp"
#include "monitor/memory/diagnosis_json.hpp"
#include "monitor/memory/state_store.hpp"
#include "scratch.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <thread>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

const std::string configuration = R"({"type":"configuration","configuration":"a","active":["BO"]})";

std::string sample(int i) {
    double t = 0.020 * i;
    return fmt::format(R"({{"type":"sample","time_s":{},"links":{{"BO":{{"inlet_psi":{},"angle_deg":{},)"
                       R"("inlet_in2":0.1,"bypass_in2":0.03}}}}}})",
                       t, 1500 + 1700.1 * t - 300.3 * t * t, 2.7 * t + 0.1 * std::sin(40 * t));
}

Diagnoses none() { return {DiagnosisSettings{}, 1, 10}; }

std::string text_of(const Diagnoses& diagnoses) {
    std::string text;
    for (const auto& [name, machine] : diagnoses.all())
        text += boost::json::serialize(state_json(machine.state()));
    return text;
}

/// A store with its diagnoses, and the messages about its progress.
struct Running {
    Diagnoses diagnoses = none();
    StateStore store;
    std::mutex mutex;
    std::vector<WriteProgress> told;

    explicit Running(const std::filesystem::path& path) : store(path, diagnoses, 100) {
        store.start([this](WriteProgress progress) {
            std::lock_guard lock(mutex);
            told.push_back(std::move(progress));
        });
    }
    void hello(const std::string& machine) {
        Hello hello;
        hello.machine = machine;
        hello.parameters = excavator_parameters(Parameters::excavator());
        store.save(diagnoses.greet(hello));
    }
    void take(const std::string& machine, const std::string& message, std::size_t generations = 5) {
        diagnoses.replay(machine, message);
        store.record(machine, message, generations, {});
        store.relieve();
    }
    /// Waits until everything handed to the store is written or lost.
    void settle() {
        for (bool done = store.last_ticket() == 0; !done; std::this_thread::yield()) {
            std::lock_guard lock(mutex);
            for (const WriteProgress& progress : told)
                store.note(progress);
            done = !told.empty() && told.back().transactions >= store.last_ticket();
        }
    }
};

/// Copies the state file as a kill would leave it now.
void kill(const Scratch& from, const Scratch& to) { to.write("state", from.read("state")); }

std::string known_after(const Scratch& scratch, std::string* said = nullptr) {
    Diagnoses diagnoses = none();
    StateStore store(scratch / "state", diagnoses, 100);
    if (said)
        *said = store.said();
    return text_of(diagnoses);
}

} // namespace

TEST_CASE("a killed service restores its state to the bit") {
    Scratch scratch, killed;
    Running running(scratch / "state");
    running.hello("m");
    running.take("m", configuration);
    for (int i = 0; i < 20; ++i)
        running.take("m", sample(i));
    running.settle();
    kill(scratch, killed);
    CHECK(running.diagnoses.all().at("m").sets().begin()->second.state().generations > 0);
    std::string said;
    CHECK(known_after(killed, &said) == text_of(running.diagnoses));
    CHECK(said.find("1 machine restored, 21 messages processed again") != std::string::npos);
    // The messages processed again are now part of the machine's state.
    CHECK(known_after(killed, &said) == text_of(running.diagnoses));
    CHECK(said.find("1 machine restored") != std::string::npos);
    CHECK(said.find("processed again") == std::string::npos);
}

TEST_CASE("an incomplete sample survives a restart") {
    ExcavatorParameters parameters = excavator_parameters(Parameters::excavator());
    parameters.period_s = 0.001;
    auto machine = [&] {
        Diagnosis diagnosis("m", parameters, {}, 1);
        diagnosis.change({Configuration::a, {Link::boom}});
        return diagnosis;
    };
    auto reading = [](int i) {
        ExcavatorSample sample{0.001 * i, {}};
        sample.links[index_of(Link::boom)] =
            Reading{1500 + 1.7 * i - 0.0003 * i * i, 0.0027 * i, ServoVoltage{0.0001 * i}};
        return sample;
    };
    Diagnosis whole = machine(), broken = machine();
    for (int i = 0; i < 507; ++i) {
        whole.take(reading(i));
        broken.take(reading(i));
    }
    const auto kept = boost::json::parse(boost::json::serialize(state_json(broken.state())));
    Diagnosis back(state_from(kept, {}), {}, 1);
    for (int i = 507; i < 900; ++i) {
        whole.take(reading(i));
        back.take(reading(i));
    }
    CHECK(whole.state().sample_s.has_value());
    CHECK(back.state() == whole.state());
}

TEST_CASE("a long backlog is merged into states, beginning with the oldest machine") {
    Scratch scratch, killed;
    Running running(scratch / "state");
    for (const char* machine : {"a", "b", "c"}) {
        running.hello(machine);
        running.take(machine, configuration);
    }
    for (int i = 0; i < 12; ++i)
        for (const char* machine : {"a", "b", "c"})
            running.take(machine, sample(i), 5000);
    running.settle();
    kill(scratch, killed);
    std::string said;
    CHECK(known_after(killed, &said) == text_of(running.diagnoses));
    CHECK(said.find("3 machines restored, ") != std::string::npos);
    auto again = std::stoi(said.substr(said.find("restored, ") + 10));
    CHECK(again <= 20); // out of 39: repeating all their generations would take too long
    CHECK(again >= 8);
}

TEST_CASE("a machine that was forgotten and announced again has its new state") {
    Scratch scratch, killed;
    Running running(scratch / "state");
    for (int i = 0; i < 2; ++i) {
        running.hello("m");
        running.take("m", configuration);
        running.take("m", sample(i));
        if (i == 0) {
            running.diagnoses.forget("m");
            running.store.forget("m");
        }
    }
    running.settle();
    kill(scratch, killed);
    CHECK(known_after(killed) == text_of(running.diagnoses));
    running.diagnoses.forget("m");
    running.store.forget("m");
    running.settle();
    kill(scratch, killed);
    CHECK(known_after(killed).empty());
}

TEST_CASE("after a full disk nothing is appended until the file is rewritten") {
    Scratch scratch, killed;
    Running running(scratch / "state");
    running.hello("m");
    running.settle();
    std::string before = text_of(running.diagnoses);
    {
        FullDisk disk(1);
        running.take("m", configuration);
        running.settle();
        CHECK_FALSE(running.store.complete());
        CHECK(running.told.back().trouble.find("state: cannot be written: ") != std::string::npos);
        running.store.write_anew({}, 0);
        running.settle();
        CHECK_FALSE(running.store.complete());
        CHECK_FALSE(running.store.keeping());
    }
    for (int i = 0; i < 12; ++i)
        running.take("m", sample(i));
    kill(scratch, killed);
    CHECK(known_after(killed) == before);

    running.store.write_anew({}, 0);
    running.take("m", sample(12));
    running.settle();
    CHECK(running.store.complete());
    kill(scratch, killed);
    CHECK(known_after(killed) == text_of(running.diagnoses));
}

TEST_CASE("a clean end leaves one file and no backlog") {
    Scratch scratch;
    Running running(scratch / "state");
    running.hello("m");
    running.take("m", configuration);
    running.store.write_anew({}, 0);
    running.store.finish();
    CHECK_FALSE(std::filesystem::exists(scratch / "state-journal"));
    std::string said;
    CHECK(known_after(scratch, &said) == text_of(running.diagnoses));
    CHECK(said.find("processed again") == std::string::npos);
}

TEST_CASE("a machine's second set of parameters is refused") {
    Diagnoses diagnoses = none();
    auto greet = [&](const std::string& text) -> Diagnosis& {
        return diagnoses.greet(std::get<Hello>(parse_message(text)));
    };
    greet(R"({"type":"hello","version":1,"machine":"m"})");
    diagnoses.replay("m", configuration);
    CHECK_NOTHROW(greet(R"({"type":"hello","version":1,"machine":"m"})"));
    CHECK(diagnoses.named("m").active() == LinkSet{Link::boom});
    CHECK_THROWS_WITH_AS(greet(R"({"type":"hello","version":1,"machine":"m","period_s":0.01})"),
                         doctest::Contains("other parameters"), BadMessage);
    greet(R"({"type":"hello","version":1,"machine":"m","period_s":0.01,"anew":true})");
    CHECK(diagnoses.named("m").active().empty());
    CHECK_THROWS_AS(greet(R"({"type":"hello","version":1,"machine":"x","role":"watch"})"), BadMessage);
    for (int i = 1; i < 10; ++i)
        greet(fmt::format(R"({{"type":"hello","version":1,"machine":"m{}"}})", i));
    CHECK_THROWS_WITH_AS(greet(R"({"type":"hello","version":1,"machine":"eleventh"})"),
                         doctest::Contains("has as many machines as it may: 10"), BadMessage);
}
