#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace placedpar::monitor {

/// What a control system may say to the monitor, one JSON object a line; docs/monitor.md is the description.

inline constexpr int protocol_version = 1;

template <typename T>
using PerLink = std::array<T, hydraulics::all_links.size()>;

/// What turns readings of one link into flows.
struct LinkParameters {
    double piston_in3_per_rad; // A_i times the moment arm, or the displacement of a motor
    double spool_lag_per_s;    // a_0 of A.2

    friend bool operator==(const LinkParameters&, const LinkParameters&) = default;
};

/// Those of the excavator (hydraulics/data/excavator.csv).
PerLink<LinkParameters> default_link_parameters();

/// What the diagnosis has to know of a machine.
struct MachineParameters {
    double period_s = 0.020; // between samples; thesis
    hydraulics::FlowConstants flow = hydraulics::fitted_flow_constants();
    PerLink<LinkParameters> links = default_link_parameters();

    friend bool operator==(const MachineParameters&, const MachineParameters&);
};

enum class Role : unsigned char { control, watch };
/// Which estimates a connection wants to be sent: after each sample, after those that moved one, or none.
enum class Answers : unsigned char { all, moved, none };

struct Hello {
    std::string machine;
    Role role = Role::control;
    Answers answers = Answers::all;
    double load_every_s = 0; // 0: when asked only
    bool anew = false;       // forget what is known of this machine
    MachineParameters parameters;
};

struct ConfigurationChange {
    hydraulics::Configuration configuration;
    hydraulics::LinkSet active;
};

struct SpoolReading {
    double spool_in;
};
struct ServoReading {
    double servo_V;
};
struct AreaReading {
    double inlet_in2, bypass_in2;
};

/// Of one link at one sampling instant.
struct Reading {
    double inlet_psi;
    double angle_deg;
    std::variant<SpoolReading, ServoReading, AreaReading> valve;
};

struct SampleMessage {
    double time_s;
    PerLink<std::optional<Reading>> links;
};

/// The compliances of a healthy machine.
struct BaselineMessage {
    PerLink<std::optional<double>> compliance_in3_per_psi;
};

struct StatusRequest {};
struct LoadRequest {};
struct Ping {};
struct Bye {};

using Message =
    std::variant<Hello, ConfigurationChange, SampleMessage, BaselineMessage, StatusRequest, LoadRequest, Ping, Bye>;

/// A line that is refused.
class BadMessage : public std::runtime_error {
public:
    BadMessage(std::string field, const std::string& wrong, std::string right, std::optional<std::size_t> column = {})
        : std::runtime_error(wrong), field_(std::move(field)), right_(std::move(right)), column_(column) {}

    /// "links.BO.inlet_psi"; empty when the line is no JSON object.
    const std::string& field() const { return field_; }
    /// What would be right.
    const std::string& right() const { return right_; }
    /// From 1; of lines that are no JSON.
    std::optional<std::size_t> column() const { return column_; }

private:
    std::string field_, right_;
    std::optional<std::size_t> column_;
};

/// Throws BadMessage.
Message parse_message(std::string_view line);

} // namespace placedpar::monitor
