#include "experiments/kit/study_replay.hpp"
#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

const ProcessInstance& master_of(const Network& network) {
    for (const ProcessInstance& process : network.processes)
        if (process.name == "master" && process.kind == "ga.master")
            return process;
    throw UserError(fmt::format("{}: expected a process \"master\" of the kind ga.master", network.source_path));
}

/// States the origin of each constant, with the values of the netlist.
std::string print_constants(const ReplayContext& context) {
    auto load = [&](const Overrides& overrides) {
        return load_network(context.examples / "thesis/table-e1" / "cluster.cfs", overrides,
                            known_problems(context.seed), context.warn);
    };
    Network at_120 = load({}), at_30 = load({{"reading", "30"}});
    auto value = [](const Network& network, const char* parameter) {
        return std::get<std::int64_t>(master_of(network).parameters.at(parameter));
    };
    return fmt::format(
        "w  workload: {} cycles an error evaluation ({} under the reading 30) and {} ({}) cycles of genetic operators\n"
        "   an individual, read off the column without slaves; {} bytes of measurements, 240 of strings and 240 of\n"
        "   fitness (appendix E)\n"
        "c  calibrated: {} cycles to make a word of the measurements ready to send, to C_time2 with three slaves\n"
        "   calibrated to other machines: {} cycles a call of the communication library (a ping-pong on real T805s,\n"
        "   Poznan 2008), a link's pauses between packets (measured rates)\n"
        "   published: 20 MHz, 20 Mbit/s, a link's bits (databook), instruction times, block move 6 cycles a word\n"
        "!  an outcome further from the thesis than 3 %; its own T_exe is off its T_sr + S_time2 by up to 0.9 %\n",
        value(at_120, "cycles_per_error"), value(at_30, "cycles_per_error"), value(at_120, "cycles_per_individual"),
        value(at_30, "cycles_per_individual"), value(at_120, "measurement_bytes"),
        value(at_120, "cycles_per_measurement_word"), at_120.nodes[master_of(at_120).node].integer("channelcall"));
}

/// Adds the constants of the netlist, to which the notes refer.
Replay replay_table_e1(const ReplayContext& context) {
    Replay replay = StudyReplay(context, "thesis/table-e1/table-e1.toml").replay();
    replay.constants = print_constants(context);
    return replay;
}

} // namespace

extern const Experiment table_e1_experiment{
    .name = "table-e1",
    .about = "what a generation costs on one cluster with 0 to 3 slaves",
    .chapter = "E",
    .number = 1,
    .run = replay_table_e1,
};

} // namespace placedpar
