#pragma once

#include "gaprocs/policies/policy.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/process_kind.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What the descriptions of several kinds of this room have in common.
namespace placedpar::search_description {

using Parameters = std::vector<ParameterDescription>;

/// Every one of `first`, then every one of `second`.
Parameters operator+(Parameters first, const Parameters& second);

/// Which of its policies a step takes.
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

/// What a netlist says of a step that is to take the policy that suits the problem: usual_settings().
inline constexpr std::string_view usual = "usual";

/// The same, by default the one that suits the problem.
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
/// How many bytes something takes in a message.
ParameterDescription bytes_in_message(std::string name, std::int64_t by_default, std::string about);

/// Of every process that holds a population, with the problem.
Parameters search_parameters();
std::vector<MeasurementDescription> search_measurements();
/// What measure_individual() says of an individual.
std::vector<MeasurementDescription> individual_measurements(const std::string& whose);
PortDescription from_host();
PortDescription to_host();

/// Of every master.
Parameters farm_parameters();
/// Of every process that may have slaves behind it.
PortDescription to_slaves();
PortDescription from_slaves();

} // namespace placedpar::search_description
