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

/// These types are the entries of the state file, from which the service restores its diagnoses after a restart. A
/// machine is an excavator under diagnosis. Times called `at` are from this computer's clock, in seconds since 1970.
/// Times called `time_s` are from the control system's clock.

/// A message that a diagnosis accepted. Messages of all machines are numbered together, without gaps.
struct KeptMessage {
    std::uint64_t number;
    std::string machine;
    std::string text;

    friend bool operator==(const KeptMessage&, const KeptMessage&) = default;
};

/// The state of a diagnosis after its messages up to number `taken`.
struct KeptState {
    std::string machine;
    std::uint64_t taken;
    std::string state; ///< state_json()

    friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// A copy of a diagnosis's state. The thread that writes the file converts it to a KeptState.
struct UnwrittenState {
    std::string machine;
    std::uint64_t taken;
    std::shared_ptr<const identification::DiagnosisState> state;
};

/// Deletes the state and the history of a machine. Earlier messages of the machine may remain in the file. The same
/// transaction must therefore store a message with the text `forget_text`. A restart ignores the machine's messages
/// before this message.
struct ForgottenMachine {
    std::string machine;
};
inline constexpr const char* forget_text = "forget";

/// Deletes all messages up to this number, because the stored states include their effect.
struct TrimmedMessages {
    std::uint64_t up_to;
};

/// An estimate of a compliance that has settled.
struct KeptEstimate {
    std::string machine;
    double at, time_s;
    std::string set, link;
    double compliance_in3_per_psi;
    std::optional<double> error_in3_per_psi;

    friend bool operator==(const KeptEstimate&, const KeptEstimate&) = default;
};
BOOST_DESCRIBE_STRUCT(KeptEstimate, (), (machine, at, time_s, set, link, compliance_in3_per_psi, error_in3_per_psi))

/// An alarm and its times. Alarms of one machine with equal kind and links count as one alarm. While it is active, it
/// is not raised again.
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

/// Replaces the times of the newest alarm of this machine, kind and links.
struct ChangedAlarm {
    KeptAlarm alarm;
};

/// Lists all active alarms. It corrects the history after some changes were lost: any other alarm that is open in the
/// history has been cleared by the time `at`.
struct OpenAlarms {
    std::vector<KeptAlarm> alarms;
    double at;
};

using Entry = std::variant<KeptMessage, KeptState, UnwrittenState, ForgottenMachine, TrimmedMessages, KeptEstimate,
                           KeptAlarm, ChangedAlarm, OpenAlarms>;

/// Entries that are stored together or not at all.
struct Transaction {
    std::vector<Entry> entries;
    /// If not nullopt, the transaction deletes all earlier states and messages. Its entries have the states of all
    /// machines after the message with this number.
    std::optional<std::uint64_t> all_anew_at = {};
};

} // namespace placedpar::monitor
