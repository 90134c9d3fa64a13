#pragma once

#include "runtime/process.hpp"
#include "runtime/source_location.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace placedpar {

/// The body of a component of a PAR: a function without arguments.
template <class Body>
concept ComponentBody = std::constructible_from<Process::Body, Body>;

struct Component {
    Process::Body body;
    Priority priority;
};

/// Runs the components as processes on the processor of the running process, and waits until all have ended. As in
/// occam, the running process starts all components but the last, and the last component runs first, in its place. If
/// the running process has no processor, the components begin in their order. If a component throws, the simulation
/// ends, and its run rethrows the exception.
void run_in_parallel(std::vector<Component>, const SourceLocation&);

/// Returns the priority of the running process, which its components inherit.
Priority own_priority();

/// The first component of a PAR. Its implicit constructor records the place of the call of `par` for reports.
struct FirstComponent {
    template <ComponentBody Body>
    FirstComponent(Body&& b, const SourceLocation& here = SourceLocation::current())
        : body(std::forward<Body>(b)), where(here) {}

    Process::Body body;
    SourceLocation where;
};

/// Runs occam's PAR: `par([&] { ... }, [&] { ... })`.
template <ComponentBody... Bodies>
void par(FirstComponent first, Bodies&&... others) {
    run_in_parallel(
        {Component{std::move(first.body), own_priority()}, Component{std::forward<Bodies>(others), own_priority()}...},
        first.where);
}

/// Runs occam's replicated PAR, `PAR i = 0 FOR n`: `par_for(n, [&](std::size_t i) { ... })`.
template <std::invocable<std::size_t> Body>
void par_for(std::size_t n, Body body, const SourceLocation& where = SourceLocation::current()) {
    std::vector<Component> components;
    for (std::size_t i = 0; i < n; ++i)
        components.push_back({[i, &body] { body(i); }, own_priority()});
    run_in_parallel(std::move(components), where);
}

/// Runs occam's PRI PAR of two components, the first at high priority, the second at low priority.
template <ComponentBody High, ComponentBody Low>
void pri_par(High&& high, Low&& low, const SourceLocation& where = SourceLocation::current()) {
    run_in_parallel({{std::forward<High>(high), Priority::high}, {std::forward<Low>(low), Priority::low}}, where);
}

} // namespace placedpar
