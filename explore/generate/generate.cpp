#include "explore/generate/generate.hpp"

#include "explore/generate/graph_topology.hpp"
#include "explore/generate/job.hpp"
#include "explore/generate/size.hpp"
#include "explore/generate/statements.hpp"
#include "explore/generate/task_graph.hpp"
#include "netlist/read.hpp"
#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/program_name.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>

namespace placedpar::generate {

namespace {

void require_port(const ProcessKind& kind, const std::string& port, Direction direction, const char* option) {
    const PortDescription* found = kind.port(port);
    if (!found || found->direction != direction)
        throw UserError(fmt::format("{} has no {} \"{}\" for connections with neighbours; name the port with {} "
                                    "PORT",
                                    kind.name, direction == Direction::output ? "output" : "input", port, option));
}

bool has_problem(const ProcessKind& kind) {
    return std::ranges::count(kind.parameters, "problem", &ParameterDescription::name) > 0;
}

Job job_of_kind(const TopologyRequest& request, const Catalogue& catalogue, const Topology& topology,
                const ProblemStatements& problem) {
    const ProcessKind* kind = catalogue.find(request.job);
    if (!kind)
        throw UserError(
            unknown_name("kind of process", request.job, catalogue.kind_names(),
                         fmt::format("expected farm, islands, a file of tasks (.csv), or a name that {} kinds lists",
                                     program_name())));
    require_port(*kind, request.output, Direction::output, "--output");
    require_port(*kind, request.input, Direction::input, "--input");
    const bool has_host = kind->port("from_host") != nullptr;
    if (!request.problem.empty() && !has_host && !has_problem(*kind))
        throw UserError(fmt::format("--problem has no effect: the kind {} has no parameter \"problem\"", kind->name));
    return processes_of(request.job, has_host, request.output, request.input, topology, problem,
                        has_problem(*kind) ? problem.each : "");
}

/// Throws UserError if the request names ports, but none of the kind of one process for each processor.
void refuse_ports(const TopologyRequest& request) {
    const TopologyRequest usual;
    for (auto [option, said, unsaid] :
         {std::tuple("--output", &request.output, &usual.output), std::tuple("--input", &request.input, &usual.input)})
        if (*said != *unsaid)
            throw UserError(
                fmt::format("{} {} has no effect: it names a port of the kind that --job KIND places on each "
                            "processor, but the job is {}",
                            option, *said, request.job));
}

Job job_of_tasks(const TopologyRequest& request, const Topology& topology) {
    if (!request.problem.empty())
        throw UserError(fmt::format("--problem {} has no effect on the tasks of {}, which do not search",
                                    request.problem, request.job));
    return tasks_of_file(request.job, topology.nodes, topology);
}

Job job_of(const TopologyRequest& request, const Catalogue& catalogue, const Topology& topology,
           const RecordedProblem* problem) {
    const ProblemStatements statements = statements_of(request.problem, problem);
    const bool is_file = lower_case(request.job).ends_with(".csv");
    if (request.job == "farm" || request.job == "islands" || is_file)
        refuse_ports(request);
    if (request.job == "farm")
        return farm(topology, statements);
    if (request.job == "islands")
        return request.topology == "figure-e2" ? islands_with_slaves(statements) : islands(topology, statements);
    return is_file ? job_of_tasks(request, topology) : job_of_kind(request, catalogue, topology, statements);
}

std::string host_on_workstation(const TopologyRequest& request, const Topology& topology) {
    if (!topology.no_host.empty())
        throw UserError(fmt::format("{} of size {}: {}, so no link is left for a wire to the host; --host node "
                                    "places the host's process on the first processor",
                                    request.topology, request.size, topology.no_host));
    const HostWires& host = topology.host;
    std::vector<std::string> loops;
    if (!host.loop.empty())
        loops.push_back(host.loop);
    return "workstation sun;\n" +
           within(loops, {fmt::format("connect sun.link[{}] to t{}.link[{}];", host.sun, host.at, host.link)}) +
           "place host on sun;\n";
}

std::string host_of(const TopologyRequest& request, const Job& job, const Topology& topology) {
    return !job.has_host            ? ""
           : request.host == "node" ? fmt::format("place host on t{};\n", topology.first)
                                    : host_on_workstation(request, topology);
}

/// Returns the statements in an order that the language accepts: names before their use.
std::string body_of(const TopologyRequest& request, const Job& job, const Topology& topology) {
    std::string host = host_of(request, job, topology);
    return fmt::format("{}\n{}\n/* Hardware */\n"
                       "{} (memory = 1M, channelcall = 201) t{};\n{}{}\n/* Software, and where it runs */\n{}{}",
                       fmt::join(topology.vals, "\n"), job.vals, topology.type, topology.array, topology.attributes,
                       print_wires(topology), job.statements, host);
}

/// Reads the generated netlist. Throws UserError if the printed form of the network, which lists the wires of each
/// channel, is too large.
Network read(const TopologyRequest& request, const std::string& text, const Catalogue& catalogue) {
    constexpr std::string_view too_large = "the network is too large: written out ";
    ReadResult result = read_netlist_text(text, catalogue, {}, "the netlist");
    for (const Diagnostic& each : result.diagnostics)
        if (each.message.starts_with(too_large))
            refuse_size(request, fmt::format("its channels pass through too many processors: written out {}; choose a "
                                             "smaller size, or a topology of a smaller diameter",
                                             each.message.substr(too_large.size())));
    if (!result.network)
        throw RefusedInput(render(result));
    return std::move(*result.network);
}

std::string option(const char* name, const std::optional<std::size_t>& value) {
    return value ? fmt::format(" {} {}", name, *value) : "";
}

std::string command_of(const TopologyRequest& request) {
    std::string text =
        fmt::format("{} generate {}{}{}{}{}{} --job {}", program_name(), shell_word(request.topology),
                    request.size.empty() ? "" : " --size " + request.size, option("--branches", request.branches),
                    option("--chord", request.chord), option("--degree", request.degree),
                    request.split ? " --split" : "", shell_word(request.job));
    TopologyRequest usual;
    for (auto [name, said, unsaid] :
         {std::tuple("--host", &request.host, &usual.host), std::tuple("--output", &request.output, &usual.output),
          std::tuple("--input", &request.input, &usual.input)})
        if (*said != *unsaid)
            text += fmt::format(" {} {}", name, *said);
    return request.problem.empty() ? text : text + " --problem " + shell_word(request.problem);
}

/// Throws UserError if a name that the user typed cannot be written in a comment.
void require_comment(const std::string& comment) {
    const std::string_view inside = std::string_view(comment).substr(0, comment.rfind("*/"));
    if (inside.find("*/") != inside.npos || has_errors(check_source("the netlist", comment).problems))
        throw UserError("names of files and problems are written in a comment of the netlist, so they cannot contain "
                        "\"*/\" or control characters; rename the file");
}

std::string heading_of(const TopologyRequest& request, const Job& job, const Topology& topology,
                       const Distances& distances) {
    const std::string heading =
        fmt::format("/* {}: {}, {} between them, at most {} at one processor, diameter {}.\n   {}\n   {} "
                    "*/\n\n",
                    topology.about, counted(distances.processors, "processor"), counted(distances.links, "link"),
                    distances.degree, distances.diameter, job.about, command_of(request));
    require_comment(heading);
    return heading;
}

} // namespace

Generated generate(const TopologyRequest& request, const Catalogue& catalogue, const RecordedProblem* problem) {
    const Topology topology =
        is_graph_file(request.topology) ? topology_of_graph(request, catalogue) : topology_of(request);
    Job job = job_of(request, catalogue, topology, problem);
    std::string body = body_of(request, job, topology);
    Distances distances = distances_in(read(request, body, catalogue));
    return {heading_of(request, job, topology, distances) + body, distances};
}

} // namespace placedpar::generate
