#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/pair_checks.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/search_process.hpp"
#include "netlist/kinds/description.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

using namespace search_description;

ParameterDescription bits_of_fields(std::string name, std::string about) {
    return description::deciding(
        "coarse-fine", description::text(std::move(name), {.check = [](const std::string& text) { bits_named(text); }},
                                         std::move(about)));
}

ProcessKind searching_recoded(std::string name, std::string about, PortDescription other_one,
                              const ProblemRegistry& problems, SearchObserver* observer) {
    Parameters recoding{
        bits_of_fields("fields", "number of bits of each field of the problem's string, such as \"2 7 7 7 7 7\"; the "
                                 "problem and the operators must work on binary strings"),
        bits_of_fields("bits", "number of bits of each field that are bred; at most as many as the field has")};
    ProcessKind kind = searching({.name = std::move(name),
                                  .about = std::move(about),
                                  .ports = {from_host(), std::move(other_one)},
                                  .parameters = recoding + search_parameters(),
                                  .measurements = search_measurements()},
                                 problems, observer);
    kind.check = [&problems, check_search = std::move(kind.check)](const Network& network, std::size_t process) {
        auto complaints = check_search(network, process);
        if (std::ranges::all_of(complaints, &Complaint::warning))
            std::ranges::move(check_pair(network, process, problems), std::back_inserter(complaints));
        return complaints;
    };
    return kind;
}

} // namespace

ProcessKind coarse_kind(const ProblemRegistry& problems, SearchObserver* observer) {
    using namespace description;
    return searching_recoded(
        "ga.coarse",
        "The coarse search of a pair (thesis 6.2, Figure 6.6): it breeds the most significant bits of each field; the "
        "other bits are 0. It sends the best individual of each generation to the fine search.",
        optional(output<BiasPoint>("to_fine", "bias point", "the best individual, as a string that the problem reads")),
        problems, observer);
}

ProcessKind fine_kind(const ProblemRegistry& problems, SearchObserver* observer) {
    using namespace description;
    return searching_recoded(
        "ga.fine",
        "The fine search of a pair (thesis 6.2, Figure 6.6): a field with fewer bits than the problem's field is an "
        "offset from the best individual of the coarse search in the same generation, in steps of the problem's field.",
        input<BiasPoint>("from_coarse", "bias point",
                         "the point around which this process searches in each generation"),
        problems, observer);
}

} // namespace placedpar
