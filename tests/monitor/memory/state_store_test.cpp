#include "monitor/memory/diagnosis_json.hpp"
#include "monitor/memory/state_store.hpp"
#include "scratch.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
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

Diagnoses none() { return {DiagnosisSettings{}, 1, 10}; }

std::string text_of(const Diagnoses& diagnoses) {
    std::string text;
    for (const auto& [name, machine] : diagnoses.all())
        text += boost::json::serialize(state_json(machine.state()));
    return text;
}

/// What the service does with a message.
void take(Diagnoses& diagnoses, StateStore& store, const std::string& message) {
    diagnoses.replay("m", message);
    store.record("m", message, 5);
}

/// A store that saw a hello, a configuration and samples, and was never closed properly.
void run(const Scratch& scratch, Diagnoses& diagnoses, int samples) {
    StateStore store(scratch / "state");
    store.restore(diagnoses);
    take(diagnoses, store, hello);
    take(diagnoses, store, configuration);
    for (int i = 0; i < samples; ++i)
        take(diagnoses, store, sample(i));
}

} // namespace

TEST_CASE("a killed service comes back to the bit") {
    Scratch scratch;
    Diagnoses before = none(), after = none();
    run(scratch, before, 20);
    CHECK(before.all().at("m").sets().begin()->second.state().generations > 0);
    std::string said = StateStore(scratch / "state").restore(after);
    CHECK(said.find("1 machine restored, 22 messages taken again") != std::string::npos);
    CHECK(text_of(after) == text_of(before));
    // What has been taken again is in the state file now.
    Diagnoses again = none();
    CHECK(StateStore(scratch / "state").restore(again).find("taken again") == std::string::npos);
    CHECK(text_of(again) == text_of(before));
}

TEST_CASE("a torn journal loses its last message at most") {
    Scratch scratch;
    Diagnoses whole = none();
    run(scratch, whole, 12);
    std::string journal = scratch.read("state.journal"), state = scratch.read("state");
    Diagnoses shorter = none();
    {
        Scratch other;
        run(other, shorter, 11);
    }
    std::size_t last = journal.rfind('\n', journal.size() - 2) + 1;
    for (std::size_t size = last; size < journal.size(); size += 23) {
        scratch.write("state.journal", journal.substr(0, size));
        scratch.write("state", state);
        Diagnoses restored = none();
        std::string said = StateStore(scratch / "state").restore(restored);
        CHECK(text_of(restored) == text_of(shorter));
        CHECK((said.find("torn") != std::string::npos) == (size > last));
    }
}

TEST_CASE("a kill between the state file and the journal repeats nothing") {
    Scratch scratch;
    Diagnoses diagnoses = none();
    run(scratch, diagnoses, 12);
    std::string journal = scratch.read("state.journal");
    Diagnoses restored = none();
    StateStore(scratch / "state").restore(restored); // writes the state file
    scratch.write("state.journal", journal);         // as if the journal had not been emptied
    Diagnoses again = none();
    StateStore(scratch / "state").restore(again);
    CHECK(text_of(again) == text_of(diagnoses));
}

TEST_CASE("nothing is appended behind what a full disk lost") {
    Scratch scratch;
    Diagnoses diagnoses = none(), restored = none();
    {
        StateStore store(scratch / "state");
        store.restore(diagnoses);
        take(diagnoses, store, hello);
        std::string before = text_of(diagnoses);
        {
            FullDisk disk(scratch.read("state.journal").size() + 20);
            CHECK_THROWS_WITH_AS(take(diagnoses, store, configuration), doctest::Contains("cannot be appended to"),
                                 UserError);
            CHECK_THROWS_WITH_AS(store.write(diagnoses), doctest::Contains("cannot be written"), UserError);
        }
        CHECK_FALSE(store.complete());
        CHECK(store.due());
        for (int i = 0; i < 12; ++i)
            take(diagnoses, store, sample(i));
        // A kill now: what was known before the hole.
        Scratch copy;
        copy.write("state", scratch.read("state"));
        copy.write("state.journal", scratch.read("state.journal"));
        Diagnoses earlier = none();
        StateStore(copy / "state").restore(earlier);
        CHECK(text_of(earlier) == before);

        store.write(diagnoses);
        CHECK(store.complete());
        CHECK_FALSE(store.due());
        take(diagnoses, store, sample(12));
    }
    StateStore(scratch / "state").restore(restored);
    CHECK(text_of(restored) == text_of(diagnoses));
}

