#include "monitor/service/netlist_searches.hpp"

#include "hydraulics/circuit/line_fit.hpp"
#include "identification/on_line/population_sets.hpp"
#include "identification/verdict/movement.hpp"

#include <boost/asio/post.hpp>

#include <algorithm>
#include <exception>
#include <utility>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace {

/// The slope at a sample is fitted to this number of samples on each side.
constexpr std::size_t slope_side = line_fit_points / 2;

void keep_last(std::vector<CircuitSample>& samples, std::size_t most) {
    samples.erase(samples.begin(), samples.end() - static_cast<std::ptrdiff_t>(std::min(samples.size(), most)));
}

} // namespace

std::vector<NetlistAnswer> NetlistSearches::answers(const std::string& machine) const {
    std::vector<NetlistAnswer> answers;
    if (auto found = machines_.find(machine); found != machines_.end())
        for (const auto& [set, recording] : found->second)
            if (recording->answer)
                answers.push_back(*recording->answer);
    return answers;
}

void NetlistSearches::follow(const Diagnosis& diagnosis) {
    Recordings& recordings = machines_[diagnosis.name()];
    const std::vector<LinkSet> in_use = diagnosis.sets_in_use();
    for (LinkSet set : in_use)
        recordings.try_emplace(set, std::make_shared<Recording>());
    for (auto& [set, recording] : recordings) {
        const bool moves = diagnosis.movement(set) != nullptr;
        if (std::exchange(recording->moves, moves) && !moves)
            search(diagnosis, set, recording);
        if (std::ranges::count(in_use, set) > 0)
            record(diagnosis, set, *recording);
        else
            recording->samples.clear();
    }
}

void NetlistSearches::record(const Diagnosis& diagnosis, LinkSet set, Recording& recording) {
    auto& samples = recording.samples;
    if (samples.empty())
        recording.circuit = circuit_of(*diagnosis.configuration(), set);
    CircuitSample sample{0, diagnosis.sample_s().value_or(0) - slope_side * diagnosis.sampling().period_s(), {}};
    for (const Junction& junction : recording.circuit)
        if (auto centre = diagnosis.centre(junction.link))
            sample.links.push_back(*centre);
    if (sample.links.size() < recording.circuit.size()) // after a gap or a change of configuration
        samples.clear();
    else if (samples.empty() || sample.time_s != samples.back().time_s) // the reading completes a sample
        samples.push_back(std::move(sample));
    if (!recording.moves)
        keep_last(samples, diagnosis.sampling().samples_in(Movement::rest_s));
}

void NetlistSearches::search(const Diagnosis& diagnosis, LinkSet set, const std::shared_ptr<Recording>& recording) {
    auto& [circuit, samples, moves, answered] = *recording;
    const FlowConstants& flow = diagnosis.parameters().flow;
    const double period_s = diagnosis.sampling().period_s(), side_s = slope_side * period_s;
    NetlistAnswer answer{
        diagnosis.name(), set, samples.front().time_s - side_s, samples.back().time_s + side_s, circuit, "", {}};
    ComplianceSearch prepared{CircuitProblem(circuit, flow, bits_), flow, {}, samples};
    keep_last(samples, Movement::slope_reach + line_fit_points); // the next movement may have begun
    if (waiting_ == most_waiting) {
        answer.wrong = "skipped: too many movements wait for the search";
        return tell_(answered.emplace(answer));
    }
    ++waiting_;
    auto job = [this, prepared = std::move(prepared), period_s, answer, asking = std::weak_ptr(recording)]() mutable {
        try {
            answer.found = search_(std::move(prepared), period_s);
        } catch (const std::exception& error) {
            answer.wrong = error.what();
        }
        boost::asio::post(io_, [this, answer, asking] {
            --waiting_;
            if (auto recording = asking.lock()) // the machine was not forgotten meanwhile
                tell_(recording->answer.emplace(answer));
        });
    };
    boost::asio::post(thread_, std::move(job));
}

} // namespace placedpar::monitor
