#include "python/module/operation.hpp"
#include "python/module/module.hpp"

#include "netlist/kinds/packet.hpp"
#include "python/module/given.hpp"
#include "runtime/kernel.hpp"
#include "runtime/timer.hpp"

#include <utility>

namespace placedpar::python {

namespace {

using Kind = Operation::Kind;

Operation of_end(Kind kind, std::shared_ptr<ChannelEnd> end, pybind11::object message = {}) {
    end->require(kind == Kind::input ? Direction::input : Direction::output);
    return {.kind = kind, .end = std::move(end), .value = std::move(message)};
}

void add_clock(pybind11::module_& module) {
    module.def("now_ps", [] { return Kernel::here().now().count(); });
    module.def("clock", [] { return (Kernel::here(), Timer().read()); });
}

void add_messages(pybind11::module_& module) {
    pybind11::class_<Packet>(module, "Packet")
        .def(pybind11::init([](Given<std::int64_t, "number"> number, Given<std::uint32_t, "bytes"> bytes) {
                 return Packet{number, bytes};
             }),
             pybind11::arg("number") = 0, pybind11::arg("bytes") = 4)
        .def(pybind11::init(refusal<Packet>("Packet(number=0, bytes=4)")))
        .def_property(
            "number", [](const Packet& packet) { return packet.number; },
            [](Packet& packet, Given<std::int64_t, "number"> number) { packet.number = number; })
        .def_property(
            "bytes", [](const Packet& packet) { return packet.bytes; },
            [](Packet& packet, Given<std::uint32_t, "bytes"> bytes) { packet.bytes = bytes; })
        .def("__eq__", [](const Packet& packet, const Packet& other) { return packet == other; })
        .def("__repr__", [](const Packet& packet) {
            return "Packet(" + std::to_string(packet.number) + ", bytes=" + std::to_string(packet.bytes) + ")";
        });
    using End = std::shared_ptr<ChannelEnd>;
    pybind11::class_<ChannelEnd, End>(module, "ChannelEnd")
        .def(
            "input", [](End end) { return of_end(Kind::input, std::move(end)); },
            "Returns the operation that inputs a message. Yield this operation in the body.")
        .def("input", refusal("input()"))
        .def(
            "output",
            [](End end, pybind11::object message) { return of_end(Kind::output, std::move(end), std::move(message)); },
            "Returns the operation that outputs the message. Yield this operation in the body.")
        .def("output", refusal("output(message)"))
        .def_property_readonly("channel", [](const ChannelEnd& end) {
            end.require_attached();
            return end.channel().name();
        });
}

} // namespace

void add_operations(pybind11::module_& module) {
    add_messages(module);
    add_clock(module);
    pybind11::class_<Operation>(module, "Operation");
    module.def("compute", [](Given<std::int64_t, "cycles"> cycles, Given<std::int64_t, "words_outside"> words) {
        return Operation{.kind = Kind::compute, .number = cycles, .words_outside = words};
    });
    module.def("wait", [](std::int64_t ps) { return Operation{.kind = Kind::wait, .number = ps}; });
    module.def("until", [](std::int64_t ps) { return Operation{.kind = Kind::until, .number = ps}; });
    module.def("after",
               [](Given<std::int32_t, "ticks"> ticks) { return Operation{.kind = Kind::after, .number = ticks}; });
    module.def("after", refusal("after(ticks)"));
    module.def("stop", [] { return Operation{.kind = Kind::stop}; });
    module.def("stop", refusal("stop()"));
    module.def("skip", [] { return Operation{.kind = Kind::skip}; });
    module.def("skip", refusal("skip()"));
    module.def("never", [] { return Operation{.kind = Kind::never}; });
    module.def("never", refusal("never()"));
    module.def("alt", [](pybind11::args guards) { return Operation{.kind = Kind::alt, .value = std::move(guards)}; });
    module.def("alt", refusal("alt(*guards)"));
    module.def("par", [](pybind11::args parts) { return Operation{.kind = Kind::par, .value = std::move(parts)}; });
    module.def("par", refusal("par(*components)"));
}

} // namespace placedpar::python
