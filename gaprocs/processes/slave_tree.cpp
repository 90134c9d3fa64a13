#include "gaprocs/processes/slave_tree.hpp"

#include "gaprocs/processes/peers.hpp"
#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

std::string shown(const Network& network, const ChannelEnd& end) {
    return end.at_edge() ? end.port : network.processes[end.process].name + "." + end.port;
}

bool is_of_kind(const Network& network, const ChannelEnd& end, std::string_view kind) {
    return !end.at_edge() && network.processes[end.process].kind == kind;
}

bool is_slave(const Network& network, const ChannelEnd& end) { return is_of_kind(network, end, "ga.slave"); }

/// Follows the channels of tasks from one process.
class Follower {
public:
    explicit Follower(const Network& network) : n_(network) {}

    void follow(std::size_t process) {
        auto to = ends_of(n_, process, "to_slaves"), from = ends_of(n_, process, "from_slaves");
        if (!are_numbered(process, to) || !are_numbered(process, from))
            return;
        for (const PortBinding& tasks : to)
            follow(process, tasks, from);
        if (from.size() > to.size()) {
            const PortBinding& loose = from[to.size()];
            complain(process, loose,
                     fmt::format("\"{}\" receives results, but \"{}\" is not connected", name(process, loose.port),
                                 name(process, counterpart(loose.port, "to_slaves"))),
                     fmt::format("connect {} to ...;", name(process, counterpart(loose.port, "to_slaves"))));
        }
    }

    void follow(std::size_t process, const PortBinding& tasks, const std::vector<PortBinding>& from) {
        const ChannelEnd& to = end_beyond(n_, tasks);
        if (is_of_kind(n_, to, "ga.pipeline"))
            return follow(to.process); // check_pipeline() checks the path of the results
        if (!is_slave(n_, to)) {
            ++tree.others;
            return;
        }
        const std::string& slave = n_.processes[to.process].name;
        if (auto [first, added] = reached_.emplace(to.process, name(process, tasks.port)); !added)
            return complain(process, tasks,
                            fmt::format("\"{}\" leads to the slave \"{}\", but \"{}\" leads to the same slave",
                                        name(process, tasks.port), slave, first->second),
                            "a slave takes its tasks from one process, over one channel");
        auto port = counterpart(tasks.port, "from_slaves");
        auto results = std::ranges::find(from, port, &PortBinding::port);
        if (results == from.end() || end_beyond(n_, *results).process != to.process ||
            base_name(end_beyond(n_, *results).port) != "to_master")
            return complain(process, results == from.end() ? tasks : *results,
                            fmt::format("\"{}\" leads to the slave \"{}\", but \"{}\" is connected to {}",
                                        name(process, tasks.port), slave, name(process, port),
                                        results == from.end()
                                            ? "nothing"
                                            : fmt::format("\"{}\"", shown(n_, end_beyond(n_, *results)))),
                            fmt::format("connect {}.to_master to {};", slave, name(process, port)));
        tree.slaves.push_back(to.process);
        follow(to.process);
    }

    SlaveTree tree;

private:
    std::string name(std::size_t process, const std::string& port) const {
        return n_.processes[process].name + "." + port;
    }

    /// Returns the port of the opposite direction: "from_slaves[2]" for "to_slaves[2]".
    static std::string counterpart(const std::string& port, const std::string& base) {
        return base + port.substr(base_name(port).size());
    }

    void complain(std::size_t process, const PortBinding& port, std::string message, std::string hint) {
        tree.complaints.push_back({process, port.port, std::move(message), std::move(hint)});
    }

    /// Returns whether there is a single end without a subscript, or the subscripts are 0, 1, 2 ...
    bool are_numbered(std::size_t process, const std::vector<PortBinding>& ends) {
        if (ends.size() == 1 && subscripts_of(ends[0].port).empty())
            return true;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            auto base = std::string(base_name(ends[i].port)), wanted = fmt::format("{}[{}]", base, i);
            if (ends[i].port == wanted)
                continue;
            complain(process, ends[i],
                     fmt::format("\"{}\" is connected, but \"{}\" is not", name(process, ends[i].port),
                                 name(process, wanted)),
                     fmt::format("the channels {}[...] of a process must be numbered 0, 1, 2 ... without a gap", base));
            return false;
        }
        return true;
    }

    const Network& n_;
    std::map<std::size_t, std::string> reached_; ///< for each slave, the name of the port that leads to it
};

} // namespace

SlaveTree follow_slaves(const Network& network, std::size_t master) {
    Follower follower(network);
    follower.follow(master);
    return std::move(follower.tree);
}

std::vector<std::size_t> count_slaves_behind(const Network& network, std::size_t process) {
    std::vector<std::size_t> behind;
    auto channels = ends_of(network, process, "to_slaves");
    for (std::size_t i = 0; i + 1 < channels.size(); ++i) {
        Follower follower(network);
        follower.follow(process, channels[i], ends_of(network, process, "from_slaves"));
        behind.push_back(follower.tree.slaves.size() + follower.tree.others);
    }
    return behind;
}

std::vector<std::size_t> circle_of(const Network& network, std::size_t slave) {
    std::vector<std::size_t> way{slave};
    for (;;) {
        auto before = other_end(network, way.back(), "from_master");
        if (!before || !is_slave(network, *before))
            return {};
        if (before->process == slave)
            return way;
        if (std::ranges::count(way, before->process) > 0)
            return {}; // the slave is behind a circle of slaves, not in the circle
        way.push_back(before->process);
    }
}

} // namespace placedpar
