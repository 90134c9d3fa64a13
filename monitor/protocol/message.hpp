#pragma once

#include "identification/on_line/excavator_parameters.hpp"
#include "identification/on_line/inputs.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace placedpar::monitor {

/// What a control system may say to the monitor, one JSON object a line; docs/monitor.md is the description. What it
/// says of its excavator becomes the plain types of identification/on_line/inputs.hpp. "Machine" is the protocol's word
/// for an excavator under diagnosis.

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
    identification::ExcavatorParameters parameters;
};

struct StatusRequest {};
struct LoadRequest {};
struct Ping {};
struct Bye {};

using Message = std::variant<Hello, identification::ConfigurationChange, identification::ExcavatorSample,
                             identification::Baseline, StatusRequest, LoadRequest, Ping, Bye>;

/// Throws BadMessage.
Message parse_message(std::string_view line);

} // namespace placedpar::monitor
