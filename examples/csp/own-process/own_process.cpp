// A process kind of our own, and with it the whole command line for netlists.

#include <placedpar/app/program.hpp>
#include <placedpar/netlist/kinds/environment.hpp>
#include <placedpar/netlist/kinds/packet.hpp>

using namespace placedpar;

/// Takes in `count` packets and passes on every n-th.
void thin_out(ProcessEnvironment& environment) {
    auto in = environment.input<Packet>("in");
    auto out = environment.output<Packet>("out");
    double passed = 0;
    for (std::int64_t i = 1; i <= environment.integer("count"); ++i) {
        Packet packet = in.input();
        compute(Cycles{environment.integer("cycles")});
        if (i % environment.integer("every") == 0) {
            out.output(packet);
            ++passed;
        }
    }
    environment.measure("passed", passed, "packets");
}

int main(int argc, char** argv) {
    using namespace description;
    ProcessKind thinner{
        .name = "own.thinner",
        .about = "Passes on every n-th packet.",
        .ports = {packets_in(), packets_out()},
        .parameters = {packet_count(), packet_cycles(), integer("every", {.by_default = 10, .least = 1}, "n")},
        .measurements = {{"passed", "packets", "number of packets passed on"}},
        .body = thin_out};
    return run_program(argc, argv, {thinner});
}
