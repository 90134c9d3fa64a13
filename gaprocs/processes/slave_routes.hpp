#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace placedpar {

class ProcessEnvironment;

/// Which of its channels a process takes to a slave beyond. Slaves are numbered depth first: all that are behind a
/// channel have numbers in one interval, as INMOS's C104 routes by intervals, so that a process must know only how many
/// there are behind each channel.
class SlaveRoutes {
public:
    SlaveRoutes() = default;
    /// How many slaves are behind each channel but the last, which leads to all others.
    explicit SlaveRoutes(std::vector<std::size_t> behind) : behind_(std::move(behind)) {}

    struct Way {
        std::size_t channel; ///< to take
        std::size_t address; ///< for the slave at its other end: 0 is that slave itself
    };
    /// To slave number 0, 1 ... of those beyond.
    Way to(std::size_t slave) const;
    /// So many slaves in the order in which they are sent tasks: the first behind each channel, the second behind each
    /// ..., so that all links have something to carry.
    std::vector<std::size_t> in_turn(std::size_t slaves) const;

private:
    std::vector<std::size_t> behind_;
};

/// Of a master or a slave, which cannot see from where it is how many slaves are behind its channels: the netlist says
/// it, as a configurer would tell the program.
SlaveRoutes read_routes(const ProcessEnvironment&);

} // namespace placedpar
