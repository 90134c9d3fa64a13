// Multiplication by a matrix on a mesh (Hoare, Communicating Sequential Processes, CACM 21, 1978, section 6.2). Each
// csp.cell holds an element of the matrix. Elements of vectors come from the west, sums from the north.

#include "classics/kinds.hpp"

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

void output_vector(ProcessEnvironment& environment) {
    auto to = environment.output<double>("out");
    for (std::int64_t row = 0; row < environment.integer("rows"); ++row)
        to.output(environment.real("first") + static_cast<double>(row) * environment.real("step"));
}

void multiply(ProcessEnvironment& environment) {
    auto west = environment.input<double>("west"), north = environment.input<double>("north");
    auto south = environment.output<double>("south");
    bool has_east = environment.connected("east");
    auto east = has_east ? environment.output<double>("east") : Output<double>();
    for (std::int64_t row = 0; row < environment.integer("rows"); ++row) {
        double x = 0, sum = 0;
        par([&] { x = west.input(); }, [&] { sum = north.input(); });
        compute(Cycles{environment.integer("cycles")});
        sum += environment.real("element") * x;
        par(
            [&] {
                if (has_east)
                    east.output(x);
            },
            [&] { south.output(sum); });
    }
}

void collect_column(ProcessEnvironment& environment) {
    auto from = environment.input<double>("in");
    for (std::int64_t row = 0; row < environment.integer("rows"); ++row)
        environment.measure(fmt::format("row[{}]", row), from.input());
}

ParameterDescription rows() {
    return description::integer("rows", {.by_default = 3, .least = 1, .most = 1e6}, "number of vectors to multiply");
}

ParameterDescription element(std::string name, std::string about) {
    return description::real(std::move(name), {.by_default = 0}, std::move(about));
}

PortDescription from(std::string name, std::string about) {
    return description::input<double>(std::move(name), "real", std::move(about));
}

PortDescription to(std::string name, std::string about) {
    return description::output<double>(std::move(name), "real", std::move(about));
}

ProcessKind vector_source() {
    return {.name = "csp.vector",
            .about = "Outputs one element of each vector: first, first + step, and so on.",
            .ports = {to("out", "elements")},
            .parameters = {rows(), element("first", "element"), element("step", "step from one element to the next")},
            .body = output_vector};
}

ProcessKind cell() {
    using namespace description;
    return {.name = "csp.cell",
            .about = "Multiplies the input from the west by its matrix element, adds the input from the north, "
                     "and sends the sum south; passes the input from the west on to the east.",
            .ports = {from("west", "elements of vectors"), from("north", "sums"), to("south", "sums"),
                      optional(to("east", "elements of vectors"))},
            .parameters = {rows(), element("element", "element of the matrix"),
                           integer("cycles", {.unit = "cycles", .by_default = 40, .least = 0, .most = 1e9},
                                   "workload: a multiplication and an addition")},
            .body = multiply};
}

ProcessKind column() {
    return {.name = "csp.column",
            .about = "Inputs a column of the product, and reports its elements as measurements.",
            .ports = {from("in", "sums")},
            .parameters = {rows()},
            .measurements = {{"row[0] and so on", "", "the elements of the column"}},
            .body = collect_column};
}

} // namespace

std::vector<ProcessKind> matrix_kinds() { return {vector_source(), cell(), column()}; }

} // namespace placedpar
