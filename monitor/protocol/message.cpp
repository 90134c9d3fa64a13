#include "monitor/protocol/message.hpp"

#include "monitor/protocol/field_reader.hpp"
#include "monitor/protocol/link_words.hpp"
#include "monitor/protocol/message_json.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace {

// These ranges are wide enough for any excavator and narrow enough to catch a wrong unit.
constexpr Range pressures{-20, 10000, "psi"}, angles{-36000, 36000, "deg"}, spools{0, 10, "in"}, voltages{0, 10, "V"},
    areas{0, 10, "in^2"}, times{-1e12, 1e12, "s"}, compliances{1e-6, 0.1, "in^3/psi"}, periods{0.0001, 0.1, "s"},
    pistons{0.1, 1e6, "in^3/rad"}, lags{0.1, 1000, "1/s"}, up_to_a_day{0, 86400, "s"};

Link link_of(const std::string& name, const std::string& path) {
    if (auto link = link_named(name))
        return *link;
    throw BadMessage(path, fmt::format("unknown link \"{}\"", name), "one of BU, BO, ST, SW");
}

/// Calls read(link, fields, name) for each link in the object "links"; `name` is the link's field in `fields`.
template <typename Read>
void for_each_link(FieldReader& message, Read read) {
    FieldReader links = message.object("links");
    LinkSet seen;
    for (const std::string& name : links.names()) {
        Link link = link_of(name, links.path_of(name));
        if (seen.contains(link))
            throw BadMessage(fmt::format("links.{}", symbol_of(link)), "it is given twice",
                             "each link once, by its name or symbol");
        seen.insert(link);
        read(link, links, name);
    }
}

template <typename T>
T choice(FieldReader& fields, std::string_view name, T otherwise, const std::vector<std::pair<std::string, T>>& all) {
    if (!fields.has(name))
        return otherwise;
    std::string text = fields.text(name), right = "one of";
    for (const auto& [word, value] : all) {
        if (word == text)
            return value;
        right += fmt::format(" \"{}\"", word);
    }
    throw BadMessage(fields.path_of(name), fmt::format("it is \"{}\"", text), right);
}

std::string machine_name(FieldReader& fields) {
    std::string name = fields.text("machine");
    auto good = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_' || c == '-'; };
    if (name.empty() || name.size() > 64 || !std::ranges::all_of(name, good))
        throw BadMessage("machine", fmt::format("\"{}\" cannot be the name of a machine", name),
                         "1 to 64 letters, digits, '.', '_' and '-'");
    return name;
}

ExcavatorParameters machine_parameters(FieldReader& fields) {
    ExcavatorParameters parameters = excavator_parameters(Parameters::excavator());
    parameters.period_s = fields.number_or("period_s", periods, parameters.period_s);
    if (fields.has("flow")) {
        FieldReader flow = fields.object("flow");
        // The fields k, Q and P_e must be given together or not at all, since the three constants were fitted together.
        parameters.flow = {flow.number("orifice_in3_per_s_in2_sqrt_psi", {1, 1000, ""}),
                           flow.number("pump_in3_per_s", {1, 10000, "in^3/s"}),
                           flow.number("tank_psi", {-20, 500, "psi"}), parameters.flow.relief_psi};
        flow.finish();
    }
    if (fields.has("links"))
        for_each_link(fields, [&](Link link, FieldReader& links, const std::string& name) {
            FieldReader of_link = links.object(name);
            LinkConstants& p = parameters.links[index_of(link)];
            p.piston_in3_per_rad = of_link.number_or("piston_in3_per_rad", pistons, p.piston_in3_per_rad);
            p.spool_lag_per_s = of_link.number_or("spool_lag_per_s", lags, p.spool_lag_per_s);
            double& health = parameters.compliance_in3_per_psi[index_of(link)];
            health = of_link.number_or("compliance_in3_per_psi", compliances, health);
            of_link.finish();
        });
    return parameters;
}

Message hello(FieldReader& fields) {
    double version = fields.number("version", {1, 1e6, ""});
    if (version != protocol_version)
        throw BadMessage("version", fmt::format("it is {}", version), fmt::format("{}", protocol_version));
    Hello hello;
    hello.machine = machine_name(fields);
    hello.role = choice(fields, "role", Role::control, {{"control", Role::control}, {"watch", Role::watch}});
    hello.answers = choice(fields, "answers", Answers::all,
                           {{"all", Answers::all}, {"moved", Answers::moved}, {"none", Answers::none}});
    hello.load_every_s = fields.number_or("load_every_s", up_to_a_day, 0);
    hello.anew = fields.flag_or("anew", false);
    hello.token = fields.text_or("token", "");
    hello.parameters = machine_parameters(fields);
    return hello;
}

