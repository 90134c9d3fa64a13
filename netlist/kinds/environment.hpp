#pragma once

#include "netlist/network/value.hpp"
#include "runtime/channel.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace placedpar {

struct Network; // netlist/network/network.hpp

/// Holds a result that a process reports at the end of the run, such as a rate.
struct Measurement {
    std::string process;
    std::string name;
    std::variant<double, std::string> value;
    std::string unit; ///< "" if the value has no unit
};

/// Gives the code of a running process what the netlist defines for the process: the channels at its ports, its
/// parameters, and its random numbers. The code is the same wherever the process is placed, whether or not its channels
/// lead over links.
///
/// The functions throw std::logic_error if the kind of the process does not have the port or parameter, or has it with
/// another type. Such an error is a defect of the kind. input() and output() throw UserError if the netlist connects
/// the port as an array.
class ProcessEnvironment {
public:
    struct Port {
        std::string name; ///< as the netlist writes it: "to_slaves", "out[2]"
        AnyChannel* channel;
    };

    /// REQUIRES: network and measurements outlive this object; index < network.processes.size().
    ProcessEnvironment(const Network& network, std::size_t index, std::vector<Port> ports, std::uint64_t seed,
                       std::vector<Measurement>& measurements);

    /// Returns the process's name in the netlist, such as "slave[2]".
    const std::string& process() const { return process_; }
    /// These two functions return the whole network, and the index of the process in Network::processes. A process can
    /// thus find the neighbours of its neighbours, for example. Its results must not depend on where processes are
    /// placed.
    const Network& network() const { return network_; }
    std::size_t index() const { return index_; }

    std::int64_t integer(std::string_view parameter) const { return get<std::int64_t>(parameter); }
    double real(std::string_view parameter) const { return get<double>(parameter); }
    const std::string& text(std::string_view parameter) const { return get<std::string>(parameter); }

    /// Returns whether the port, or any element of a port array, is connected.
    bool connected(std::string_view port) const { return !all(port).empty(); }
    template <class T>
    Input<T> input(std::string_view port) const {
        return channel<T>(require(port)).in();
    }
    template <class T>
    Output<T> output(std::string_view port) const {
        return channel<T>(require(port)).out();
    }
    /// Returns all ends of a port in the order of their subscripts; a port that is not an array has a single end.
    template <class T>
    std::vector<Output<T>> outputs(std::string_view port) const {
        return ends<Output<T>>(port, [this](AnyChannel& each) { return channel<T>(each).out(); });
    }
    template <class T>
    std::vector<Input<T>> inputs(std::string_view port) const {
        return ends<Input<T>>(port, [this](AnyChannel& each) { return channel<T>(each).in(); });
    }

    /// Returns a sequence of random numbers, which depends only on the run's seed and on the name. Processes that use
    /// the same name get the same numbers.
    RandomStream random_stream(std::string_view name) const { return RandomStream(seed_, name); }
    std::uint64_t seed() const { return seed_; }

    void measure(std::string name, double value, std::string unit = "") {
        add({process_, std::move(name), value, std::move(unit)});
    }
    void measure(std::string name, std::string value) { add({process_, std::move(name), std::move(value), ""}); }

private:
    template <class T>
    const T& get(std::string_view parameter) const {
        auto found = parameters_.find(std::string(parameter));
        if (found == parameters_.end() || !std::holds_alternative<T>(found->second))
            throw_no_parameter(parameter);
        return std::get<T>(found->second);
    }
    template <class T>
    Channel<T>& channel(AnyChannel& any) const {
        if (auto* typed = dynamic_cast<Channel<T>*>(&any))
            return *typed;
        throw_other_protocol(any);
    }
    template <class End, class EndOf>
    std::vector<End> ends(std::string_view port, EndOf end_of) const {
        std::vector<End> result;
        for (AnyChannel* each : all(port))
            result.push_back(end_of(*each));
        return result;
    }
    [[noreturn]] void throw_no_parameter(std::string_view) const;
    [[noreturn]] void throw_other_protocol(const AnyChannel&) const;
    void add(Measurement);
    AnyChannel* find(std::string_view port) const;
    AnyChannel& require(std::string_view port) const;
    std::vector<AnyChannel*> all(std::string_view port) const;

    const Network& network_;
    std::size_t index_;
    std::string process_;
    const std::map<std::string, Value>& parameters_;
    std::vector<Port> ports_;
    std::uint64_t seed_;
    std::vector<Measurement>& measurements_;
};

} // namespace placedpar