TEST_CASE("a state file that cannot be written leaves the journal as it was") {
    Scratch scratch;
    Diagnoses diagnoses = none(), restored = none();
    {
        StateStore store(scratch / "state");
        store.restore(diagnoses);
        take(diagnoses, store, hello);
        take(diagnoses, store, configuration);
        {
            FullDisk disk(100);
            CHECK_THROWS_AS(store.write(diagnoses), UserError);
        }
        CHECK(store.complete());
        take(diagnoses, store, sample(0));
    }
    StateStore(scratch / "state").restore(restored);
    CHECK(text_of(restored) == text_of(diagnoses));
}

TEST_CASE("what does not come to the disk does not take the state file's name") {
    Scratch scratch;
    Diagnoses diagnoses = none();
    StateStore store(scratch / "state");
    store.restore(diagnoses);
    std::string state = scratch.read("state");
    take(diagnoses, store, hello);
    std::filesystem::create_symlink("/dev/null", scratch / "state.next"); // which takes all and syncs nothing
    CHECK_THROWS_WITH_AS(store.write(diagnoses), doctest::Contains("state.next: cannot be brought to the disk"),
                         UserError);
    CHECK(scratch.read("state") == state);
    CHECK(store.complete());
}

TEST_CASE("no state file: what it is instead, and what to do") {
    Scratch scratch;
    auto refused = [&](const char* text, const char* because) {
        scratch.write("state", text);
        Diagnoses diagnoses = none();
        std::string said;
        try {
            StateStore(scratch / "state").restore(diagnoses);
        } catch (const UserError& error) {
            said = error.what();
        }
        CAPTURE(text);
        CHECK(said == fmt::format("{0}: this state file cannot be used: {1}; put a whole one there, or move it and "
                                  "{0}.journal away and begin with nothing known",
                                  (scratch / "state").string(), because));
        CHECK(scratch.read("state") == text);
    };
    refused("", "it is empty");
    refused("{\"placedpar_monitor_state\":1,\"sett", "it breaks off after 34 bytes");
    refused("rubbish", "it is no state file of the monitor");
    refused("{}", "it is no state file of the monitor");
    refused("[1]", "it is no state file of the monitor");
    refused("{\"placedpar_monitor_state\":1}", "a part of it is missing");
    refused("{\"placedpar_monitor_state\":\"one\"}", "a part of it is wrong: not a number");
    scratch.write("state", "{\"placedpar_monitor_state\":7}");
    Diagnoses diagnoses = none();
    CHECK_THROWS_WITH_AS(StateStore(scratch / "state").restore(diagnoses),
                         doctest::Contains("it is of another version than 1; use another --state file"), UserError);
    std::filesystem::create_directory(scratch / "folder");
    CHECK_THROWS_WITH_AS(StateStore(scratch / "folder"), doctest::Contains("folder: it is a folder"), UserError);
    CHECK_FALSE(std::filesystem::exists(scratch / "folder.journal"));
    auto nowhere = (scratch / "none" / "state").string();
    CHECK_THROWS_WITH_AS(
        StateStore{nowhere},
        fmt::format("--state {0}: {0}.journal: cannot be opened: No such file or directory", nowhere).c_str(),
        UserError);
}

TEST_CASE("files that do not fit are refused by name") {
    Scratch scratch;
    Diagnoses diagnoses = none();
    run(scratch, diagnoses, 3);
    auto refused = [&](Diagnoses&& others, const char* because) {
        CHECK_THROWS_WITH_AS(StateStore(scratch / "state").restore(others), doctest::Contains(because), UserError);
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
    CHECK_NOTHROW(StateStore(scratch / "state").restore(diagnoses = none()));
}

TEST_CASE("machines are known with one set of parameters") {
    Diagnoses diagnoses = none();
    diagnoses.replay("m", hello);
    diagnoses.replay("m", configuration);
    CHECK_NOTHROW(diagnoses.replay("m", hello));
    CHECK(diagnoses.named("m").active() == LinkSet{Link::boom});
    CHECK_THROWS_WITH_AS(diagnoses.replay("m", R"({"type":"hello","version":1,"machine":"m","period_s":0.01})"),
                         doctest::Contains("other parameters"), BadMessage);
    diagnoses.replay("m", R"({"type":"hello","version":1,"machine":"m","period_s":0.01,"anew":true})");
    CHECK(diagnoses.named("m").active().empty());
    CHECK_THROWS_AS(diagnoses.replay("x", R"({"type":"hello","version":1,"machine":"x","role":"watch"})"), BadMessage);
    for (int i = 1; i < 10; ++i)
        diagnoses.replay("", fmt::format(R"({{"type":"hello","version":1,"machine":"m{}"}})", i));
    CHECK_THROWS_WITH_AS(diagnoses.replay("", R"({"type":"hello","version":1,"machine":"eleventh"})"),
                         doctest::Contains("10 machines already"), BadMessage);
}
