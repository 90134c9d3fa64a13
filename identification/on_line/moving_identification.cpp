#include "identification/on_line/moving_identification.hpp"

#include "gaprocs/fitness.hpp"
#include "hydraulics/data/sampling.hpp"
#include "identification/on_line/population_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// A link is faulty if its compliance deviates by more than `off_share` and by more than `off_errors` standard errors
/// (our choice).
constexpr double off_share = 0.15, off_errors = 3;

ValveReading valve_reading(const Record& record, std::size_t i, const PerLink<LinkConstants>& constants) {
    ValveReading reading;
    for (Link link : all_links) {
        auto read = [&](Sensor sensor) { return record.of(link, sensor)[i]; };
        const std::size_t l = index_of(link);
        reading.links.inlet_psi[l] = read(Sensor::inlet_pressure);
        reading.links.inlet_in2[l] = read(Sensor::inlet_area);
        reading.links.bypass_in2[l] = read(Sensor::bypass_area);
        reading.piston_in3[l] = constants[l].piston_in3_per_deg() * read(Sensor::angle);
    }
    return reading;
}

/// Returns the relative deviation of the compliance from a healthy link's compliance. Returns 0 if the link is not
/// faulty by `off_share` and `off_errors`.
double off(const LinkIdentified& link, const PerLink<double>& healthy) {
    const double share = link.compliance_in3_per_psi / healthy[index_of(link.link)] - 1;
    const double error = link.standard_error / healthy[index_of(link.link)];
    return std::abs(share) > std::max(off_share, off_errors * error) ? share : 0;
}

} // namespace

bool recognisable(const ChannelSet& there) {
    return std::ranges::all_of(all_links,
                               [&](Link link) { return there.contains(channels_needed(link, AreasFrom::areas)); });
}

MovingIdentification::MovingIdentification(const Parameters& machine, MovingSearch::WayFor way, std::uint64_t seed)
    : machine_(RecognisedMachine::of(machine)), constants_(link_constants(machine)), way_(std::move(way)), seed_(seed) {
}

void MovingIdentification::take(const Record& piece) {
    const Sampling sampling = Sampling::of(piece.period_s);
    const Record& record = sampling.readings > 1 ? averaged(piece, sampling) : piece;
    if (!search_) {
        period_s_ = record.period_s;
        search_.emplace(machine_, period_s_, way_, seed_, "", exact_fitness_terms);
    }
    for (std::size_t i = 0; i < record.size(); ++i)
        take(record, i);
}

void MovingIdentification::take(const Record& record, std::size_t i) {
    const double time_s = record.time_s[i];
    if (readings_ > 0 && time_s > time_s_ + 1.5 * period_s_)
        search_->restart();
    time_s_ = time_s;
    search_->take(valve_reading(record, i, constants_), time_s);
    ++recognition_.samples[static_cast<std::size_t>(search_->configuration())];
    if (record.configuration.size() == record.size())
        judge(record.configuration[i]);
    ++readings_;
}

void MovingIdentification::judge(char truth) {
    if (truth == '-')
        return;
    const char seen = name_of(search_->configuration());
    ++recognition_.judged;
    recognition_.right += seen == truth;
    if (truth_ != '-' && truth != truth_) {
        ++recognition_.changes;
        awaited_until_ = readings_ + 3;
    }
    truth_ = truth;
    if (seen == truth && readings_ < awaited_until_) {
        ++recognition_.soon;
        awaited_until_ = 0;
    }
}

std::vector<LinkIdentified> combined_links(const std::vector<SetAnswer>& sets) {
    std::vector<LinkIdentified> links;
    for (Link link : all_links) {
        std::vector<LeastSquares> results;
        std::vector<std::pair<LinkSet, LeastSquares>> of_sets;
        for (const SetAnswer& answer : sets)
            for (const LinkIdentified& found : answer.links)
                if (found.link == link && !found.flagged(FlagKind::unconfirmed)) {
                    results.push_back({found.compliance_in3_per_psi, found.standard_error});
                    of_sets.emplace_back(answer.set, results.back());
                }
        const LeastSquares mean = combined(results);
        if (!std::isfinite(mean.standard_error))
            continue;
        LinkIdentified found{link, mean.compliance_in3_per_psi, mean.standard_error};
        found.of_all_samples = mean;
        for (const auto& [set, result] : of_sets) {
            const double apart = std::abs(result.compliance_in3_per_psi - mean.compliance_in3_per_psi);
            const double error = std::hypot(result.standard_error, mean.standard_error);
            if (apart > off_errors * error && apart > uncertain_share * mean.compliance_in3_per_psi)
                found.flags.push_back({FlagKind::inconsistent,
                                       fmt::format("inconsistent: {} finds {:.5f} in^3/psi (standard error {:.5f}), "
                                                   "but all sets combined find {:.5f} in^3/psi (cross-check 1)",
                                                   name_of_set(set), result.compliance_in3_per_psi,
                                                   result.standard_error, mean.compliance_in3_per_psi)});
        }
        flag_limit(found);
        links.push_back(std::move(found));
    }
    return links;
}

std::string locate_faults(const std::vector<LinkIdentified>& links, const PerLink<double>& healthy) {
    std::string text;
    for (const LinkSet branch : {LinkSet{Link::bucket, Link::boom}, LinkSet{Link::stick, Link::swing}}) {
        std::vector<const LinkIdentified*> wrong;
        for (const LinkIdentified& link : links)
            if (branch.contains(link.link) && link.flags.empty() && off(link, healthy) != 0)
                wrong.push_back(&link);
        const bool shared = wrong.size() == 2 && off(*wrong[0], healthy) * off(*wrong[1], healthy) > 0;
        for (const LinkIdentified* link : wrong)
            text += fmt::format(
                "{}: in all sets, the compliance differs by {:+.0f} % from the constants of the machine: check {}\n",
                name_of(link->link), 100 * off(*link, healthy),
                shared ? "the pump and the supply of the valves, which both links of the branch share"
                       : "the link's hose, cylinder and oil");
    }
    return text.empty() ? "every link without a flag agrees with the constants of the machine\n" : text;
}

} // namespace placedpar::identification
