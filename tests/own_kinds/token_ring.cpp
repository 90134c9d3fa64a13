#include "tests/own_kinds/token_ring.hpp"

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/kinds/machine_node.hpp"
#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"
#include "text/reporter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

TokenRing::TokenRing(Kernel& kernel, std::string name, std::int64_t bits_per_second, Time hop,
                     const std::vector<std::string>& stations)
    : kernel_(kernel), name_(std::move(name)), bits_per_second_(bits_per_second), hop_(hop),
      left_(stations.empty() ? 0 : stations.size() - 1) {
    for (const std::string& each : stations)
        stations_.push_back({each});
}

void TokenRing::send(std::size_t station, std::int64_t bytes, const AnyChannel& channel, const SourceLocation& where) {
    Process& self = kernel_.running();
    waiting_.push_back({&self, &channel, station, bytes, kernel_.now()});
    if (TraceSink* trace = kernel_.trace())
        trace->takes({track_of(station), "waits for the token", kernel_.now()}, kernel_.now());
    if (!end_frame_.scheduled())
        pass_token();
    self.wait_for(Activity::outputting, &channel, where);
}

/// Returns when the free token next passes the station.
Time TokenRing::arrival_at(std::size_t station) const {
    const auto round = static_cast<std::int64_t>(stations_.size());
    std::int64_t hops = static_cast<std::int64_t>(station) - static_cast<std::int64_t>(left_);
    hops = hops > 0 ? hops : hops + round;
    Time late = kernel_.now() - left_at_ - hops * hop_;
    if (late > Time{0})
        hops += (late + round * hop_ - Time{1}) / (round * hop_) * round;
    return left_at_ + hops * hop_;
}

void TokenRing::pass_token() {
    if (waiting_.empty())
        return;
    std::ranges::stable_sort(waiting_, {}, [this](const Frame& each) { return arrival_at(each.station); });
    if (Time arrival = arrival_at(waiting_.front().station); !breaks_at_ || arrival < *breaks_at_)
        kernel_.future().reschedule(begin_frame_, arrival, EventQueue::arrival);
}

void TokenRing::begin_frame() {
    const Frame& frame = waiting_.front();
    Station& sender = stations_[frame.station];
    began_ = kernel_.now();
    ++sender.frames;
    sender.bytes += static_cast<std::uint64_t>(frame.bytes);
    sender.waited += began_ - frame.asked;
    kernel_.future().schedule(end_frame_, began_ + duration_of(8 * (frame.bytes + header_bytes), bits_per_second_),
                              EventQueue::arrival);
    if (TraceSink* trace = kernel_.trace()) {
        trace->leaves({track_of(frame.station), began_}, began_);
        trace->takes({name_, sender.name, began_}, began_);
    }
}

void TokenRing::end_frame() {
    Frame frame = waiting_.front();
    waiting_.pop_front();
    left_ = frame.station;
    left_at_ = kernel_.now();
    busy_ += left_at_ - began_;
    if (TraceSink* trace = kernel_.trace())
        trace->leaves({name_, left_at_}, left_at_);
    kernel_.make_ready(*frame.process);
    pass_token();
}

std::vector<std::string> TokenRing::waiting_channels() const {
    std::vector<std::string> names;
    for (const Frame& each : waiting_)
        names.push_back(each.channel->name());
    return names;
}

void RingLane::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    std::int64_t left = form.total();
    do {
        std::int64_t bytes = std::min(left, TokenRing::most_bytes);
        left -= bytes;
        ring_.send(from_, bytes, channel, where);
    } while (left > 0);
    turn(true);
    channel.announce();
    wait_until(false, channel, where);
}

void RingLane::input(AnyChannel& channel, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    wait_until(true, channel, where);
    channel.hand_over();
    turn(false);
}

void RingLane::wait_until(bool full, const AnyChannel& channel, const SourceLocation& where) {
    if (full_ == full)
        return;
    waiting_ = &kernel_.running();
    waiting_->wait_for(full ? Activity::inputting : Activity::outputting, &channel, where);
}

void RingLane::turn(bool full) {
    full_ = full;
    if (Process* process = std::exchange(waiting_, nullptr))
        kernel_.make_ready(*process);
}

