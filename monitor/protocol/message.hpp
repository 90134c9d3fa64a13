#pragma once

#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace placedpar::monitor {

/// These types are the messages that a control system may send, one JSON object on each line (docs/guides/monitor.md).
/// The parts about the excavator are converted to the types of identification/on_line/inputs.hpp. "Machine" is the
/// protocol's word for an excavator under diagnosis.

inline constexpr int protocol_version = 1;

enum class Role : unsigned char { control, watch };
/// Selects the samples after which a connection receives estimates: all samples, samples for which the search made
/// generations, or no samples.
enum class Answers : unsigned char { all, moved, none };

struct Hello {
    std::string machine;
    Role role = Role::control;
    Answers answers = Answers::all;
    double load_every_s = 0; ///< period of load reports; 0: only on request
    bool anew = false;       ///< whether the service first forgets all stored data of this machine
    std::string token;       ///< "" if no token is sent
    identification::ExcavatorParameters parameters;
};

struct StatusRequest {};
/// Requests all active alarms of all machines.
struct AlarmsRequest {};
/// Authenticates a connection that sends no hello.
struct TokenOffer {
    std::string token;
};
/// Requests that the service forget all data of the machine.
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
/// Suppresses notifications of the alarm for `for_s` seconds, however often it is raised or cleared; 0 ends the
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
