#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

/// Finds the channel on which a master, or a slave that passes on messages, reaches another slave. The slaves behind a
/// process are numbered depth first. So the slaves behind one channel have consecutive numbers, as in the interval
/// routing of INMOS's C104. To find the channel, a process needs only the number of slaves behind each channel.
class SlaveRoutes {
public:
    SlaveRoutes() = default;
    /// `behind`: the number of slaves behind each channel except the last channel; all other slaves are behind the last
    /// channel.
    explicit SlaveRoutes(std::vector<std::size_t> behind) : behind_(std::move(behind)) {}

    struct Hop {
        std::size_t channel; ///< channel towards the slave
        std::size_t address; ///< number of the slave among the slaves behind this channel; the process at the other end
                             ///< of the channel has number 0
    };
    /// Returns the first hop towards a slave.
    Hop to(std::size_t slave) const;
    /// Returns the slaves 0 ... `slaves` - 1 in the order in which tasks are sent: first the slaves with address 0,
    /// then the slaves with address 1, and so on. So the first tasks go to different channels, and all links are soon
    /// busy.
    std::vector<std::size_t> in_turn(std::size_t slaves) const;

private:
    std::vector<std::size_t> behind_;
};

/// Computes the routes of a master or a slave from the connections of the netlist.
SlaveRoutes read_routes(const ProcessEnvironment&);

} // namespace placedpar
