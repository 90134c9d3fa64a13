#include "native/native_trace.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace placedpar {

namespace {

using native::Notice;
using native::Notices;

/// The processes at the ends of a channel of the netlist.
struct ChannelUsers {
    std::string outputter, inputter; ///< "" at the edge of the network
};

/// Passes the notices of all threads or ranks (the places of a native run) to a sink, in order of time.
class Replay {
public:
    Replay(const Network& network, const std::string& noun, const std::vector<Notices>& of_places, TraceSink& sink)
        : sink_(sink) {
        for (const NetworkChannel& channel : network.channels)
            users_[channel.name] = {name_of(network, channel.from), name_of(network, channel.to)};
        for (const Notices& notices : of_places)
            places_.push_back(place_with(notices, fmt::format("{} {}", noun, places_.size())));
    }

    /// Passes on the notices before `end`.
    void tell_until(Time end) {
        for (;;) {
            const auto earliest = std::ranges::min_element(places_, {}, &Place::next_time);
            if (earliest->next_time() >= end)
                return;
            tell(*earliest);
            ++earliest->next;
        }
    }

private:
    struct Place {
        const Notices& notices;
        std::string name;
        std::vector<std::uint64_t> channels; ///< the sink's number for each channel of this place
        std::size_t next = 0;

        Time next_time() const { return next < notices.all.size() ? notices.all[next].at : Time::max(); }
        const std::string& process(const Notice& notice) const { return notices.processes[notice.process]; }
        const std::string& channel(std::uint32_t number) const { return notices.channels[number]; }
    };

    static std::string name_of(const Network& network, const ChannelEnd& end) {
        return end.at_edge() ? "" : network.processes[end.process].name;
    }

    /// Makes a place, and numbers its channels. A channel of the netlist has the same number on all places. Other
    /// channels are local to a place; two places may have local channels with the same name.
    Place place_with(const Notices& notices, std::string name) {
        Place place{notices, std::move(name), {}};
        for (const std::string& channel : notices.channels)
            place.channels.push_back(users_.contains(channel)
                                         ? numbers_.try_emplace(channel, ++last_number_).first->second
                                         : ++last_number_);
        return place;
    }

    std::string partner_at(const std::string& channel, Activity activity) const {
        const auto found = users_.find(channel);
        if (found == users_.end())
            return "";
        return activity == Activity::outputting ? found->second.inputter : found->second.outputter;
    }

    void tell(const Place& place) const {
        const Notice& notice = place.notices.all[place.next];
        if (notice.kind == Notice::Kind::turn)
            tell_turn(place, notice);
        else
            tell_message(place, notice);
    }

    /// Passes on a change of a process's activity. A process that runs is shown as computing, because it occupies its
    /// thread.
    void tell_turn(const Place& place, const Notice& notice) const {
        Activity activity = static_cast<Activity>(notice.activity);
        std::vector<AwaitedByProgram> awaited;
        if (is_waiting(activity))
            for (const std::uint32_t number : place.notices.awaited[notice.subject])
                awaited.push_back({place.channel(number), partner_at(place.channel(number), activity)});
        if (activity == Activity::starting)
            activity = Activity::ready;
        else if (activity == Activity::executing)
            activity = Activity::computing;
        sink_.program_turns({place.process(notice), place.name, activity, awaited, notice.awaits_timer, ""}, notice.at);
    }

    void tell_message(const Place& place, const Notice& notice) const {
        const auto activity = static_cast<Activity>(notice.activity);
        const std::string& channel = place.channel(notice.subject);
        std::string partner = partner_at(channel, activity);
        const std::size_t other = activity == Activity::outputting ? place.next + 1 : place.next - 1;
        if (notice.kind == Notice::Kind::local_message && other < place.notices.all.size())
            partner = place.process(place.notices.all[other]);
        sink_.program_communicates({channel, place.channels[notice.subject] << 32 | notice.number,
                                    place.process(notice), partner, activity == Activity::inputting},
                                   notice.at);
    }

    TraceSink& sink_;
    std::map<std::string, ChannelUsers, std::less<>> users_; ///< by the name of the channel
    std::map<std::string, std::uint64_t, std::less<>> numbers_;
    std::uint64_t last_number_ = 0;
    std::vector<Place> places_;
};

std::shared_ptr<const DeviceKind> kind_of_places() {
    DeviceKind kind;
    kind.name = "processor";
    kind.noun = "a thread or rank";
    kind.executes = Execution::in_time;
    kind.drawing = {.frame = "#2f6b4f", .heading = "#d3ecdf", .legend = "thread or rank with its processes"};
    return std::make_shared<const DeviceKind>(std::move(kind));
}

} // namespace

void NativeTrace::set(std::string noun, std::vector<Notices> of_places) {
    noun_ = std::move(noun);
    of_places_ = std::move(of_places);
}

void NativeTrace::replay(const Network& network, TraceSink& sink) const {
    Replay replay(network, noun_, of_places_, sink);
    if (const Notices* const full = first_full()) {
        replay.tell_until(*full->full_at);
        return sink.ends_early(*full->full_at, why_full());
    }
    replay.tell_until(Time::max());
    sink.over(std::ranges::max(of_places_, {}, &Notices::over).over);
}

/// Returns the record that was full first; null if no record was full.
const Notices* NativeTrace::first_full() const {
    const auto when = [](const Notices& notices) { return notices.full_at.value_or(Time::max()); };
    const auto first = std::ranges::min_element(of_places_, {}, when);
    return first->full_at ? &*first : nullptr;
}

std::string NativeTrace::why_full() const {
    return fmt::format("the record of {} {} is full", noun_, first_full() - of_places_.data());
}

std::string NativeTrace::warning() const {
    if (!first_full())
        return "";
    return fmt::format("the timelines end at {}, where {} with {} events: make a shorter run, or one with fewer "
                       "messages\n",
                       to_string(*first_full()->full_at), why_full(), most_of(of_places_.size()));
}

Network with_places(Network network, const RunReport& run) {
    const std::shared_ptr<const DeviceKind> kind = kind_of_places();
    network.nodes.clear();
    network.connections.clear();
    network.pieces.clear();
    network.attachments.clear();
    std::map<std::string, std::size_t> numbers;
    for (const ProcessorUse& place : run.processors) {
        numbers[place.name] = network.nodes.size();
        Node& node = network.nodes.emplace_back();
        node.name = place.name;
        node.kind = kind;
    }
    for (std::size_t i = 0; i < network.processes.size(); ++i)
        network.processes[i].node = numbers.at(run.processes[i].processor);
    for (NetworkChannel& channel : network.channels) {
        for (ChannelEnd* const end : {&channel.from, &channel.to})
            end->node = end->at_edge() ? nowhere : network.processes[end->process].node;
        const bool crosses = channel.from.node != channel.to.node;
        channel.placement = {.kind = crosses ? ChannelPlacement::Kind::edge : ChannelPlacement::Kind::soft};
    }
    return network;
}

} // namespace placedpar
