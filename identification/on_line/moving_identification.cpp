#include "identification/on_line/moving_identification.hpp"

#include "identification/on_line/population_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

constexpr double off_share = 0.15, off_errors = 3; ///< a link is faulty if its compliance deviates by more than this
                                                   ///< share and more than this many errors; our choice

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

bool excited(const std::vector<LinkSample>& links) {
    constexpr double least_slope_psi_per_s = 300; // four times the scatter that medium noise causes; our choice
    return std::ranges::any_of(
        links, [](const LinkSample& link) { return std::abs(link.inlet_slope_psi_per_s) > least_slope_psi_per_s; });
}

/// Returns the deviation from a healthy link as a share; 0 within the errors.
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

MovingIdentification::MovingIdentification(const Parameters& machine, WayFor way, std::uint64_t seed)
    : valve_(main_valve(machine)), limits_(cross_over_limits(machine)), constants_(link_constants(machine)),
      way_(std::move(way)), seed_(seed) {
    for (Link link : all_links)
        healthy_in3_per_psi_[index_of(link)] = machine[fmt::format("{}.inlet_compliance", name_of(link))];
}

void MovingIdentification::take(const Record& piece) {
    const Sampling sampling = Sampling::of(piece.period_s);
    const Record& record = sampling.readings > 1 ? averaged(piece, sampling) : piece;
    if (!watch_) {
        period_s_ = record.period_s;
        watch_.emplace(valve_, limits_, healthy_in3_per_psi_, period_s_);
    }
    for (std::size_t i = 0; i < record.size(); ++i)
        take(record, i);
}

void MovingIdentification::take(const Record& record, std::size_t i) {
    const double time_s = record.time_s[i];
    if (readings_ > 0 && time_s > time_s_ + 1.5 * period_s_) {
        watch_->restart();
        pending_.clear();
    }
    time_s_ = time_s;
    watch_->take(valve_reading(record, i, constants_));
    ++recognition_.samples[static_cast<std::size_t>(watch_->configuration())];
    if (record.configuration.size() == record.size())
        judge(record.configuration[i]);
    collect(time_s);
    ++readings_;
}

void MovingIdentification::judge(char truth) {
    if (truth == '-')
        return;
    const char seen = name_of(watch_->configuration());
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

void MovingIdentification::collect(double time_s) {
    const Configuration now = watch_->configuration();
    if (now != before_)
        pending_.clear();
    for (; !pending_.empty() && pending_.front().at + ConfigurationWatch::reach <= readings_;
         pending_.erase(pending_.begin()))
        search_of(pending_.front().set).add(now, std::move(pending_.front().sample));
    const std::vector<LinkSet> sets = sets_in_use(now, watch_->driven());
    for (LinkSet set : in_use_)
        if (now != before_ || std::ranges::find(sets, set) == sets.end())
            search_of(set).round();
    for (LinkSet set : sets)
        if (readings_ >= next_[set])
            if (auto links = watch_->samples(circuit_of(now, set)); links && excited(*links)) {
                pending_.push_back({readings_, set, {readings_, time_s, std::move(*links)}});
                next_[set] = readings_ + ConfigurationWatch::span;
            }
    in_use_ = sets;
    before_ = now;
}

SetSearch& MovingIdentification::search_of(LinkSet set) {
    return searches_
        .try_emplace(set, set, way_(set.size()), valve_.flow, RandomStream(seed_, std::string(name_of_set(set))))
        .first->second;
}

std::vector<SetAnswer> MovingIdentification::sets() {
    std::vector<SetAnswer> answers;
    for (LinkSet set : all_population_sets())
        if (auto found = searches_.find(set); found != searches_.end())
            if (auto answer = found->second.answer())
                answers.push_back(std::move(*answer));
    return answers;
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
