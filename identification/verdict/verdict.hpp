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

/// What is said of a link.
enum class VerdictKind : unsigned char {
    sound,
    compliance,          ///< of hose, oil and cylinder: greater or smaller
    leak,                ///< past the piston, or out of the line
    offset,              ///< the spool is not where its sensor says
    drift,               ///< the spool is not where the servo-valve's voltage says
    leak_or_offset,      ///< one of the two, or a leak or a drift: the records do not tell which
    sensor,              ///< readings that no machine gives
    not_enough_evidence, ///< movements too few, too short or too noisy
    cannot_tell          ///< enough of them, which neither show that it is sound nor what is wrong
};

std::string_view name_of(VerdictKind);
/// "87 % sure"; nobody is surer than "more than 99 %".
std::string how_sure(double probability);
std::optional<VerdictKind> verdict_named(std::string_view);

struct Verdict {
    VerdictKind kind = VerdictKind::not_enough_evidence;
    /// How sure it is, of what was equally likely before. Of a fault: its share of sound and all_faults, each by the
    /// size that explains most. Of sound: its share of sound and what SequentialTest suspects, a unit each; so much of
    /// cannot_tell as well.
    double probability = 0;
    Deviation deviation;       ///< mean over the movements that count, from what the link is compared with
    std::size_t movements = 0; ///< that count
};

/// A size in units, and its standard error.
struct FaultSize {
    double by, standard_error;
};

/// How great the leak or the offset is, if a mean deviation comes from that fault alone; the likelier of the two leaks.
/// REQUIRES: leak or offset.
FaultSize size_alone(FaultHypothesis way, const Deviation& mean);

/// "either a leak of ... or a spool ...", both sizes, and which readings would tell.
std::string print_leak_or_offset(const Deviation& mean, const WayUnits& units);

/// Names what explains a mean deviation best: nothing wrong, or one fault alone, of the size that fits best.
/// A leak that begins when the valve opens and an offset are told apart only where one is nine times as likely.
/// What the valve's areas were found from decides what an offset is called.
Verdict verdict_of(const Deviation& mean, bool raised, hydraulics::AreasFrom valve);

/// Judges one link movement by movement: against itself, as its first movements were, and against its kind, so that
/// what has been wrong from the first day shows.
class LinkJudge {
public:
    /// Movements whose mean, weighted by what each knows, is the link's own state of health.
    static constexpr std::size_t movements_of_baseline = 3;
    /// A machine differs from its kind by up to a unit in health: twice as much is suspected.
    static constexpr double units_beyond_kind = 2;
    /// By the voltage a compliance comes out half a unit too great, since the valve's dead time is not known.
    static constexpr double servo_units_beyond_kind = 3;
    /// Usual movements know each way to a unit or better, steady ones one of them hardly better than nothing.
    static constexpr double most_uncertain = 2.5;
    /// Less sure that a link is sound means that what is suspected is likelier, all of it together.
    static constexpr double least_sure_sound = 0.5;

    struct State {
        std::vector<Deviation> first; ///< up to movements_of_baseline
        SequentialTest::State from_itself, from_kind;
        hydraulics::AreasFrom valve = hydraulics::AreasFrom::spool; ///< of the last movement
        bool impossible_now = false;                                ///< a reading since the last movement
        bool impossible = false; ///< one since the last movement whose readings made sense

        friend bool operator==(const State&, const State&) = default;
    };

    LinkJudge() = default;
    explicit LinkJudge(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkJudge&, const LinkJudge&) = default;

    /// Does a movement tell in which way a link is off, a steady leak taken for granted? One that leaves any way
    /// uncertain by more than most_uncertain units (half of the compliance, a leak of 12 %, an eightieth of an inch of
    /// spool) does not, however well it seems to know another: the pressure hardly moved, and what is left is noise of
    /// unknown size.
    static bool is_evidence(const Deviation& movement, hydraulics::AreasFrom valve);
    /// A movement is over. One with impossible readings, or without excitation, says nothing.
    void take(const Deviation& movement, hydraulics::AreasFrom valve);
    /// A reading that no machine gives: the verdict is sensor until a movement has none.
    void note_impossible() { state_.impossible_now = state_.impossible = true; }
    /// Sound only when that is likelier than not, off only by more than the standard error.
    Verdict verdict() const;
    /// What the link is compared with: the mean of its first movements, from its kind; none before there are enough.
    std::optional<Deviation> baseline() const;

private:
    State state_;
};

} // namespace placedpar::identification
