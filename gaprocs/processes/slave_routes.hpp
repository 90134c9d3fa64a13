#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

/// Tells on which of its channels a process reaches each slave behind it. Slaves are numbered depth first, so that the
/// slaves behind a channel form one interval, as in the interval routing of INMOS's C104. A process only needs the
/// number of slaves behind each channel.
class SlaveRoutes {
public:
    SlaveRoutes() = default;
    /// `behind`: the number of slaves behind each channel except the last, which leads to all other slaves.
    explicit SlaveRoutes(std::vector<std::size_t> behind) : behind_(std::move(behind)) {}

    struct Hop {
        std::size_t channel; ///< channel towards the slave
        std::size_t address; ///< number of the slave as seen from the other end of the channel: 0 is the slave there
    };
    /// Returns the way to a slave; numbers begin at 0.
    Hop to(std::size_t slave) const;
    /// Returns the slaves 0 ... slaves - 1 in the order in which tasks are sent: first the nearest behind each channel,
    /// then the second behind each, and so on, so that all links are busy.
    std::vector<std::size_t> in_turn(std::size_t slaves) const;

private:
    std::vector<std::size_t> behind_;
};

/// Returns the routes of a master or a slave. They are taken from the netlist, as a configurer would pass them to the
/// program: the process itself cannot see how many slaves are behind its channels.
SlaveRoutes read_routes(const ProcessEnvironment&);

} // namespace placedpar
