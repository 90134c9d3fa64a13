#pragma once

#include <fmt/format.h>

#include <string>

namespace placedpar::test {

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
