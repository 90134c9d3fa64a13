#pragma once

#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace placedpar::monitor {

/// These types are the messages that a client may send to the monitor, one JSON object on each line
/// (docs/guides/monitor.md). Further messages, about the excavator, are in identification/on_line/inputs.hpp. "Machine"
/// is the protocol's word for an excavator under diagnosis.

inline constexpr int protocol_version = 1;

/// A client is the control system of its machine and sends samples, or watches the diagnosis.
enum class Role : unsigned char { control, watch };
/// Selects when a client receives estimates: after each sample, only after samples for which the search made
/// generations (`moved`), or never.
enum class Answers : unsigned char { all, moved, none };

/// The first message of a client, which names its machine.
struct Hello {
    std::string machine;
    Role role = Role::control;
    Answers answers = Answers::all;
    double load_every_s = 0; ///< period of reports about the service's load; 0: only on request
    bool anew = false;       ///< whether the service first forgets all stored data of this machine
    std::string token;       ///< "" if no token is sent
    identification::ExcavatorParameters parameters;
};

struct StatusRequest {};
/// Requests all active alarms of all machines.
struct AlarmsRequest {};
/// Authenticates a client that sends no hello.
struct TokenOffer {
    std::string token;
};
/// Requests that the service delete all data of the machine.
struct Forget {
    std::string machine;
};
/// Names an active alarm.
struct AlarmName {
    std::string machine, kind, links; ///< links as "BU BO"
};
/// States that an operator has seen the alarm.
struct Acknowledge {
    AlarmName alarm;
};
/// Suppresses notifications of the alarm for `for_s` seconds, even if the alarm is cleared and raised again. 0 ends the
/// suppression.
struct Shelve {
    AlarmName alarm;
    double for_s;
};
struct LoadRequest {};
struct Ping {};
struct Bye {};

using Message = std::variant<Hello, identification::ConfigurationChange, identification::RecognisedConfiguration,
                             identification::ExcavatorSample, identification::Baseline, StatusRequest, LoadRequest,
                             Ping, Bye, AlarmsRequest, TokenOffer, Forget, Acknowledge, Shelve>;

/// Parses a line. Throws BadMessage if the line is not a message of the protocol.
Message parse_message(std::string_view line);

} // namespace placedpar::monitor
