#include "netlist/machine.hpp"

namespace placedpar {

namespace {

double fraction(Time part, Time whole) {
    return whole > Time{0} ? static_cast<double>(part.count()) / static_cast<double>(whole.count()) : 0;
}

LinkUse link_use(std::string from, std::string to, std::uint64_t bytes, Time byte_time, Time whole) {
    return {std::move(from), std::move(to), bytes, fraction(times(static_cast<std::int64_t>(bytes), byte_time), whole)};
}

} // namespace

RunReport Machine::report(RunResult result) const {
    result.fingerprint = fingerprint_with(result.fingerprint, measurements_);
    Time whole = result.time;
    return {std::move(result), measurements_, processor_uses(whole), link_uses(whole), process_uses(whole)};
}

std::vector<ProcessorUse> Machine::processor_uses(Time whole) const {
    std::vector<ProcessorUse> uses;
    for (std::size_t i = 0; i < executives_.size(); ++i)
        if (const auto& time_busy = executives_[i].time_busy)
            uses.push_back({network_.nodes[i].name, network_.nodes[i].type, fraction(time_busy(), whole)});
    return uses;
}

std::vector<LinkUse> Machine::link_uses(Time whole) const {
    std::vector<LinkUse> uses;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const LinkConnection& connection = network_.connections[i];
        auto a = link_name(network_.nodes, connection.a), b = link_name(network_.nodes, connection.b);
        Time byte_time = hardware::LinkTiming{.bits_per_second = connection.bits_per_second}.data();
        uses.push_back(link_use(a, b, links_[i]->from_a_to_b().bytes_carried(), byte_time, whole));
        uses.push_back(link_use(b, a, links_[i]->from_b_to_a().bytes_carried(), byte_time, whole));
    }
    return uses;
}

std::vector<ProcessUse> Machine::process_uses(Time whole) const {
    std::vector<ProcessUse> uses;
    for (std::size_t i = 0; i < processes_.size(); ++i)
        uses.push_back({network_.processes[i].name, network_.nodes[network_.processes[i].node].name,
                        fraction(processes_[i]->time_waited(), whole)});
    return uses;
}

} // namespace placedpar
