#include "small_catalogue.hpp"

namespace placedpar {

namespace {

struct Genome {};
struct Error {};

PortDescription port(const std::string& name, Direction direction, const std::string& protocol, std::type_index type,
                     bool optional = false) {
    return {name, direction, optional, protocol, type, {}, ""};
}

Catalogue make_catalogue() {
    Catalogue catalogue;
    catalogue.add({"ga.master",
                   "deals genomes out",
                   {port("in", Direction::input, "number", typeid(int), true),
                    port("out", Direction::output, "genomes", typeid(Genome)),
                    port("back", Direction::input, "errors", typeid(Error))},
                   {{"population", ParameterType::integer, "individuals", std::nullopt, 2, 10000, {}, ""},
                    {"mutation", ParameterType::real, "", Value(0.01), 0, 1, {}, ""},
                    {"code", ParameterType::text, "", Value(std::string("binary")), {}, {}, {"binary", "gray"}, ""}},
                   {},
                   {}});
    catalogue.add({"ga.slave",
                   "evaluates genomes",
                   {port("in", Direction::input, "genomes", typeid(Genome)),
                    port("out", Direction::output, "errors", typeid(Error))},
                   {{"cycles", ParameterType::integer, "cycles", Value(std::int64_t{1000}), 0, std::nullopt, {}, ""}},
                   {},
                   {}});
    catalogue.add({"pump", "sends numbers", {port("out", Direction::output, "number", typeid(int))}, {}, {}, {}});
    catalogue.add({"sink", "takes numbers", {port("in", Direction::input, "number", typeid(int))}, {}, {}, {}});
    return catalogue;
}

} // namespace

const Catalogue& small_catalogue() {
    static const Catalogue catalogue = make_catalogue();
    return catalogue;
}

std::string netlist_folder() { return std::string(PLACEDPAR_SOURCE_DIR) + "/tests/netlist"; }

} // namespace placedpar
