#pragma once

#include "netlist/kinds/environment.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar::test {

/// The body of a process of a ring in which a token goes round: each process adds 1 to it.
inline void relay_token(ProcessEnvironment& environment, int rounds) {
    const auto in = environment.input<int>("in");
    const auto out = environment.output<int>("out");
    int token = 0;
    for (int i = 0; i < rounds; ++i) {
        if (environment.index() > 0)
            token = in.input();
        out.output(token + 1);
        if (environment.index() == 0)
            token = in.input();
    }
    environment.measure("token", token);
}

/// Returns the netlist of a ring of processes, each on a processor of its own.
inline std::string ring_of(int processes, const std::string& kind) {
    return fmt::format(R"(val n {};
        T800 t[n]; rep i = 0 for n connect t[i].link[1] to t[(i + 1) % n].link[0];
        process (interface (input in, output out)) p[n];
        rep i = 0 for n use "{}" for p[i];
        rep i = 0 for n connect p[i].out to p[(i + 1) % n].in;
        rep i = 0 for n place p[i] on t[i];)",
                       processes, kind);
}

} // namespace placedpar::test
