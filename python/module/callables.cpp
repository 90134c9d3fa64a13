#include "python/module/callables.hpp"

#include "python/module/given.hpp"
#include "python/module/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// A function in Python that is used as a policy, a step of a genetic search.
struct Callable {
    static constexpr std::string_view name = "python", about = "a function in Python";
    SharedObject function;
    PolicyFailure failure;
    std::string step; ///< "reproduction", for messages

    template <class Result, class... Arguments>
    Result call(Arguments&&... arguments) const {
        try {
            return function.get()(std::forward<Arguments>(arguments)...).template cast<Result>();
        } catch (py::error_already_set& error) {
            if (!failure->get()) {
                if (error.trace())
                    PyException_SetTraceback(error.value().ptr(), error.trace().ptr());
                *failure = SharedObject(error.value());
            }
            throw std::runtime_error(step + ": " + text_of(error.value()));
        } catch (const py::cast_error&) {
            throw std::runtime_error(step + ": the function returned a value of the wrong type");
        }
    }
};

py::array_t<double> array_of(std::span<const double> values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Returns the values that a string represents: real numbers, or, as whole numbers, bits or the order of a permutation.
py::array values_of(const Genome& genome, const Representation& representation) {
    if (representation.kind() == StringKind::real)
        return array_of(representation.reals().decode(genome));
    std::vector<std::int64_t> values;
    if (representation.kind() == StringKind::permutation)
        for (std::size_t each : representation.permutation().decode(genome))
            values.push_back(static_cast<std::int64_t>(each));
    else
        for (std::size_t i = 0; i < genome.size(); ++i)
            values.push_back(genome.bit(i) ? 1 : 0);
    return py::array_t<std::int64_t>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Returns the order that a function has returned. Throws std::runtime_error unless it has each place once.
std::vector<std::size_t> order_of(const std::vector<double>& values) {
    std::vector<std::size_t> order;
    std::vector<bool> seen(values.size());
    for (const double value : values) {
        const bool is_place = value >= 0 && value < static_cast<double>(values.size()) && value == std::floor(value);
        if (!is_place || seen[static_cast<std::size_t>(value)])
            throw std::runtime_error(fmt::format(
                "the function returned a permutation with {}, but must return each of the places 0 to {} once", value,
                values.size() - 1));
        seen[static_cast<std::size_t>(value)] = true;
        order.push_back(static_cast<std::size_t>(value));
    }
    return order;
}

Genome string_of(const std::vector<double>& values, const Representation& representation) {
    Genome genome(representation.bits());
    if (values.size() != representation.bits() / representation.unit())
        throw std::runtime_error("the function must return strings of the same length as the strings that it received");
    if (representation.kind() == StringKind::permutation)
        return representation.permutation().encode(order_of(values));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool is_real = representation.kind() == StringKind::real;
        if (is_real ? std::isnan(values[i]) : values[i] != 0 && values[i] != 1)
            throw std::runtime_error(fmt::format("the function returned {}, but must return {}", values[i],
                                                 is_real ? "numbers" : "bits 0 and 1"));
        if (is_real)
            representation.reals().set(genome, i, values[i]);
        else
            genome.set(i, values[i] != 0);
    }
    return genome;
}

struct CallableReproduction : Callable {
    static constexpr bool needs_positive_fitness = false;
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
        return call<std::vector<std::size_t>>(array_of(fitness), count, Loan(random).object());
    }
};

struct CallableCrossover : Callable {
    static constexpr bool fits(StringKind) { return true; }
    void operator()(Genome& a, Genome& b, const Representation& strings, RandomStream& random) const {
        const auto offspring = call<std::pair<std::vector<double>, std::vector<double>>>(
            values_of(a, strings), values_of(b, strings), Loan(random).object());
        a = string_of(offspring.first, strings);
        b = string_of(offspring.second, strings);
    }
};

struct CallableMutation : Callable {
    static constexpr bool fits(StringKind) { return true; }
    void operator()(Genome& genome, std::size_t place, const Representation& strings, RandomStream& random) const {
        genome =
            string_of(call<std::vector<double>>(values_of(genome, strings), place, Loan(random).object()), strings);
    }
};

