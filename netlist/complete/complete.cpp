#include "netlist/complete/complete.hpp"

namespace placedpar {

Network complete(Draft draft, const Catalogue& catalogue, Reporter& reporter) {
    Completion completion{std::move(draft), catalogue, reporter, {}, {}, {}, {}, {}, {}};
    complete_wires(completion);
    complete_processes(completion);
    complete_channels(completion);
    complete_carriers(completion);
    completion.network.nodes = std::move(completion.draft.nodes);
    if (!reporter.failed())
        complete_checks(completion);
    return std::move(completion.network);
}

} // namespace placedpar
