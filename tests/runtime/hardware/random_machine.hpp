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

/// A random machine of up to four transputers, with a program that combines all events on links. All choices come from
/// the seed. Messages of all lengths travel in both directions on each link: on one channel, on several channels in
/// packets, or through a link adapter. The program uses ALTs, time-outs, both priorities, and messages that are given
/// up repeatedly. It computes in memory that link engines also use. Links have various speeds, faults, and switches
/// that are set within messages. Many runs deadlock. Every other machine is traced, which at times prevents the closed
/// form of packets.
class RandomMachine {
public:
    RandomMachine(std::uint64_t seed, bool every_byte);

    RunResult run();
    const std::vector<MachineLog::Entry>& log() const { return log_.entries(); }
    /// Returns whether all sent letters arrived on each channel.
    bool lanes_are_whole() const;
    /// Returns the names of the machine's features. A feature that occurs several times is listed several times.
    const std::vector<std::string>& features() const { return features_; }

private:
    struct Node {
        Executive* executive;           ///< null: the programs take no time
        hardware::Processor* processor; ///< the same executive if link engines use its memory
        hardware::Router* router;
        std::vector<Lane*> inputs = {}; ///< inputs of one process, which alternates between them
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
    std::uint32_t most_rounds_; ///< rounds of a program; 0 if it never ends
    bool quiet_; ///< the machine has only the channels of one link, so the last packets of the link end the run
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
