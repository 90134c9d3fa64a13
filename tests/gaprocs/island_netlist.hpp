#pragma once

#include "gaprocs/islands.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace placedpar::test {

/// A netlist of island[0], island[1], ... for the line problem or another problem. Each island has a workstation of its
/// own, wired as the islands are connected; or the islands share four transputers, each wired to every other; or they
/// share one transputer.
struct IslandNetlist {
    IslandsSettings settings;
    enum class On { one_transputer, four_transputers, workstations } on = On::one_transputer;
    std::string transputer = "clock = 20M";       ///< attributes of the first and third transputer
    std::string other_transputer = "clock = 20M"; ///< attributes of the second and fourth transputer
    std::string wire = "linkspeed = 20M";
    std::string topology = "given"; ///< the parameter `topology`
    std::string more = "";          ///< further parameters of each island
    std::string problem = "line";
    bool recorded = true;  ///< the problem has a record, not an objective
    std::string host = ""; ///< parameters of the host
    int slaves = 0;        ///< number of slaves of each island, in a chain; only on workstations

    std::string text() const {
        std::size_t n = settings.islands.size();
        std::string text = fmt::format("val n {};\nworkstation ({}) sun;\nprocess host; process island[n];\n"
                                       "use \"ga.host\" for host; place host on sun; host (problem = \"{}\"{});\n",
                                       n, on == On::workstations ? wire : "linkspeed = 20M", problem, host);
        text += on == On::workstations ? workstations() : transputers();
        for (std::size_t i = 0; i < n; ++i)
            text += island(i);
        for (std::size_t i = 0; i < n; ++i)
            for (int s = 0; s < slaves; ++s)
                text += slave(i, s);
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
            "island[{0}] (problem = \"{1}\"{2}, population = {3}, elite = {4}, schedule = \"{5}\", "
            "emigration = \"{6}\", acceptance = \"{7}\", topology = \"{8}\"{9}{10});\n",
            i, problem, slaves > 0 ? fmt::format(", slaves = {}", slaves) : "", each.population, each.elite,
            settings.schedule.text(), settings.emigration.text(), settings.acceptance.text(), topology,
            recorded ? window(each.window) : "", more);
    }

    static std::string window(const WindowSettings& window) {
        return fmt::format(", window = {}, first_window = {}, trials = {}, bias = {:.1f}", window.length,
                           std::min(window.first, window.length), window.trials, window.bias);
    }

    /// Returns the declaration of a slave. The first slave is wired to its island through a link that no neighbour
    /// uses.
    std::string slave(std::size_t i, int s) const {
        std::string before = s == 0 ? fmt::format("island[{}]", i) : fmt::format("slave{}_{}", i, s - 1);
        std::string link = s == 0 ? fmt::format("w[{}].link[99]", i) : fmt::format("s{}_{}.link[3]", i, s - 1);
        return fmt::format("T800 ({4}, {6}) s{0}_{1}; process slave{0}_{1}; use \"ga.slave\" for slave{0}_{1};\n"
                           "place slave{0}_{1} on s{0}_{1}; slave{0}_{1} (problem = \"{5}\");\n"
                           "connect {3} to s{0}_{1}.link[1];\nconnect {2}.to_slaves to slave{0}_{1}.from_master;\n"
                           "connect slave{0}_{1}.to_master to {2}.from_slaves;\n",
                           i, s, before, link, s % 2 ? other_transputer : transputer, problem, wire);
    }

    /// Connects the islands. Numbers the ports for immigrants in the reverse order of the islands, to test that their
    /// order does not matter.
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

/// Runs the same islands in the library. Holds, for each island, the hash of all populations that the island's process
/// measures.
struct LibraryRun {
    std::vector<std::string> populations;

    LibraryRun(const IslandsSettings& settings, std::vector<RandomStream> streams)
        : LibraryRun(*make_search_problem(LineProblem{}), line_record(line_samples), settings, std::move(streams)) {}

    /// Throws as Islands().
    LibraryRun(const SearchProblem& problem, std::span<const Sample> record, const IslandsSettings& settings,
               std::vector<RandomStream> streams) {
        Islands islands(problem, settings, std::move(streams));
        std::vector<Fingerprint> hashes(settings.islands.size());
        std::size_t trials = problem.objective() ? 1 : settings.islands.front().window.trials;
        for (const Sample& sample : record) {
            islands.push(sample);
            for (std::size_t trial = 0; islands.ready() && trial < trials; ++trial)
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
