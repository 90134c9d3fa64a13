#include "netlist/machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace placedpar {

namespace {

/// 5 ns a metre of wire (transmission line); 1.75 bit times in each crossbar switch (C004 manual). A link overlaps its
/// acknowledges where both of its ends can.
LinkTiming timing_of(const LinkConnection& connection, const std::vector<Node>& nodes) {
    LinkTiming timing{.bits_per_second = connection.bits_per_second};
    for (const LinkEnd& end : {connection.a, connection.b})
        timing.overlapped_acknowledge = timing.overlapped_acknowledge && nodes[end.node].overlapped_acknowledge;
    timing.wire_delay = Time{static_cast<std::int64_t>(connection.metres * 5000.0)} +
                        duration_of(175 * connection.switches(), 100 * connection.bits_per_second);
    return timing;
}

[[noreturn]] void refuse(const Location& location, const std::string& why) {
    std::string place = location.text();
    throw std::invalid_argument(place.empty() ? why : place + ": " + why);
}

const ProcessKind& kind_of(const ProcessInstance& process, const Catalogue& catalogue) {
    if (const ProcessKind* kind = catalogue.find(process.kind))
        return *kind;
    if (process.kind.empty())
        refuse(process.declared,
               fmt::format("process {} has no program: say use \"kind\" for {};", process.name, process.name));
    refuse(process.declared,
           fmt::format("process {} runs \"{}\", a program that PlacedPar does not have: it can be shown, not run",
                       process.name, process.kind));
}

void mix_text(Fingerprint& fingerprint, std::string_view text) {
    for (char c : text)
        fingerprint.mix(static_cast<unsigned char>(c));
}

/// A process's program. What it refuses to work with is said with the process, its kind and its place.
void run_body(const ProcessInstance& process, const std::function<void(ProcessEnvironment&)>& body,
              ProcessEnvironment& environment) {
    try {
        body(environment);
    } catch (const std::invalid_argument& refused) {
        refuse(process.declared, fmt::format("process {} ({}): {}", process.name, process.kind, refused.what()));
    }
}

/// The order of events, and with it what the processes found out.
std::uint64_t fingerprint_of(std::uint64_t events, const std::vector<Measurement>& measurements) {
    Fingerprint fingerprint;
    fingerprint.mix(events);
    for (const Measurement& m : measurements) {
        mix_text(fingerprint, m.process);
        mix_text(fingerprint, m.name);
        if (const auto* number = std::get_if<double>(&m.value))
            fingerprint.mix(std::bit_cast<std::uint64_t>(*number));
        else
            mix_text(fingerprint, std::get<std::string>(m.value));
    }
    return fingerprint.value();
}

double fraction(Time part, Time whole) {
    return whole > Time{0} ? static_cast<double>(part.count()) / static_cast<double>(whole.count()) : 0;
}

} // namespace