namespace {

/// Returns its attachments in the order of their slots.
std::vector<std::size_t> stations_of(const Network& network, std::size_t ring) {
    std::vector<std::size_t> stations;
    for (std::size_t i = 0; i < network.attachments.size(); ++i)
        if (network.attachments[i].bus == ring)
            stations.push_back(i);
    std::ranges::sort(stations, {}, [&](std::size_t i) { return network.attachments[i].slot; });
    return stations;
}

std::vector<std::string> names_of_stations(const Network& network, std::size_t ring) {
    std::vector<std::string> names;
    for (std::size_t i : stations_of(network, ring))
        names.push_back(network.nodes[network.attachments[i].node].name);
    return names;
}

class RingNode final : public MachineNode {
public:
    RingNode(MachineParts& parts, std::size_t index)
        : MachineNode(parts, index), stations_(stations_of(network(), index)),
          ring_(simulation().add<TokenRing>(node().name, node().integer("bitrate"),
                                            Time{std::chrono::nanoseconds{node().integer("hop")}},
                                            names_of_stations(network(), index))) {}

    CarrierPair carriers(std::size_t connection) override {
        const BusWay& way = *network().connections[connection].over_bus;
        return {&lane(way.master), &lane(way.slave)};
    }

    FaultEffects suffer(const Fault& fault) override {
        ring_.break_at(begin_of(fault));
        return [this](FaultUse& use) { use.stopped_channels = ring_.waiting_channels(); };
    }

    void report(MachineUse& use) const override {
        DeviceUse& table = use.devices.emplace_back(
            DeviceUse{"ring " + node().name, ring_.time_busy(), {"station", "frames", "bytes", "waiting"}, {}});
        for (const TokenRing::Station& each : ring_.stations())
            table.rows.push_back({each.name, {each.frames, each.bytes, each.waited}});
    }

private:
    RingLane& lane(std::size_t attachment) const {
        auto station = static_cast<std::size_t>(std::ranges::find(stations_, attachment) - stations_.begin());
        return simulation().add<RingLane>(ring_, station);
    }

    std::vector<std::size_t> stations_; ///< attachments
    TokenRing& ring_;
};

bool takes_station(const Attached& attached, const BusAttachment& station) {
    const Network& network = attached.network;
    auto refuse = [&](const std::string& message, const char* hint) {
        attached.reporter.error(station.connected, message, hint);
        return false;
    };
    if (!network.nodes[station.node].kind->is_master())
        return refuse(fmt::format("\"{}\" cannot be a station of a ring", network.nodes[station.node].name),
                      "workstations and bus masters can");
    for (const BusAttachment& other : network.attachments)
        if (other.bus == station.bus && other.slot == station.slot)
            return refuse(
                fmt::format("two stations are in slot {} of \"{}\"", station.slot, network.nodes[station.bus].name),
                "each has a slot of its own");
    return true;
}

/// Each station reaches all others.
std::vector<BusWay> ways_over_ring(const Attached& attached, std::size_t ring) {
    std::vector<BusWay> ways;
    for (std::size_t a : stations_of(attached.network, ring))
        for (std::size_t b : stations_of(attached.network, ring))
            if (a < b)
                ways.push_back({a, b, nowhere});
    return ways;
}

std::vector<std::string> ring_tracks(const Network& network, std::size_t ring) {
    std::vector<std::string> tracks{network.nodes[ring].name};
    for (const std::string& station : names_of_stations(network, ring))
        tracks.push_back(network.nodes[ring].name + " <- " + station);
    return tracks;
}

} // namespace

DeviceKind token_ring() {
    using namespace description;
    return {
        .name = "token ring",
        .noun = "a ring",
        .about = "A token ring with slot[1] to slot[8], for workstations and bus masters.",
        .models = {{.name = "RING"}},
        .attributes = {{.value = integer("bitrate", {.unit = "bit/s", .by_default = 4'000'000, .least = 1}, "of it"),
                        .decimal_suffixes = true,
                        .json_name = "bits_per_second"},
                       {.value = integer("hop", {.unit = "ns", .by_default = 1000, .least = 1},
                                         "of the token, from a station to the next"),
                        .json_name = "hop_ns"}},
        .medium = Medium{.slots = 8, .takes = takes_station, .ways = ways_over_ring},
        .faults = {{.name = "breaks", .about = "no station gets the token", .attributes = {fault_begins()}}},
        .tracks = ring_tracks,
        .make = make_device<RingNode>,
        .drawing = {.frame = "#2b6b8a", .heading = "#cbe6f6", .legend = "token ring"}};
}

} // namespace placedpar