Message configuration(FieldReader& fields) {
    ConfigurationChange change;
    std::string name = fields.text("configuration");
    if (name == "auto")
        return RecognisedConfiguration{}; // an array "active" is then an unknown field
    auto named = configuration_named(name);
    if (!named)
        throw BadMessage("configuration", fmt::format("it is \"{}\"", name),
                         "one of \"a\" \"b\" \"c\" \"d\" \"e\" \"auto\"");
    change.configuration = *named;
    for (const boost::json::value& each : fields.array("active")) {
        if (!each.is_string())
            throw BadMessage("active", "it has an element that is not a string", "an array such as [\"BU\",\"BO\"]");
        change.active.insert(link_of(std::string(each.get_string()), "active"));
    }
    return change;
}

Reading reading(FieldReader& fields) {
    Reading reading{fields.number("inlet_psi", pressures), fields.number("angle_deg", angles), SpoolPosition{0}};
    bool spool = fields.has("spool_in"), servo = fields.has("servo_V"), inlet = fields.has("inlet_in2"),
         bypass = fields.has("bypass_in2");
    if (spool + servo + (inlet || bypass) != 1)
        throw BadMessage(fields.path_of("spool_in"),
                         spool + servo + (inlet || bypass) == 0 ? "the position of the valve is missing"
                                                                : "the valve is described twice",
                         "one of spool_in, servo_V, or inlet_in2 with bypass_in2");
    if (spool)
        reading.valve = SpoolPosition{fields.number("spool_in", spools)};
    else if (servo)
        reading.valve = ServoVoltage{fields.number("servo_V", voltages)};
    else
        reading.valve = ValveAreas{fields.number("inlet_in2", areas), fields.number("bypass_in2", areas)};
    return reading;
}

Message sample(FieldReader& fields) {
    ExcavatorSample sample{fields.number("time_s", times), {}};
    for_each_link(fields, [&](Link link, FieldReader& links, const std::string& name) {
        FieldReader of_link = links.object(name);
        sample.links[index_of(link)] = reading(of_link);
        of_link.finish();
    });
    return sample;
}

Message baseline(FieldReader& fields) {
    Baseline baseline;
    for_each_link(fields, [&](Link link, FieldReader& links, const std::string& name) {
        baseline.compliance_in3_per_psi[index_of(link)] = links.number(name, compliances);
    });
    return baseline;
}

Message token(FieldReader& fields) { return TokenOffer{fields.text("token")}; }

Message forget(FieldReader& fields) { return Forget{machine_name(fields)}; }

AlarmName alarm_name(FieldReader& fields) {
    AlarmName alarm{machine_name(fields), fields.text("alarm"), ""};
    LinkSet links;
    for (const boost::json::value& each : fields.array("links"))
        links.insert(link_of(each.is_string() ? std::string(each.get_string()) : "", "links"));
    alarm.links = words_of(links);
    return alarm;
}

Message acknowledge(FieldReader& fields) { return Acknowledge{alarm_name(fields)}; }

Message shelve(FieldReader& fields) { return Shelve{alarm_name(fields), fields.number("for_s", {0, 30 * 86400, "s"})}; }

template <typename Empty>
Message nothing_more(FieldReader&) {
    return Empty{};
}

struct Type {
    const char* name;
    Message (*read)(FieldReader&);
};

constexpr Type types[]{
    {.name = "hello", .read = hello},
    {.name = "configuration", .read = configuration},
    {.name = "sample", .read = sample},
    {.name = "baseline", .read = baseline},
    {.name = "status", .read = nothing_more<StatusRequest>},
    {.name = "load", .read = nothing_more<LoadRequest>},
    {.name = "ping", .read = nothing_more<Ping>},
    {.name = "bye", .read = nothing_more<Bye>},
    {.name = "alarms", .read = nothing_more<AlarmsRequest>},
    {.name = "token", .read = token},
    {.name = "forget", .read = forget},
    {.name = "acknowledge", .read = acknowledge},
    {.name = "shelve", .read = shelve},
};

} // namespace

Message parse_message(std::string_view line) {
    boost::json::value value = read_message_json(line);
    FieldReader fields(value.get_object(), "");
    std::string name = fields.text("type");
    auto type = std::ranges::find(types, name, &Type::name);
    if (type == std::end(types))
        throw BadMessage(
            "type", fmt::format("unknown message \"{}\"", name.substr(0, 40)),
            "one of hello, configuration, sample, baseline, status, load, ping, bye, alarms, token, forget, "
            "acknowledge, shelve");
    Message message = type->read(fields);
    fields.finish();
    return message;
}

} // namespace placedpar::monitor
