// Tests exit codes of failures, with a command that fails on demand.

#include "app/command.hpp"
#include "app/program.hpp"
#include "netlist/kinds/process_kind.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

using namespace placedpar;

namespace {

std::function<void()> to_do;

Action declare_failing(Options&, const std::string&) {
    return [] {
        to_do();
        return ExitCode::success;
    };
}

/// Redirects standard error to a temporary file while it exists.
class Listener {
public:
    Listener() { ::dup2(::fileno(file_.get()), STDERR_FILENO); }
    ~Listener() {
        std::fflush(stderr);
        ::dup2(before_, STDERR_FILENO);
        ::close(before_);
    }
    std::string said() {
        std::fflush(stderr);
        std::rewind(file_.get());
        std::string text(1000, '\0');
        text.resize(std::fread(text.data(), 1, text.size(), file_.get()));
        return text;
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{std::tmpfile(), std::fclose};
    int before_ = ::dup(STDERR_FILENO);
};

struct Outcome {
    int code;
    std::string said;
    bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(std::function<void()> what) {
    to_do = std::move(what);
    std::string program = "placedpar", command = "fail";
    char* arguments[] = {program.data(), command.data()};
    Listener listener;
    int code =
        carry_out({"", "", {{.name = "fail", .about = "", .place = 1, .declare = declare_failing}}}, 2, arguments);
    return {code, listener.said()};
}

} // namespace

TEST_CASE("an error that a user can cause has exit code 1") {
    CHECK(outcome_of([] { throw UserError("no such record"); }) == Outcome{1, "placedpar: no such record\n"});
    CHECK(outcome_of([] { throw RefusedInput("a.cfs:1:1: error\n"); }) == Outcome{1, "a.cfs:1:1: error\n"});
}

TEST_CASE("an error of the operating system is not reported as a defect") {
    CHECK(outcome_of([] { throw std::bad_alloc(); }) == Outcome{1, "placedpar: there is not enough memory\n"});
    Outcome refused = outcome_of([] { static_cast<void>(std::filesystem::file_size("/no/such/file")); });
    CHECK(refused.code == 1);
    CHECK(refused.said.find("No such file or directory") != std::string::npos);
}

TEST_CASE("any other exception is reported as a defect, with exit code 70 and a request to report it") {
    Outcome defect{70, "placedpar: defect of PlacedPar: a link in a knot\n"
                       "please report it, with the command and its input files\n"};
    CHECK(outcome_of([] { throw std::logic_error("a link in a knot"); }) == defect);
    CHECK(outcome_of([] { throw std::invalid_argument("a link in a knot"); }) == defect);
    CHECK(outcome_of([] { throw std::runtime_error("a link in a knot"); }) == defect);
    CHECK(outcome_of([] {}) == Outcome{0, ""});
}

namespace {

/// Returns the outcome of a program with this file name and a kind of process of its own.
Outcome outcome_of_program(std::string program, std::string command, const std::string& kind) {
    char* arguments[] = {program.data(), command.data()};
    Listener listener;
    int code = run_program(2, arguments, {{.name = kind, .about = "for this test"}});
    return {code, listener.said()};
}

} // namespace

TEST_CASE("a program with its own kinds uses its own name in messages") {
    CHECK(outcome_of_program("some/where/farmer", "frobnicate", "own.barn") ==
          Outcome{1, "farmer: unknown command \"frobnicate\"; farmer --help lists the commands\n"});
    CHECK(outcome_of_program("farmer", "kinds", "own.farm") == Outcome{0, ""});
    CHECK(program_name() == "farmer");
}

TEST_CASE("a program's own device with a name that no netlist can use is refused") {
    char program[] = "farmer", command[] = "kinds";
    char* arguments[] = {program, command};
    Listener listener;
    CHECK(run_program(2, arguments, {}, {}, {},
                      {{.name = "ring", .noun = "a ring", .about = "", .models = {{"place"}}}}) == 1);
    CHECK(listener.said() == "farmer: this program adds a device \"place\", but no netlist can use this name: choose "
                             "one word that is not reserved\n");
}

TEST_CASE("a program's own kind with an existing name is refused") {
    CHECK(outcome_of_program("farmer", "kinds", "csp.identity") ==
          Outcome{1, "farmer: this program adds a process kind \"csp.identity\", but the name is taken: choose "
                     "another name, such as \"own.identity\"\n"});
}

namespace {

struct OtherRastrigin {
    static constexpr std::string_view name = "rastrigin", about = "another one";
    static constexpr std::tuple<> numbers() { return {}; }
    ParameterCoding representation() const { return ParameterCoding(1, {0, 1, 4}); }
    double objective(std::span<const double> x) const { return x[0]; }
};

} // namespace

TEST_CASE("a program's own search problem with an existing name is refused") {
    char program[] = "farmer", command[] = "kinds";
    char* arguments[] = {program, command};
    Listener listener;
    CHECK(run_program(2, arguments, {}, {minimised<OtherRastrigin>()}) == 1);
    CHECK(listener.said() == "farmer: this program adds a search problem \"rastrigin\", but the name is taken: choose "
                             "another name, such as \"own.rastrigin\"\n");
}
