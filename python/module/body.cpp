#include "python/module/network.hpp"

#include "netlist/network/network.hpp"
#include "python/module/generator_run.hpp"
#include "python/module/given.hpp"
#include "text/user_error.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// The environment of a process in Python, through which measure() reports numbers; null when the process has ended.
using Measured = std::shared_ptr<ProcessEnvironment*>;

ProcessEnvironment& environment_of(const Measured& measured) {
    if (!*measured)
        throw UserError("measure() was called after its process had ended; call it in the body");
    return **measured;
}

/// The state of a running process whose body is in Python.
struct Body {
    Interpreter& python = Interpreter::current();
    std::vector<std::shared_ptr<ChannelEnd>> ends;
    Measured measured;
    SharedObject instance;
    std::optional<GeneratorRun> run{std::in_place};

    explicit Body(ProcessEnvironment& environment) : measured(std::make_shared<ProcessEnvironment*>(&environment)) {}
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        run.reset(); // the generator may use the channel ends and measure() until it is closed
        python.call([&] {
            instance = {};
            for (const auto& end : ends)
                end->detach();
            *measured = nullptr;
        });
    }

    /// Returns the channel ends of a port as an attribute of the instance.
    py::object bind(const ProcessEnvironment& environment, const PortDescription& port, bool is_array) {
        py::list bound;
        for (auto& end : protocol_named(port.protocol).ends(environment, port.name, port.direction)) {
            bound.append(py::cast(end));
            ends.push_back(std::move(end));
        }
        if (is_array)
            return bound;
        if (bound.size() > 1)
            throw UserError("the netlist connects \"" + port.name +
                            "\" as an array: declare the port as pp.Inputs or pp.Outputs");
        return bound.empty() ? py::none() : py::object(bound[0]);
    }
};

/// Makes the instance of the process's class, with the channel ends and parameters as attributes.
py::object instance_of(py::handle process_class, const ProcessKind& kind, ProcessEnvironment& environment, Body& body) {
    const py::object instance = process_class.attr("__new__")(process_class);
    const auto& parameters = environment.network().processes[environment.index()].parameters;
    for (const PortDescription& port : kind.ports)
        instance.attr(port.name.c_str()) =
            body.bind(environment, port, process_class.attr(port.name.c_str()).attr("is_array").cast<bool>());
    for (const ParameterDescription& parameter : kind.parameters)
        instance.attr(parameter.name.c_str()) = py::cast(parameters.at(parameter.name));
    instance.attr("name") = environment.process();
    instance.attr("seed") = environment.seed();
    instance.attr("_measure") = py::cpp_function([measured = body.measured](Given<std::string, "name"> name,
                                                                            std::variant<double, std::string> value,
                                                                            Given<std::string, "unit"> unit) {
        if (const auto* text = std::get_if<std::string>(&value))
            environment_of(measured).measure(name, *text);
        else
            environment_of(measured).measure(name, std::get<double>(value), unit);
    });
    instance.attr("__init__")();
    return instance;
}

void run_body(const SharedObject& process_class, const ProcessKind& kind, ProcessEnvironment& environment) {
    Body body(environment);
    bool is_generator = false;
    body.python.call([&] {
        const py::object instance = instance_of(process_class.get(), kind, environment, body);
        body.instance = SharedObject(instance);
        const py::object result = instance.attr("body")();
        is_generator = PyGen_CheckExact(result.ptr());
        if (is_generator)
            body.run->start(result, result);
        else if (!result.is_none())
            throw py::type_error(
                "body() must be a generator that yields operations; a body without operations must return None");
    });
    if (is_generator)
        body.run->finish();
}

PortDescription port_of(py::handle described) {
    const auto protocol = described.attr("protocol").cast<std::string>();
    PortDescription port =
        protocol_named(protocol).port(described.attr("name").cast<std::string>(),
                                      described.attr("is_output").cast<bool>() ? Direction::output : Direction::input,
                                      described.attr("about").cast<std::string>());
    port.optional = described.attr("optional").cast<bool>();
    return port;
}

ParameterDescription parameter_of(py::handle described) {
    const auto text = [&](const char* name) { return described.attr(name).cast<std::string>(); };
    const std::string type = text("type");
    ParameterDescription parameter;
    parameter.name = text("name");
    parameter.about = text("about");
    parameter.unit = text("unit");
    parameter.least = described.attr("least").cast<std::optional<double>>();
    parameter.most = described.attr("most").cast<std::optional<double>>();
    parameter.default_value = described.attr("default").cast<std::optional<Value>>();
    parameter.type = type == "integer" ? ParameterType::integer
                     : type == "real"  ? ParameterType::real
                                       : ParameterType::text;
    return parameter;
}

} // namespace

ProcessKind kind_of(py::handle process_class) {
    ProcessKind kind;
    kind.name = process_class.attr("kind").cast<std::string>();
    kind.about = process_class.attr("_about")().cast<std::string>();
    for (const py::handle port : process_class.attr("_ports")())
        kind.ports.push_back(port_of(port));
    for (const py::handle parameter : process_class.attr("_parameters")())
        kind.parameters.push_back(parameter_of(parameter));
    kind.is_own = true;
    kind.body = [held = SharedObject(py::reinterpret_borrow<py::object>(process_class)),
                 described = kind](ProcessEnvironment& environment) { run_body(held, described, environment); };
    return kind;
}

} // namespace placedpar::python
