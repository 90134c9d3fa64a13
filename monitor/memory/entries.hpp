#pragma once

#include <boost/describe.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace placedpar::identification {
struct DiagnosisState; // identification/on_line/diagnosis.hpp
}

namespace placedpar::monitor {

/// What the state file is told, and what it gives back. Times called `at` are of this computer's clock, in seconds
/// since 1970, `time_s` of the control system's.

/// A message that a diagnosis took. Numbers count all machines' messages, without a gap.
struct KeptMessage {
    std::uint64_t number;
    std::string machine;
    std::string text;

    friend bool operator==(const KeptMessage&, const KeptMessage&) = default;
};

/// A diagnosis after the message of this number, or, if that is another machine's, after its last one before.
struct KeptState {
    std::string machine;
    std::uint64_t taken;
    std::string state; ///< state_json()

    friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// The same before it has been written: a copy, of which whoever keeps it makes the text.
struct UnwrittenState {
    std::string machine;
    std::uint64_t taken;
    std::shared_ptr<const identification::DiagnosisState> state;
};

/// Nothing is known of the machine any more, nor is its history. Its messages are still there: one with the text
/// `forget_text` has to stand behind them.
struct ForgottenMachine {
    std::string machine;
};
inline constexpr const char* forget_text = "forget";

/// The messages up to this number are in their machines' states.
struct TrimmedMessages {
    std::uint64_t up_to;
};

/// A compliance that has settled.
struct KeptEstimate {
    std::string machine;
    double at, time_s;
    std::string set, link;
    double compliance_in3_per_psi;
    std::optional<double> error_in3_per_psi;

    friend bool operator==(const KeptEstimate&, const KeptEstimate&) = default;
};
BOOST_DESCRIBE_STRUCT(KeptEstimate, (), (machine, at, time_s, set, link, compliance_in3_per_psi, error_in3_per_psi))

/// An alarm from when it was raised. One of the same kind and links is the same alarm; while it holds it is not raised
/// again.
struct KeptAlarm {
    std::string machine;
    std::string kind, links; ///< links as "BU BO"
    std::string text;
    double raised_at = 0;
    std::optional<double> raised_time_s, cleared_at, acknowledged_at, shelved_until;

    bool same_as(const KeptAlarm& other) const {
        return machine == other.machine && kind == other.kind && links == other.links;
    }
    friend bool operator==(const KeptAlarm&, const KeptAlarm&) = default;
};
BOOST_DESCRIBE_STRUCT(KeptAlarm, (),
                      (machine, kind, links, text, raised_at, raised_time_s, cleared_at, acknowledged_at,
                       shelved_until))

/// The newest alarm of this machine, kind and links is now so.
struct ChangedAlarm {
    KeptAlarm alarm;
};

/// All alarms that hold, after some changes were lost: any other that is open was cleared, at the latest by then.
struct OpenAlarms {
    std::vector<KeptAlarm> alarms;
    double at;
};

using Entry = std::variant<KeptMessage, KeptState, UnwrittenState, ForgottenMachine, TrimmedMessages, KeptEstimate,
                           KeptAlarm, ChangedAlarm, OpenAlarms>;

/// Entries that are kept together or not at all.
struct Transaction {
    std::vector<Entry> entries;
    /// The number of the last message: the entries hold the states of all machines after it, and what was known of
    /// machines before, and all messages, are dropped.
    std::optional<std::uint64_t> all_anew_at = {};
};

} // namespace placedpar::monitor
