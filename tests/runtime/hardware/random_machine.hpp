#pragma once

#include "machine_log.hpp"
#include "random_lane.hpp"
#include "random_pace.hpp"
#include "random_program.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace placedpar::test {

/// A machine of up to four transputers, and a program on it that does everything that meets on links. Messages of all
/// lengths travel both ways on each link: of one channel, of several channels in packets, or by a link adapter. The
/// program uses ALTs, time-outs, both priorities, and messages that are given up again and again, and computes in
/// memory that the engines of the links use as well. Links have all speeds, faults, and switches that are set in the
/// middle of messages. Many runs get stuck. All of this is drawn from the seed. Every other one is traced, which costs
/// packets their closed form here and there.
class RandomMachine {
public:
    RandomMachine(std::uint64_t seed, bool every_byte);

    RunResult run();
    const std::vector<MachineLog::Entry>& log() const { return log_.entries(); }
    /// Whether of each channel everything came that has gone.
    bool lanes_are_whole() const;
    /// What the machine has, by name: so many of each.
    const std::vector<std::string>& features() const { return features_; }

private:
    struct Node {
        Executive* executive;           ///< null: its programs take no time
        hardware::Processor* processor; ///< the same, if it has memory that links use
        hardware::Router* router;
        std::vector<Lane*> inputs = {}; ///< of one process, which alternates between them
    };

    void add_node();
    void add_link(bool every_byte);
    hardware::LinkTiming some_timing();
    void add_faults(hardware::Link&);
    void lead_through_switch(hardware::Link&);
    void add_channels(hardware::Link&, Node& a, Node& b);
    void add_packets(hardware::RouterLink&, bool forth, Node& from, Node& to);
    void add_adapter(hardware::Link&, Node& transputer, bool at_a);
    bool also(double probability) { return !quiet_ && random_.chance(probability); }
    Lane& add_lane(Node& from, Node& to, bool can_be_given_up);
    void add_failures(Lane&);
    void add_receiver(const Node&, const std::vector<Lane*>&);
    void add_computing(hardware::Processor&);
    void observe(Time at);
    void has(const std::string& feature) { features_.push_back(feature); }
    void start(const std::string& name, Executive*, std::function<void(RandomProgram&)> body);

    RandomStream random_;
    std::int64_t bits_per_second_;
    RandomPace pace_;
    std::uint32_t most_rounds_; ///< of a program; 0 if it has no end
    bool quiet_; ///< nothing but the channels of one link: what is left of them is the last that happens in its run
    Time limit_;
    Simulation simulation_;
    std::deque<Node> nodes_, hosts_;
    std::deque<Lane> lanes_;
    std::vector<hardware::Link*> links_;
    std::vector<const hardware::FaultEffect*> effects_;
    MachineLog log_;
    std::vector<std::string> features_;
};

} // namespace placedpar::test
