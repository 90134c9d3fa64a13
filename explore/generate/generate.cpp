#include "explore/generate/generate.hpp"

#include "explore/generate/job.hpp"
#include "explore/generate/size.hpp"
#include "explore/generate/statements.hpp"
#include "netlist/read.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"
#include "text/program_name.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

namespace placedpar::generate {

namespace {

void require_port(const ProcessKind& kind, const std::string& port, Direction direction, const char* option) {
    const PortDescription* found = kind.port(port);
    if (!found || found->direction != direction)
        throw UserError(fmt::format("{} has no {} \"{}\" to connect with its neighbours; say which by {} PORT",
                                    kind.name, direction == Direction::output ? "output" : "input", port, option));
}

Job job_of_kind(const Wish& wish, const Catalogue& catalogue, const Topology& topology) {
    const ProcessKind* kind = catalogue.find(wish.job);
    if (!kind)
        throw UserError(
            unknown_name("kind of process", wish.job, catalogue.kind_names(),
                         fmt::format("expected farm, islands, or a name that {} kinds lists", program_name())));
    require_port(*kind, wish.output, Direction::output, "--output");
    require_port(*kind, wish.input, Direction::input, "--input");
    return processes_of(wish.job, kind->port("from_host") != nullptr, wish.output, wish.input, topology);
}

Job job_of(const Wish& wish, const Catalogue& catalogue, const Topology& topology) {
    if (wish.job == "farm")
        return farm(topology);
    if (wish.job == "islands")
        return wish.topology == "figure-e2" ? islands_with_slaves() : islands(topology);
    return job_of_kind(wish, catalogue, topology);
}

std::string host_on_workstation(const Wish& wish, const Topology& topology) {
    if (!topology.no_host.empty())
        throw UserError(fmt::format("{} of size {}: {}, so none is left for a wire to the host; --host node places "
                                    "the host's process on the first processor",
                                    wish.topology, wish.size, topology.no_host));
    const HostWires& host = topology.host;
    std::vector<std::string> loops;
    if (!host.loop.empty())
        loops.push_back(host.loop);
    return "workstation sun;\n" +
           within(loops, {fmt::format("connect sun.link[{}] to t{}.link[{}];", host.sun, host.at, host.link)}) +
           "place host on sun;\n";
}

std::string host_of(const Wish& wish, const Job& job, const Topology& topology) {
    return !job.has_host         ? ""
           : wish.host == "node" ? fmt::format("place host on t{};\n", topology.first)
                                 : host_on_workstation(wish, topology);
}

/// Returns the statements in an order that the language accepts: names before their use.
std::string body_of(const Wish& wish, const Job& job, const Topology& topology) {
    std::string host = host_of(wish, job, topology);
    return fmt::format("{}\n{}\n/* Hardware */\n"
                       "T800 (memory = 1M, channelcall = 201) t{};\n{}\n/* Software, and where it runs */\n{}{}",
                       fmt::join(topology.vals, "\n"), job.vals, topology.array, print_wires(topology), job.statements,
                       host);
}

/// A channel is written out wire by wire.
Network read(const Wish& wish, const std::string& text, const Catalogue& catalogue) {
    constexpr std::string_view too_large = "the network is too large: written out ";
    ReadResult result = read_netlist_text(text, catalogue, {}, "the netlist");
    for (const Diagnostic& each : result.diagnostics)
        if (each.message.starts_with(too_large))
            refuse_size(wish,
                        fmt::format("its channels pass through so many processors that written out {}; say fewer, or a "
                                    "topology of a smaller diameter",
                                    each.message.substr(too_large.size())));
    if (!result.network)
        throw RefusedInput(render(result));
    return std::move(*result.network);
}

std::string option(const char* name, const std::optional<std::size_t>& value) {
    return value ? fmt::format(" {} {}", name, *value) : "";
}

std::string command_of(const Wish& wish) {
    std::string text = fmt::format("{} generate {} --size {}{}{}{} --job {}", program_name(), wish.topology, wish.size,
                                   option("--branches", wish.branches), option("--chord", wish.chord),
                                   option("--degree", wish.degree), wish.job);
    Wish usual;
    for (auto [name, said, unsaid] :
         {std::tuple("--host", &wish.host, &usual.host), std::tuple("--output", &wish.output, &usual.output),
          std::tuple("--input", &wish.input, &usual.input)})
        if (*said != *unsaid)
            text += fmt::format(" {} {}", name, *said);
    return text;
}

std::string heading_of(const Wish& wish, const Job& job, const Topology& topology, const Distances& distances) {
    return fmt::format("/* {}: {}, {} between them, at most {} of one, diameter {}.\n   {}\n   {} */\n\n",
                       topology.about, counted(distances.processors, "processor"), counted(distances.links, "link"),
                       distances.degree, distances.diameter, job.about, command_of(wish));
}

} // namespace

Generated generate(const Wish& wish, const Catalogue& catalogue) {
    Topology topology = topology_of(wish);
    Job job = job_of(wish, catalogue, topology);
    std::string body = body_of(wish, job, topology);
    Distances distances = distances_in(read(wish, body, catalogue));
    return {heading_of(wish, job, topology, distances) + body, distances};
}

} // namespace placedpar::generate
