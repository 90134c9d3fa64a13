// The readers of the monitor, of studies and of experiments. Fuzzing them is a study: all rooms have to be compiled.

#include "experiments/kit/kept_runs.hpp"
#include "gaprocs/policies/nouns.hpp"
#include "gaprocs/representation/representation.hpp"
#include "monitor/memory/state_file.hpp"
#include "monitor/protocol/bad_message.hpp"
#include "monitor/protocol/message.hpp"
#include "tests/fuzz/reader.hpp"
#include "text/user_error.hpp"
#include "workbench/study/measure.hpp"
#include "workbench/study/results.hpp"
#include "workbench/study/setting_value.hpp"
#include "workbench/study/study_file.hpp"
#include "workbench/study/summary.hpp"
#include "workbench/time_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace placedpar::fuzz {

namespace {

/// A file in memory, alone in its folder.
std::string file_of(const std::string& content, const std::string& name) {
    const std::string folder = fmt::format("/dev/shm/placedpar-fuzz-{}", ::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    std::ofstream(folder + "/" + name, std::ios::binary) << content;
    return folder + "/" + name;
}

void read_study_text(const std::string& text) { read_study(file_of(text, "study.toml")); }

std::string content_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A good file in which the input replaces bytes, three for each: two say where, one what is there instead.
std::string patched(std::string good, const std::string& input) {
    auto byte = [&](std::size_t at) { return static_cast<unsigned char>(input[at]); };
    for (std::size_t at = 0; at + 2 < input.size(); at += 3)
        good[(byte(at) * 256u + byte(at + 1)) % good.size()] = input[at + 2];
    return good;
}

std::string made_results() {
    const std::string path = file_of("", "results.sqlite");
    {
        StudyResults results(path, {"ring.cfs", {{"ring.cfs", "host h;"}}, "{}"});
        results.set_measures({"time"});
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            results.keep({{{"n", "1"}}, seed}, {.ended = "completed", .figures = {{"time", {0.1, "ms"}}}});
    }
    return content_of(path);
}

void read_results(const std::string& patches) {
    static const std::string good = made_results();
    StudyResults results(file_of(patched(good, patches), "results.sqlite"));
    summary_of(results);
}

void read_kept_runs(const std::string& text) {
    const std::string path = file_of(text, "kept");
    KeptRuns(path, "fuzz").add("another", 1, {0.1, -0.0});
    require(KeptRuns(path, "fuzz").find("another", 1) == Figures{0.1, -0.0}, "what is kept is found");
}

void read_message(const std::string& line) {
    try {
        monitor::parse_message(line);
    } catch (const monitor::BadMessage&) { // it is answered so
    }
}

std::string made_state() {
    const std::string path = file_of("", "state");
    {
        monitor::StateContent content;
        monitor::StateFile file(path, "settings", 10, content);
    }
    return content_of(path);
}

void read_state(const std::string& patches) {
    static const std::string good = made_state();
    monitor::StateContent content;
    monitor::StateFile file(file_of(patched(good, patches), "state"), "settings", 10, content);
}

template <class Read>
void attempt_to(Read read) {
    try {
        read();
    } catch (const UserError&) { // it is another text
    }
}

void read_policies(const std::string& text) {
    for (const Noun& noun : policy_nouns())
        attempt_to([&] {
            if (noun.policies.empty())
                return;
            for (double number : read_policy(text, noun.policies).numbers)
                require(std::isfinite(number), "a policy's numbers are finite");
            const std::string printed = noun.printed(text);
            require(noun.printed(printed) == printed, "a policy is read as it is printed");
        });
}

void read_strings(const std::string& text) {
    const Representation representations[] = {BitString(5), RealVector({{-2, 2}, {0, 1e300}}), Permutation(4)};
    for (const Representation& each : representations)
        attempt_to([&] {
            Genome genome = each.read(text);
            require(each.read(each.text(genome)) == genome, "a string is read as it is printed");
        });
}

void read_command_line(const std::string& text) {
    attempt_to([&] { parse_time(text); });
    attempt_to([&] { StudyMeasure{text}; });
    attempt_to([&] { StudyCondition{text}; });
    attempt_to([&] {
        const StudyAxis axis = read_axis(text);
        if (axis.count() > 0)
            axis.at(axis.count() - 1);
    });
    SettingValue value("clock", text);
    require(value == SettingValue("clock", value.spelling()), "a value is equal to itself");
    attempt_to([&] {
        std::string figures;
        try {
            figures = figures_text(figures_from(text));
        } catch (const std::exception&) {
            return; // a row is refused so
        }
        require(figures_text(figures_from(figures)) == figures, "figures are read as they are written");
    });
}

} // namespace

std::span<const Reader> readers() {
    static const Reader all[] = {{"study", read_study_text},  {"results", read_results},
                                 {"kept", read_kept_runs},    {"message", read_message},
                                 {"state", read_state},       {"arguments", read_command_line},
                                 {"policies", read_policies}, {"strings", read_strings}};
    return all;
}

} // namespace placedpar::fuzz