Machine::Machine(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(network), seed_(seed) {
    make_processors();
    make_links();
    make_channels(catalogue);
    make_processes(catalogue);
}

void Machine::make_processors() {
    for (const Node& node : network_.nodes)
        processors_.push_back(
            node.kind == NodeKind::processor
                ? &simulation_.add<Processor>(node.name, node.clock_hz, Cycles{node.channel_call_cycles})
                : nullptr);
}

void Machine::make_links() {
    for (const LinkConnection& connection : network_.connections)
        links_.push_back(&simulation_.add<Link>(timing_of(connection, network_.nodes)));
    multiplexers_.resize(links_.size());
    // A link that is shared in one direction is shared in both: acknowledge packets travel the other way.
    for (const NetworkChannel& channel : network_.channels) {
        std::size_t c = channel.placement.connection;
        if (channel.placement.kind != ChannelPlacement::Kind::link || !channel.placement.shared || multiplexers_[c])
            continue;
        const LinkConnection& connection = network_.connections[c];
        multiplexers_[c] =
            &simulation_.add<Multiplexer>(fmt::format("{} - {}", link_name(connection.a), link_name(connection.b)),
                                          *links_[c], processors_[connection.a.node], processors_[connection.b.node]);
    }
}

void Machine::make_channels(const Catalogue& catalogue) {
    for (const NetworkChannel& channel : network_.channels) {
        if (channel.placement.kind == ChannelPlacement::Kind::edge)
            refuse(channel.connected,
                   fmt::format("channel {} leads to an edge, where nobody is: to run it, place a process there on a "
                               "workstation",
                               channel.name));
        const ProcessKind& kind = kind_of(network_.processes[channel.from.process], catalogue);
        channels_.push_back(kind.port(base_name(channel.from.port))->make_channel(channel.name));
        if (channel.placement.kind == ChannelPlacement::Kind::link)
            carry(*channels_.back(), channel);
    }
}

void Machine::carry(AnyChannel& channel, const NetworkChannel& description) {
    std::size_t c = description.placement.connection;
    bool forth = description.placement.from_a_to_b;
    if (multiplexers_[c])
        channel.put_on(multiplexers_[c]->add_channel(forth));
    else
        channel.put_on(forth ? links_[c]->from_a_to_b() : links_[c]->from_b_to_a());
}

void Machine::make_processes(const Catalogue& catalogue) {
    for (const ProcessInstance& process : network_.processes) {
        const ProcessKind& kind = kind_of(process, catalogue);
        std::vector<ProcessEnvironment::Port> ports;
        for (const PortBinding& binding : process.ports)
            ports.push_back({binding.port, channels_[binding.channel].get()});
        ProcessEnvironment& environment =
            environments_.emplace_back(process.name, process.parameters, std::move(ports), seed_, measurements_);
        processes_.push_back(&simulation_.process(
            process.name, [&process, &environment, body = kind.body] { run_body(process, body, environment); },
            processors_[process.node], process.high_priority ? Priority::high : Priority::low));
    }
    for (std::size_t i = 0; i < channels_.size(); ++i)
        channels_[i]->expect(processes_[network_.channels[i].from.process],
                             processes_[network_.channels[i].to.process]);
}

std::string Machine::link_name(const LinkEnd& end) const {
    const std::string& node = network_.nodes[end.node].name;
    return end.link < 0 ? node : fmt::format("{}.link[{}]", node, end.link);
}

RunReport Machine::run(Time limit) { return report(simulation_.run(limit)); }

RunReport Machine::report(RunResult result) const {
    RunReport report{std::move(result), measurements_, {}, {}, {}};
    report.result.fingerprint = fingerprint_of(report.result.fingerprint, measurements_);
    Time whole = report.result.time;
    for (std::size_t i = 0; i < processors_.size(); ++i)
        if (processors_[i])
            report.processors.push_back(
                {network_.nodes[i].name, network_.nodes[i].type, fraction(processors_[i]->time_busy(), whole)});
    for (std::size_t i = 0; i < links_.size(); ++i) {
        std::string a = link_name(network_.connections[i].a), b = link_name(network_.connections[i].b);
        auto data_time = [&](std::uint64_t bytes) {
            return times(static_cast<std::int64_t>(bytes), timing_of(network_.connections[i], network_.nodes).data());
        };
        const LinkDirection& forth = links_[i]->from_a_to_b();
        const LinkDirection& back = links_[i]->from_b_to_a();
        report.links.push_back({a, b, forth.bytes_carried(), fraction(data_time(forth.bytes_carried()), whole)});
        report.links.push_back({b, a, back.bytes_carried(), fraction(data_time(back.bytes_carried()), whole)});
    }
    for (std::size_t i = 0; i < processes_.size(); ++i)
        report.processes.push_back({network_.processes[i].name, network_.nodes[network_.processes[i].node].name,
                                    fraction(processes_[i]->time_waited(), whole)});
    return report;
}

namespace {

const Measurement& find_measurement(const RunReport& report, std::string_view process, std::string_view name) {
    auto found = std::ranges::find_if(report.measurements,
                                      [&](const Measurement& m) { return m.process == process && m.name == name; });
    if (found == report.measurements.end())
        throw std::out_of_range(fmt::format("process {} measured no {}", process, name));
    return *found;
}

} // namespace

double RunReport::measured(std::string_view process, std::string_view name) const {
    return std::get<double>(find_measurement(*this, process, name).value);
}

const std::string& RunReport::measured_text(std::string_view process, std::string_view name) const {
    return std::get<std::string>(find_measurement(*this, process, name).value);
}

} // namespace placedpar