struct CallableTopology : Callable {
    Neighbours operator()(std::size_t islands) const { return call<Neighbours>(islands); }
};

struct CallableSchedule : Callable {
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &CallableSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const {
        const std::vector<std::size_t> all(neighbours.begin(), neighbours.end());
        const auto chosen = call<std::vector<std::size_t>>(exchange, all);
        const auto found = std::search(neighbours.begin(), neighbours.end(), chosen.begin(), chosen.end());
        if (found == neighbours.end() && !chosen.empty())
            throw std::runtime_error(
                "the function must return neighbours that are next to each other in the list that it received");
        return {found, chosen.size()};
    }
};

struct CallableEmigration : Callable {
    std::size_t count = 1;
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream& random) const {
        return call<std::vector<std::size_t>>(array_of(fitness), Loan(random).object());
    }
};

struct CallableAcceptance : Callable {
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants,
                      RandomStream& random) const {
        std::vector<double> fitness;
        for (const Individual& each : immigrants)
            fitness.push_back(each.fitness);
        return call<Places>(array_of(island.fitness), array_of(fitness), Loan(random).object());
    }
};

/// Returns a hint for a user who gave a number as the mutation or the crossover: another setting states the
/// probability.
std::string hint_for(const std::string& step) {
    return step == "mutation" || step == "crossover" ? "; " + step + "_probability sets how often it happens" : "";
}

/// Returns the policy with this name, or a policy that calls this function in Python. If the policy has a numerical
/// setting, an attribute of the function may set it.
template <class Step, class Own, class Policy>
Step step_of(const std::string& step, const py::object& given_policy, const PolicyFailure& failure) {
    if (py::isinstance<py::str>(given_policy))
        return Step::named(given_policy.cast<std::string>());
    if (!PyCallable_Check(given_policy.ptr()))
        throw py::type_error(py::str("{} is {!r}, expected the name of a policy or a function{}")
                                 .format(step, given_policy, hint_for(step))
                                 .template cast<std::string>());
    Policy policy;
    policy.function = SharedObject(given_policy);
    policy.failure = failure;
    policy.step = step;
    if constexpr (requires { policy.every; })
        policy.every = given<std::size_t>(py::getattr(given_policy, "every", py::int_(policy.every)), "every");
    if constexpr (requires { policy.count; })
        policy.count = given<std::size_t>(py::getattr(given_policy, "count", py::int_(policy.count)), "count");
    return Step(Own(policy));
}

} // namespace

void change(IslandsSettings& settings, const std::string& name, const py::object& value, const PolicyFailure& failure) {
    const auto in_all = [&](auto SearchSettings::*member, const auto& changed) {
        for (SearchSettings& island : settings.islands)
            island.*member = changed;
    };
    if (name == "population")
        in_all(&SearchSettings::population, given<std::size_t>(value, "population"));
    else if (name == "elite")
        in_all(&SearchSettings::elite, given<std::size_t>(value, "elite"));
    else if (name == "crossover_probability")
        in_all(&SearchSettings::crossover_probability, given<double>(value, "crossover_probability"));
    else if (name == "mutation_probability")
        in_all(&SearchSettings::mutation_probability, given<double>(value, "mutation_probability"));
    else if (name == "reproduction")
        in_all(&SearchSettings::reproduction,
               step_of<Reproduction, OwnReproduction, CallableReproduction>(name, value, failure));
    else if (name == "crossover")
        in_all(&SearchSettings::crossover, step_of<Crossover, OwnCrossover, CallableCrossover>(name, value, failure));
    else if (name == "mutation")
        in_all(&SearchSettings::mutation, step_of<Mutation, OwnMutation, CallableMutation>(name, value, failure));
    else if (name == "topology")
        settings.topology = step_of<Topology, OwnTopology, CallableTopology>(name, value, failure);
    else if (name == "schedule")
        settings.schedule = step_of<Schedule, OwnSchedule, CallableSchedule>(name, value, failure);
    else if (name == "emigration")
        settings.emigration = step_of<Emigration, OwnEmigration, CallableEmigration>(name, value, failure);
    else
        settings.acceptance = step_of<Acceptance, OwnAcceptance, CallableAcceptance>(name, value, failure);
}

} // namespace placedpar::python
