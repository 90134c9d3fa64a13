#pragma once

#include "runtime/channel.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/trace.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <tuple>
#include <vector>

namespace placedpar::test {

/// A machine of up to four transputers, and a program on it that does everything that meets on links: messages of all
/// lengths both ways on each, alone or several channels in packets, with ALTs, time-outs, messages given up, both
/// priorities, and computing in memory that the engines of the links use as well; faults, and switches that are set in
/// the middle of messages. All of it is drawn from the seed. Every other one is traced, which costs packets their
/// closed form here and there.
class RandomMachine {
public:
    RandomMachine(std::uint64_t seed, bool every_byte);

    RunResult run() { return simulation_.run(limit_); }
    /// When everything happened, what links and processors said of themselves at random moments, and what a trace was
    /// told of links.
    using Entry = std::tuple<std::int64_t, std::string, std::int64_t>;
    const std::vector<Entry>& log() const { return log_; }
    /// What the machine has, by name: so many of each.
    const std::vector<std::string>& features() const { return features_; }

private:
    struct Letter {
        int number = 0;
        std::uint32_t head = 0, body = 1;
        WireForm wire_form() const { return head > 0 ? WireForm(head, body) : WireForm(body); }
    };
    struct Lane {
        Channel<Letter> channel;
        bool can_be_given_up;
        explicit Lane(const std::string& name, bool can_be_given_up_)
            : channel(name), can_be_given_up(can_be_given_up_) {}
    };
    struct Node {
        hardware::Processor* processor;
        hardware::Router* router;
        std::vector<Lane*> inputs = {}; ///< of one process, which alternates between them
    };

    /// Of what links carry.
    struct Trace final : TraceSink {
        explicit Trace(std::vector<Entry>& l) : log(l) {}
        void began(const Process&, Time) override {}
        void waits(const Process&, Time) override {}
        void goes_on(const Process&, Time) override {}
        void computes(const Process&, Time) override {}
        void stops_computing(const Process&, Time) override {}
        void ended(const Process&, Time) override {}
        void communicated(const AnyChannel&, Time) override {}
        void carries(const std::string& direction, const AnyChannel&, Time now, Time since) override;
        void carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) override;
        void occupied(const std::string&, const std::string&, Time) override {}
        void vacated(const std::string&, Time) override {}
        void over(Time) override {}
        std::vector<Entry>& log;
    };

    void add_node();
    void add_link(bool every_byte);
    void add_faults(hardware::Link&);
    void lead_through_switch(hardware::Link&);
    void add_channel(hardware::LinkDirection&, Node& from, Node& to);
    void add_packets(hardware::RouterLink&, bool forth, Node& from, Node& to);
    Lane& add_lane(Node& from, Node& to, bool can_be_given_up);
    void add_computing(const Node&);
    void add_receiver(const Node&, const std::vector<Lane*>&);
    void observe();

    void send(Lane&, RandomStream);
    void receive(const std::vector<Lane*>&, RandomStream);
    void alternate(const std::vector<Lane*>&, RandomStream&);
    void receive_or_give_up(Lane&, RandomStream&);
    void note(const std::string& what, std::int64_t value);
    void has(const std::string& feature) { features_.push_back(feature); }
    Priority some_priority() { return random_.chance(0.5) ? Priority::high : Priority::low; }
    RandomStream stream(const char* of) { return RandomStream(random_.below(1'000'000), of); }

    RandomStream random_;
    Simulation simulation_;
    Time limit_;
    std::deque<Node> nodes_;
    std::deque<Lane> lanes_;
    std::vector<hardware::Link*> links_;
    std::vector<Entry> log_;
    Trace trace_{log_};
    std::vector<std::string> features_;
};

} // namespace placedpar::test
