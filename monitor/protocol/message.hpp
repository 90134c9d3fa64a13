#pragma once

#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace placedpar::monitor {

/// What a control system may say to the monitor, one JSON object a line; docs/guides/monitor.md is the description.
/// What it says of its excavator becomes the plain types of identification/on_line/inputs.hpp. "Machine" is the
/// protocol's word for an excavator under diagnosis.

inline constexpr int protocol_version = 1;

enum class Role : unsigned char { control, watch };
/// Which estimates a connection wants to be sent: after each sample, after those that moved one, or none.
enum class Answers : unsigned char { all, moved, none };

struct Hello {
    std::string machine; ///< its name
    Role role = Role::control;
    Answers answers = Answers::all;
    double load_every_s = 0; ///< 0: when asked only
    bool anew = false;       ///< forget what is known of this machine
    std::string token;       ///< "": none
    identification::ExcavatorParameters parameters;
};

struct StatusRequest {};
/// All alarms that hold, of all machines.
struct AlarmsRequest {};
/// In place of that of a hello, for who says none.
struct TokenOffer {
    std::string token;
};
/// Nothing shall be known of the machine any more.
struct Forget {
    std::string machine;
};
/// An alarm that holds.
struct AlarmName {
    std::string machine, kind, links; ///< links as "BU BO"
};
/// Somebody has seen the alarm.
struct Acknowledge {
    AlarmName alarm;
};
/// For so long nobody is told of the alarm, come, go and come again as it may; 0: from now on everybody is.
struct Shelve {
    AlarmName alarm;
    double for_s;
};
struct LoadRequest {};
struct Ping {};
struct Bye {};

using Message =
    std::variant<Hello, identification::ConfigurationChange, identification::ExcavatorSample, identification::Baseline,
                 StatusRequest, LoadRequest, Ping, Bye, AlarmsRequest, TokenOffer, Forget, Acknowledge, Shelve>;

/// Throws BadMessage.
Message parse_message(std::string_view line);

} // namespace placedpar::monitor
