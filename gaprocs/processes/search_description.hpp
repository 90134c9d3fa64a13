#pragma once

#include "gaprocs/policies/policy.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/process_kind.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// These functions describe the ports, parameters and measurements that several kinds of processes of genetic
/// algorithms have in common. `placedpar kinds` prints the descriptions, and netlists are checked against them.
namespace placedpar::search_description {

using Parameters = std::vector<ParameterDescription>;

/// Returns the parameters of `first`, followed by the parameters of `second`.
Parameters operator+(Parameters first, const Parameters& second);

/// Describes a parameter that chooses the policy of a step of the algorithm, such as tournament selection.
template <class Step>
ParameterDescription policy(std::string name, std::string by_default, std::string about) {
    std::vector<std::string> examples;
    for (const PolicyDescription& each : Step::descriptions())
        examples.push_back(each.text());
    return description::deciding(std::string(Step::noun),
                                 description::text(std::move(name),
                                                   {.by_default = std::move(by_default),
                                                    .choices = std::move(examples),
                                                    .check = [](const std::string& text) { Step::named(text); }},
                                                   std::move(about)));
}

/// The value of a parameter that selects the default policy for the problem, from usual_settings().
inline constexpr std::string_view usual = "usual";

/// Describes a parameter as policy() does, with the default "usual".
template <class Step>
ParameterDescription usual_policy(std::string name, std::string about) {
    ParameterDescription description = policy<Step>(std::move(name), std::string(usual), std::move(about));
    description.choices.insert(description.choices.begin(), std::string(usual));
    description.check = [](const std::string& text) {
        if (text != usual)
            Step::named(text);
    };
    return description;
}

ParameterDescription problem();
ParameterDescription cycles_per_error();
ParameterDescription fitness_bytes();
/// Describes a parameter for the number of bytes that something takes in a message.
ParameterDescription bytes_in_message(std::string name, std::int64_t by_default, std::string about);

/// Returns the parameters that every process with a population has, including `problem`.
Parameters search_parameters();
std::vector<MeasurementDescription> search_measurements();
/// Describes the measurements that measure_individual() reports. `whose`: a phrase for the individual, such as "that
/// estimate".
std::vector<MeasurementDescription> individual_measurements(const std::string& whose);
PortDescription from_host();
PortDescription to_host();

/// Returns the parameters of every master.
Parameters farm_parameters();
/// Describe the ports of every process that may have slaves.
PortDescription to_slaves();
PortDescription from_slaves();

} // namespace placedpar::search_description
