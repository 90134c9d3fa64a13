#pragma once

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/data/sampling.hpp"
#include "identification/on_line/diagnosis_way.hpp"
#include "identification/on_line/population_set.hpp"
#include "identification/on_line/set_watch.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace placedpar::identification {

/// Diagnoses an excavator on line whose control system reports the configuration and the active links. Each set of
/// links in use has a population, which breeds with every sample, and is judged movement by movement.
class ReportedDiagnosis : public DiagnosisWay {
public:
    using Watches = std::map<hydraulics::LinkSet, SetWatch::State>;

    /// `name` is the name of the excavator, and part of the names of the random streams.
    ReportedDiagnosis(const ExcavatorParameters& parameters, const DiagnosisSettings& settings, std::uint64_t seed,
                      const std::string& name);
    /// Continues from states. `judged`: whether a verdict may have changed since the alarms were last determined.
    void go_on_from(std::map<hydraulics::LinkSet, PopulationSet::State> sets, Watches watches, bool judged);

    const std::map<hydraulics::LinkSet, PopulationSet>& sets() const { return sets_; }
    const Watches& watches() const { return watches_; }
    /// Returns the set's movement in progress; null if there is none.
    const Movement::State* movement(hydraulics::LinkSet set) const;

    /// Sets what the control system reports. REQUIRES: restart() has ended the movements of another configuration.
    void report(std::optional<hydraulics::Configuration> configuration, hydraulics::LinkSet active);
    /// Forgets the judgements of the link by movements.
    void forget(hydraulics::Link link);

    std::optional<hydraulics::Configuration> configuration() const override { return configuration_; }
    hydraulics::LinkSet active() const override { return active_; }
    hydraulics::LinkSet read_links() const override { return active_; }
    std::size_t take(const NewestSample&) override;
    void restart(const hydraulics::PerLink<double>& health_in3_per_psi) override;
    void note_impossible(hydraulics::Link link) override;
    std::optional<SetEstimates> estimates(hydraulics::LinkSet set) const override;
    /// Returns a verdict that states a fault, if a set gives one, and among several verdicts the verdict from the most
    /// movements.
    LinkVerdict verdict(hydraulics::Link link, double health_in3_per_psi) const override;
    double baseline_in3_per_psi(hydraulics::Link link, double health_in3_per_psi) const override;
    bool keeps_alarm(VerdictKind) const override { return false; }

private:
    std::vector<hydraulics::LinkSet> sets_in_use() const;
    std::size_t search(hydraulics::LinkSet set, const NewestSample& newest);
    void watch(hydraulics::LinkSet set, const SetSample& centre, const NewestSample& newest);
    void note_impossible(hydraulics::LinkSet set, hydraulics::Link link);
    void note(hydraulics::LinkSet set, std::optional<std::vector<Deviation>> judged);
    SetWatch::State& watch_of(hydraulics::LinkSet set);
    const SetProblem& problem(hydraulics::LinkSet set);
    PopulationSet& population(hydraulics::LinkSet set);

    ExcavatorParameters parameters_;
    DiagnosisSettings settings_;
    std::uint64_t seed_;
    std::string name_;
    hydraulics::Sampling sampling_;
    hydraulics::CentredLineFit fit_;
    std::optional<hydraulics::Configuration> configuration_;
    hydraulics::LinkSet active_;
    std::map<hydraulics::LinkSet, PopulationSet> sets_; ///< all sets ever used
    Watches watches_;                                   ///< one for each set ever used
    std::map<std::pair<hydraulics::Configuration, hydraulics::LinkSet>, SetProblem> problems_;
};

} // namespace placedpar::identification
