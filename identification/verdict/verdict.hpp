#pragma once

#include "hydraulics/circuit/link_calibration.hpp"
#include "identification/verdict/deviation.hpp"
#include "identification/verdict/sequential_test.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// What the on-line diagnosis says about the health of one link of an excavator.
enum class VerdictKind : unsigned char {
    sound,
    compliance,          ///< the compliance of hose, oil and cylinder is too great or too small
    leak,                ///< oil leaks past the piston, or out of the line
    offset,              ///< the spool is not at the position that its sensor reads
    drift,               ///< the spool is not at the position that the servo-valve's voltage demands
    leak_or_offset,      ///< either a leak, or an offset or a drift; the records do not tell which
    sensor,              ///< physically impossible readings, or readings that no state of the link explains
    not_enough_evidence, ///< too few movements, or movements too short or too noisy
    cannot_tell          ///< enough movements, which show neither that the link is sound nor what is wrong
};

std::string_view name_of(VerdictKind);
/// Returns "87 % sure", for example; above 0.99 it returns "more than 99 % sure".
std::string how_sure(double probability);
std::optional<VerdictKind> verdict_named(std::string_view);

struct Verdict {
    VerdictKind kind = VerdictKind::not_enough_evidence;
    /// The posterior probability, with equal priors. If the verdict is a fault, this is the probability of the fault;
    /// the alternatives are a sound link and the other faults, each at its most likely size. If the verdict is `sound`
    /// or `cannot_tell`, this is the probability of a sound link; the alternatives are SequentialTest::suspicions, each
    /// of one unit.
    double probability = 0;
    Deviation deviation;       ///< mean over the movements that count, measured from the link's healthy reference
    std::size_t movements = 0; ///< number of movements that count
    /// The number of newest movements that neither a sound link nor a fault explains, if the verdict is `sensor`
    /// for this reason; otherwise 0.
    std::size_t unexplained = 0;
};

/// The size of a fault and its standard error, in the units of WayUnits. One unit is a size that a verdict should
/// detect, such as 20 % of the compliance.
struct FaultSize {
    double by, standard_error;
};

/// Returns the size that the leak or the offset has if this fault alone causes the mean deviation. A leak may be there
/// before the movement or begin with it (LinkFault::leak, new_leak); the more likely of the two is used. REQUIRES:
/// `way` is leak or offset.
FaultSize size_alone(FaultHypothesis way, const Deviation& mean);

/// Returns "either a leak of ... or a spool ...", with both sizes and the readings that would distinguish leak and
/// offset.
std::string print_leak_or_offset(const Deviation& mean, const WayUnits& units);

/// Returns the best explanation of a mean deviation. If no fault was reported (`raised` is false), the verdict is
/// `sound`, otherwise one fault alone at its most likely size. If a leak or an offset is most likely, but neither is
/// nine times as likely as the other, the verdict is `leak_or_offset`. An offset is called `drift` if `valve`, the
/// source of the areas, is the voltage.
Verdict verdict_of(const Deviation& mean, bool raised, hydraulics::AreasFrom valve);

/// Judges one link, movement by movement. Compares the link with its own first movements, and with healthy machines of
/// its kind. The second comparison finds faults that the link had from the first day.
class LinkJudge {
public:
    /// The weighted mean of this number of first movements is the healthy reference of the link.
    static constexpr std::size_t movements_of_baseline = 3;
    /// The deviation from healthy machines of its kind at which a link is suspected, in the units of WayUnits. Healthy
    /// machines deviate by up to one unit.
    static constexpr double units_beyond_kind = 2;
    /// This limit replaces `units_beyond_kind` for the compliance if the spool's position is computed from the voltage.
    /// The valve's unknown dead time then makes the compliance half a unit too great.
    static constexpr double servo_units_beyond_kind = 3;
    /// The greatest accepted standard error, in the units of WayUnits. Usual movements determine each deviation to
    /// within one unit. Steady movements leave one deviation almost undetermined.
    static constexpr double most_uncertain = 2.5;
    /// The least probability of a sound link for the verdict `sound`. Below this limit, the suspected faults together
    /// are more likely than a sound link.
    static constexpr double least_sure_sound = 0.5;
    /// The greatest MovementFit::misfit of an explained movement (our choice). In 420 movements of sound simulated
    /// machines, at four levels of noise and periods from .005 to .08 s, it was at most 1.8; with a spool sensor that
    /// is stuck, it is about 300.
    static constexpr double greatest_misfit = 4;
    /// The number of unexplained movements in a row after which the link no longer counts as sound (our choice).
    static constexpr std::size_t most_unexplained = 2;

    struct State {
        std::vector<Deviation> first; ///< the first movements, at most movements_of_baseline
        SequentialTest::State from_itself, from_kind;
        hydraulics::AreasFrom valve = hydraulics::AreasFrom::spool; ///< source of the last movement's areas
        /// The number of movements, since the last one that counts, whose readings the equations do not explain.
        std::size_t unexplained = 0;
        bool impossible_now = false; ///< whether a reading since the end of the last movement was impossible
        bool impossible = false; ///< whether a reading was impossible since the last movement with plausible readings

        friend bool operator==(const State&, const State&) = default;
    };

    LinkJudge() = default;
    explicit LinkJudge(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkJudge&, const LinkJudge&) = default;

    /// Returns whether a movement determines a link's deviations, assuming a steady leak. A movement does not determine
    /// them if a deviation has a standard error of more than `most_uncertain` units (half of the compliance, a leak of
    /// 12 % of the steady flow, or 1/80 inch of the spool's position). In such a movement the pressure hardly changes,
    /// and the samples are mostly noise of unknown size.
    static bool is_evidence(const Deviation& movement, hydraulics::AreasFrom valve);
    /// Adds a finished movement. Ignores a movement that had impossible readings or is not evidence. `misfit` is
    /// MovementFit::misfit. A movement that would be evidence without its great misfit counts as unexplained.
    void take(const Deviation& movement, hydraulics::AreasFrom valve, double misfit = 1);
    /// Records an impossible reading. The verdict is then `sensor` until a movement has no impossible reading.
    void note_impossible() { state_.impossible_now = state_.impossible = true; }
    /// Returns the verdict after all movements so far. The verdict is `sound` only if its probability is at least
    /// `least_sure_sound` and the newest movements are explained, and a fault only if the fault's size exceeds its
    /// standard error.
    Verdict verdict() const;
    /// Returns the reference of the link: the mean of its first movements, relative to its kind. Returns nullopt until
    /// there are enough movements.
    std::optional<Deviation> baseline() const;

private:
    State state_;
};

} // namespace placedpar::identification
