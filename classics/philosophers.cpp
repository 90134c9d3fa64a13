// Dijkstra's dining philosophers, as in Hoare (Communicating Sequential Processes, 1985, section 2.5). The forks are
// processes, too. A butler can prevent the deadlock by never letting all philosophers sit down at the same time.

#include "classics/kinds.hpp"

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// A message without content, such as occam's `c ! ANY`. It takes one byte on a link.
struct Signal {
    WireForm wire_form() const { return WireForm(1); }
};

void dine(ProcessEnvironment& environment) {
    auto left = environment.output<Signal>("left"), right = environment.output<Signal>("right");
    bool has_butler = environment.connected("butler");
    Output<Signal> butler;
    if (has_butler)
        butler = environment.output<Signal>("butler");
    auto sit_down_or_get_up = [&] {
        if (has_butler)
            butler.output({});
    };
    for (std::int64_t meal = 0; meal < environment.integer("meals"); ++meal) {
        compute(Cycles{environment.integer("thinking")});
        sit_down_or_get_up();
        left.output({}); // picks up the left fork
        right.output({});
        compute(Cycles{environment.integer("eating")});
        left.output({}); // puts down the left fork
        right.output({});
        sit_down_or_get_up();
    }
    environment.measure("time", in_milliseconds(now()), "ms");
}

void serve_as_fork(ProcessEnvironment& environment) {
    auto hands = environment.inputs<Signal>("hand");
    for (std::int64_t use = 0; use < environment.integer("uses"); ++use)
        alt(std::span<const Input<Signal>>(hands), [&](std::size_t hand, Signal) { hands[hand].input(); });
}

/// Returns the guards of the butler's ALT, one for each philosopher. A seated philosopher may always get up; a standing
/// philosopher may sit down if a seat is free.
std::vector<Guard> guards_of(const std::vector<Input<Signal>>& philosophers, const std::vector<bool>& sits,
                             std::int64_t seats) {
    bool seat_free = std::ranges::count(sits, true) < seats;
    std::vector<Guard> guards;
    for (std::size_t i = 0; i < philosophers.size(); ++i)
        guards.push_back({sits[i] || seat_free ? Guard::input : Guard::never, &philosophers[i].channel()});
    return guards;
}

void wait_on_table(ProcessEnvironment& environment) {
    auto philosophers = environment.inputs<Signal>("philosopher");
    std::vector<bool> sits(philosophers.size(), false);
    auto movements = 2 * environment.integer("meals") * static_cast<std::int64_t>(philosophers.size());
    for (std::int64_t i = 0; i < movements; ++i) {
        std::size_t chosen = select(guards_of(philosophers, sits, environment.integer("seats")));
        philosophers[chosen].input();
        sits[chosen] = !sits[chosen];
    }
}

std::string dining_in_promela(const PromelaProcess& self) {
    std::string forks = fmt::format("{} ! m;\n{} ! m;\n", self.channel("left"), self.channel("right"));
    std::string butler = self.connected("butler") ? self.channel("butler") + " ! m;\n" : "";
    return promela_loop(self.integer("meals"), butler + forks + forks + butler);
}

std::string fork_in_promela(const PromelaProcess& self) {
    std::string hands;
    for (const std::string& hand : self.channels("hand"))
        hands += fmt::format(":: {0} ? m -> {0} ? m\n", hand);
    return promela_loop(self.integer("uses"), "if\n" + hands + "fi\n");
}

std::string butler_in_promela(const PromelaProcess& self) {
    auto philosophers = self.channels("philosopher");
    std::string movements;
    for (std::size_t i = 0; i < philosophers.size(); ++i)
        movements += fmt::format(
            ":: {} ? m -> seated = (sits[{}] -> seated - 1 : seated + 1); sits[{}] = !sits[{}]\n",
            self.channel_if(fmt::format("sits[{}] || seated < {}", i, self.integer("seats")), philosophers[i]), i, i,
            i);
    auto times = 2 * self.integer("meals") * static_cast<std::int64_t>(philosophers.size());
    return fmt::format("bool sits[{}];\nint seated;\n", philosophers.size()) +
           promela_loop(times, "if\n" + movements + "fi\n");
}

ParameterDescription meals(std::string about) {
    return description::integer("meals", {.by_default = 10, .least = 1, .most = 1e9}, std::move(about));
}

ParameterDescription work(std::string name, std::string about) {
    return description::integer(std::move(name), {.unit = "cycles", .by_default = 2000, .least = 0, .most = 1e12},
                                std::move(about));
}

ProcessKind philosopher_kind() {
    using namespace description;
    auto signals = [](std::string name, std::string about) {
        return output<Signal>(std::move(name), "signal", std::move(about));
    };
    return {.name = "csp.philosopher",
            .about = "Thinks, picks up the left fork and then the right fork, eats, and puts both forks down.",
            .ports = {signals("left", "picks up and puts down the fork on the left"),
                      signals("right", "picks up and puts down the fork on the right"),
                      optional(signals("butler", "sits down and gets up"))},
            .parameters = {meals("meals before the philosopher leaves"),
                           work("thinking", "workload: thinking before each meal"),
                           work("eating", "workload: eating a meal")},
            .measurements = {{"time", "ms", "end of the last meal"}},
            .body = dine,
            .promela = dining_in_promela};
}

ProcessKind fork_kind() {
    using namespace description;
    return {
        .name = "csp.fork",
        .about = "A fork: one neighbour picks it up and puts it down before the other neighbour can pick it up.",
        .ports = {input<Signal>("hand", "signal", "an array: the neighbours")},
        .parameters = {integer(
            "uses", {.by_default = 20, .least = 1, .most = 1e9},
            "number of times that the fork is picked up before its process ends: twice the meals of a philosopher")},
        .body = serve_as_fork,
        .promela = fork_in_promela};
}

ProcessKind butler_kind() {
    using namespace description;
    return {
        .name = "csp.butler",
        .about =
            "Limits the number of philosophers at the table. With one seat fewer than philosophers, some philosopher "
            "can always eat.",
        .ports = {input<Signal>("philosopher", "signal", "an array: the philosophers")},
        .parameters = {integer("seats", {.by_default = 4, .least = 1, .most = 1e6},
                               "greatest number of philosophers at the table"),
                       meals("meals of each philosopher")},
        .body = wait_on_table,
        .promela = butler_in_promela};
}

} // namespace

std::vector<ProcessKind> philosopher_kinds() { return {philosopher_kind(), fork_kind(), butler_kind()}; }

} // namespace placedpar
