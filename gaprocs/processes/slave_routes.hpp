#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

/// Finds the channel on which a process reaches each slave behind it. Slaves are numbered depth first, so the slaves
/// behind one channel have consecutive numbers, as in the interval routing of INMOS's C104. A process needs only the
/// number of slaves behind each channel.
class SlaveRoutes {
public:
    SlaveRoutes() = default;
    /// `behind`: the number of slaves behind each channel, except for the last channel, which leads to all other
    /// slaves.
    explicit SlaveRoutes(std::vector<std::size_t> behind) : behind_(std::move(behind)) {}

    struct Hop {
        std::size_t channel; ///< channel towards the slave
        std::size_t address; ///< number of the slave, counted from the process at the other end of the channel, which
                             ///< has number 0
    };
    /// Returns the first hop towards a slave. Slaves are numbered from 0.
    Hop to(std::size_t slave) const;
    /// Returns the slaves 0 ... slaves - 1 in the order in which tasks are sent: first the nearest slave behind each
    /// channel, then the second behind each channel, and so on. In this order all links are busy.
    std::vector<std::size_t> in_turn(std::size_t slaves) const;

private:
    std::vector<std::size_t> behind_;
};

/// Returns the routes of a master or a slave. They are read from the netlist, because a process cannot see how many
/// slaves are behind its channels. On a transputer, a configurer would pass them to the program.
SlaveRoutes read_routes(const ProcessEnvironment&);

} // namespace placedpar
