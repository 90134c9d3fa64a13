#pragma once

#include "gaprocs/islands.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::test {

/// Islands of the line problem as a netlist: island[0], island[1], ... on the same number of workstations, which are
/// joined as their islands are, on four transputers, each joined with every other, or all on one.
struct IslandNetlist {
    IslandsSettings settings;
    enum class On { one_transputer, four_transputers, workstations } on = On::one_transputer;
    std::string transputer = "clock = 20M";       ///< attributes of the first and third
    std::string other_transputer = "clock = 20M"; ///< of the second and fourth
    std::string wire = "linkspeed = 20M";
    std::string topology = "given"; ///< the parameter
    std::string more = "";          ///< parameters of each island

    std::string text() const {
        std::size_t n = settings.islands.size();
        std::string text = fmt::format("val n {};\nworkstation ({}) sun;\nprocess host; process island[n];\n"
                                       "use \"ga.host\" for host; place host on sun; host (problem = \"line\");\n",
                                       n, on == On::workstations ? wire : "linkspeed = 20M");
        text += on == On::workstations ? workstations() : transputers();
        for (std::size_t i = 0; i < n; ++i)
            text += island(i);
        return text + channels();
    }

private:
    std::size_t count() const { return settings.islands.size(); }
    Neighbours neighbours() const { return settings.topology.neighbours(count()); }

    std::string transputers() const {
        std::size_t processors = on == On::one_transputer ? 1 : 4;
        std::string text = fmt::format("connection ({}) wire[6];\n", wire);
        for (std::size_t i = 0; i < processors; ++i)
            text += fmt::format("T800 ({0}) t{1};\nconnect sun.link[{1}] to t{1}.link[0];\n",
                                i % 2 ? other_transputer : transputer, i);
        if (processors == 4)
            text += "connect t0.link[1] to t1.link[1] by wire[0]; connect t2.link[1] to t3.link[1] by wire[1];\n"
                    "connect t0.link[2] to t2.link[2] by wire[2]; connect t1.link[2] to t3.link[2] by wire[3];\n"
                    "connect t0.link[3] to t3.link[3] by wire[4]; connect t1.link[3] to t2.link[3] by wire[5];\n";
        for (std::size_t i = 0; i < count(); ++i)
            text += fmt::format("place island[{}] on t{};\n", i, i % processors);
        return text;
    }

    std::string workstations() const {
        std::string text = fmt::format("workstation ({}) w[n];\nrep i = 0 for n {{ place island[i] on w[i]; "
                                       "connect sun.link[i] to w[i].link[0]; }}\n",
                                       wire);
        std::vector<int> links(count(), 1);
        auto lists = neighbours();
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t to : lists[i])
                text += fmt::format("connect w[{}].link[{}] to w[{}].link[{}];\n", i, links[i]++, to, links[to]++);
        return text;
    }

    std::string island(std::size_t i) const {
        const SearchSettings& each = settings.islands[i];
        return fmt::format(
            "use \"ga.island\" for island[{0}];\nconnect host.to_masters[{0}] to island[{0}].from_host;\n"
            "island[{0}] (problem = \"line\", population = {1}, window = {2}, first_window = {3}, "
            "trials = {4}, bias = {5:.1f}, elite = {6}, schedule = \"{7}\", emigration = \"{8}\", "
            "acceptance = \"{9}\", topology = \"{10}\"{11});\n",
            i, each.population, each.window.length, std::min(each.window.first, each.window.length), each.window.trials,
            each.window.bias, each.elite, settings.schedule.text(), settings.emigration.text(),
            settings.acceptance.text(), topology, more);
    }

    /// The ends at which immigrants come in are numbered from the highest island on: their order means nothing.
    std::string channels() const {
        std::string text;
        std::vector<int> ends(count());
        auto lists = neighbours();
        for (std::size_t i = count(); i-- > 0;)
            for (std::size_t place = 0; place < lists[i].size(); ++place)
                text += fmt::format("connect island[{}].to_neighbours[{}] to island[{}].from_neighbours[{}];\n", i,
                                    place, lists[i][place], ends[lists[i][place]]++);
        return text;
    }
};

/// What the library makes of the same islands: of each a hash of every population, as processes measure it.
struct LibraryRun {
    std::vector<std::string> populations;

    LibraryRun(const IslandsSettings& settings, std::vector<RandomStream> streams) {
        auto problem = make_search_problem(LineProblem{});
        Islands islands(*problem, settings, std::move(streams));
        std::vector<Fingerprint> hashes(settings.islands.size());
        for (const Sample& sample : line_record(line_samples)) {
            islands.push(sample);
            for (std::size_t trial = 0; islands.ready() && trial < settings.islands.front().window.trials; ++trial)
                add_generation(islands, hashes);
        }
        for (const Fingerprint& hash : hashes)
            populations.push_back(fmt::format("{:016x}", hash.value()));
    }

private:
    static void add_generation(Islands& islands, std::vector<Fingerprint>& hashes) {
        for (std::size_t i = 0; i < hashes.size(); ++i)
            if (islands.ready(i))
                for (const Genome& genome : islands.searches()[i].population())
                    for (std::uint64_t word : genome.words())
                        hashes[i].mix(word);
        islands.next_generation();
    }
};

} // namespace placedpar::test
