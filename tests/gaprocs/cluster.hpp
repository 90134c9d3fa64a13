#pragma once

#include "gaprocs/problem_registry.hpp"
#include "gaprocs/processes/kinds.hpp"
#include "gaprocs/search_problem.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/objectives.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace placedpar {

/// A netlist of one or several masters, each with a chain of slaves, by default for the line problem.
struct Cluster {
    int slaves = 0;
    int islands = 1; ///< number of masters; several are islands in a ring
    int population = 30;
    std::string split = "individuals";
    std::string measurements = "sample";
    std::string even_processor = "clock = 20M"; ///< attributes of processors 0, 2, ...; processor 0 is the master's
    std::string odd_processor = "clock = 20M";
    std::string workstation = "linkspeed = 20M";
    std::string master_parameters = "rehearsals = 2";
    std::string stream = "one stream";
    std::string problem = "line";
    std::string host_parameters = "";

    std::string netlist() const {
        std::string text =
            fmt::format("workstation ({}) sun;\nprocess (interface (output to_masters[{}])) host;\n"
                        "use \"ga.host\" for host;\nplace host on sun;\nhost (problem = \"{}\"{}{});\n",
                        workstation, islands, problem, host_parameters.empty() ? "" : ", ", host_parameters);
        for (int island = 0; island < islands; ++island)
            text += master(island);
        for (int island = 0; island < islands; ++island)
            for (int i = 0; i < slaves; ++i)
                text += slave(island, i);
        for (int island = 0; islands > 1 && island < islands; ++island)
            text += fmt::format("connect t{0}_0.link[1] to t{1}_0.link[2];\nconnect master{0}.to_neighbours[0] to "
                                "master{1}.from_neighbours[0];\n",
                                island, (island + 1) % islands);
        return text;
    }

private:
    std::string processor(int island, int place) const {
        return fmt::format("T800 ({}) t{}_{};\n", place % 2 ? odd_processor : even_processor, island, place);
    }

    std::string master(int island) const {
        std::string text = processor(island, 0);
        text += fmt::format("process (interface (input from_host, output to_slaves, input from_slaves, "
                            "output to_neighbours[1], input from_neighbours[1])) master{0};\n"
                            "use \"ga.island\" for master{0};\nplace master{0} on t{0}_0;\n"
                            "connect sun.link[{0}] to t{0}_0.link[0];\n"
                            "connect host.to_masters[{0}] to master{0}.from_host;\n"
                            "master{0} (problem = \"{3}\", population = {1}, {2});\n",
                            island, population, master_parameters, problem);
        if (islands == 1)
            text += fmt::format("master{} (stream = \"{}\");\n", island, stream);
        if (slaves > 0)
            text += fmt::format("master{} (slaves = {}, split = \"{}\");\n", island, slaves, split);
        if (slaves > 0 && !measurements.empty())
            text += fmt::format("master{} (measurements = \"{}\");\n", island, measurements);
        return text;
    }

    std::string slave(int island, int i) const {
        std::string before = i == 0 ? fmt::format("master{}", island) : fmt::format("slave{}_{}", island, i - 1);
        return processor(island, i + 1) +
               fmt::format(
                   "process (interface (input from_master, output to_master, output to_slaves, input from_slaves)) "
                   "slave{0}_{1};\nuse \"ga.slave\" for slave{0}_{1};\nplace slave{0}_{1} on t{0}_{2};\n"
                   "connect t{0}_{1}.link[3] to t{0}_{2}.link[1];\n"
                   "slave{0}_{1} (problem = \"{4}\");\n"
                   "connect {3}.to_slaves to slave{0}_{1}.from_master;\n"
                   "connect slave{0}_{1}.to_master to {3}.from_slaves;\n",
                   island, i, i + 1, before, problem);
    }
};

inline constexpr std::size_t line_samples = 12;

inline RunReport run_on_line(const std::string& netlist, std::uint64_t seed = 1, SearchObserver* observer = nullptr) {
    ProblemRegistry problems;
    problems.add("line", make_search_problem(LineProblem{}), line_record(line_samples));
    problems.add("along", make_search_problem(LineAlongWindow{}), line_record(line_samples));
    problems.add("sphere", minimise(PlainSphere{}));
    problems.add("nowhere", minimise(Nowhere{}));
    problems.add("seats", minimise(Seats{}));
    problems.add("comb", maximise(Comb{}));
    problems.add("plane", minimise(Plane{}));
    problems.add(minimised<Valley>());
    Catalogue catalogue;
    add_genetic_algorithm_kinds(catalogue, problems, observer);
    ReadResult read = read_netlist_text(netlist, catalogue);
    if (!read.network)
        throw std::runtime_error(render(read.diagnostics));
    return Machine(*read.network, catalogue, seed).run();
}

} // namespace placedpar
