// A graph of tasks. Each task is a process csp.task: it waits for its inputs, computes, and sends a message to each of
// its successors.

#include "classics/kinds.hpp"

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/network/names.hpp"
#include "netlist/network/network.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"
#include "text/counted.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace placedpar {

namespace {

constexpr std::uint32_t longest_message = 1'000'000'000;

/// Reads the parameter `bytes`, such as "100 4". Throws UserError if a length is not valid.
std::vector<std::uint32_t> lengths_in(const std::string& text) {
    std::vector<std::uint32_t> lengths;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto length = parse_number<std::uint32_t>(word);
        if (!length || *length == 0 || *length > longest_message)
            throw UserError(fmt::format("\"{}\" is not a length from 1 to {} bytes; expected a length for each "
                                        "successor, such as \"100 4\"",
                                        word, longest_message));
        lengths.push_back(*length);
    }
    return lengths;
}

/// Performs the task. All inputs happen in parallel, and so do all outputs, so that no predecessor or successor waits
/// for another.
void perform_task(ProcessEnvironment& environment) {
    const auto from = environment.inputs<Packet>("in");
    const auto to = environment.outputs<Packet>("out");
    const auto lengths = lengths_in(environment.text("bytes"));
    par_for(from.size(), [&](std::size_t i) { from[i].input(); });
    environment.measure("ready", in_milliseconds(now()), "ms");
    compute(Cycles{environment.integer("cycles")});
    environment.measure("done", in_milliseconds(now()), "ms");
    par_for(to.size(), [&](std::size_t i) { to[i].output({0, lengths[i]}); });
}

std::vector<Complaint> check_task(const Network& network, std::size_t process) {
    const ProcessInstance& task = network.processes[process];
    const auto successors = static_cast<std::size_t>(
        std::ranges::count(task.ports, "out", [](const PortBinding& port) { return base_name(port.port); }));
    const auto lengths = lengths_in(std::get<std::string>(task.parameters.at("bytes")));
    if (lengths.size() == successors)
        return {};
    return {{process, "bytes",
             fmt::format("\"{}\" has {}, but \"bytes\" has {}", task.name, counted(successors, "successor"),
                         counted(lengths.size(), "length")),
             "state a length for each successor, in the order of the elements of \"out\": bytes = \"100 4\""}};
}

} // namespace

std::vector<ProcessKind> task_kinds() {
    using namespace description;
    return {
        {.name = "csp.task",
         .about = "A task of a task graph: inputs a message from each predecessor, computes, and outputs a message "
                  "to each successor.",
         .ports = {optional(packets_in("in", "an array: inputs from the predecessors")),
                   optional(packets_out("out", "an array: outputs to the successors"))},
         .parameters = {packet_cycles("workload: computation of the task"),
                        text("bytes", {.by_default = "", .check = [](const std::string& text) { lengths_in(text); }},
                             "lengths of the messages to the successors, such as \"100 4\"")},
         .measurements = {{"ready", "ms", "time at which the task had all inputs, and its processor was free"},
                          {"done", "ms", "time at which the task's computation ended"}},
         .body = perform_task,
         .check = check_task,
         .is_determinate = always}};
}

} // namespace placedpar
