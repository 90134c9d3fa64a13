// The sieve of Eratosthenes as a pipeline (Hoare, Communicating Sequential Processes, CACM 21, 1978, section 6.1; an
// idea of McIlroy's). The first number that a csp.sieve gets is a prime. The process keeps the prime, and passes on the
// numbers that are not multiples of the prime.

#include "classics/kinds.hpp"

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "runtime/executive.hpp"

namespace placedpar {

namespace {

constexpr std::int64_t end_of_numbers = 0;

void count_up(ProcessEnvironment& environment) {
    auto to = environment.output<Packet>("out");
    for (std::int64_t number = 2; number <= environment.integer("last"); ++number)
        to.output({number});
    to.output({end_of_numbers});
}

/// The output of a csp.sieve. If this output is not connected, as at the end of the pipeline, numbers are dropped.
class Onwards {
public:
    explicit Onwards(const ProcessEnvironment& environment) : connected_(environment.connected("out")) {
        if (connected_)
            out_ = environment.output<Packet>("out");
    }
    void pass(std::int64_t number) {
        passed_ += number != end_of_numbers;
        if (connected_)
            out_.output({number});
    }
    std::int64_t passed() const { return passed_; }

private:
    bool connected_;
    Output<Packet> out_;
    std::int64_t passed_ = 0;
};

void sieve(ProcessEnvironment& environment) {
    auto from = environment.input<Packet>("in");
    Onwards onwards(environment);
    Cycles division{environment.integer("cycles")};
    std::int64_t prime = from.input().number, number = prime;
    while (number != end_of_numbers) {
        number = from.input().number;
        compute(division);
        if (number != end_of_numbers && number % prime != 0)
            onwards.pass(number);
    }
    onwards.pass(end_of_numbers);
    environment.measure("prime", static_cast<double>(prime));
    environment.measure("passed", static_cast<double>(onwards.passed()));
}

ProcessKind numbers() {
    using namespace description;
    return {
        .name = "csp.numbers",
        .about = "Outputs 2, 3, 4 and so on, then an end message.",
        .ports = {packets_out("out", "numbers")},
        .parameters = {integer("last", {.by_default = 100, .least = 2, .most = 1e9}, "the last number that is output")},
        .body = count_up};
}

ProcessKind sieve_process() {
    using namespace description;
    return {.name = "csp.sieve",
            .about =
                "Keeps the first number, which is a prime, and passes on the numbers that this prime does not divide.",
            .ports = {packets_in("in", "numbers"), optional(packets_out("out", "numbers"))},
            .parameters = {integer("cycles", {.unit = "cycles", .by_default = 40, .least = 0, .most = 1e9},
                                   "workload: a division by the prime")},
            .measurements = {{"prime", "", "the prime of this process; 0: no number arrived"},
                             {"passed", "", "numbers passed on"}},
            .body = sieve};
}

} // namespace

std::vector<ProcessKind> sieve_kinds() { return {numbers(), sieve_process()}; }

} // namespace placedpar
