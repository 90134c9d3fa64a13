#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/process_kind.hpp"
#include "netlist/network/network.hpp"
#include "runtime/user_code.hpp"
#include "text/user_error.hpp"

#include <string>

namespace placedpar {

/// Returns the result of `work`, which calls functions of a kind of process or device. If the kind is part of a user's
/// program that is built on PlacedPar, an exception from these functions is an error of that program, not of PlacedPar:
/// it becomes a UserError with the same text. A UserError is rethrown unchanged.
template <class Kind, class Work>
auto ask_kind(const Kind& kind, const Work& work) {
    try {
        return work();
    } catch (const UserError&) {
        throw;
    } catch (...) {
        const std::string why = what_was_thrown();
        if (!kind.is_own)
            throw;
        throw UserError(why);
    }
}

/// Does the same for the kind of a process. The UserError also names the process and its place in the netlist. It
/// contains `what`, the question to the kind, such as "whether it is determinate".
template <class Work>
auto ask_kind(const ProcessKind& kind, const ProcessInstance& process, const char* what, const Work& work) {
    try {
        return ask_kind(kind, work);
    } catch (const UserError& thrown) {
        throw UserError(process.declared.text() + ": process " + process.name + " (" + process.kind + "), asked " +
                        what + ": " + thrown.what());
    }
}

/// Does the same for the kind of a device. If the kind is part of a user's program, the UserError also names the node
/// and its place in the netlist.
template <class Work>
auto ask_device(const Node& node, const Work& work) {
    try {
        return ask_kind(*node.kind, work);
    } catch (const UserError& thrown) {
        if (!node.kind->is_own)
            throw;
        throw UserError(node.declared.text() + ": " + node.kind->noun + " \"" + node.name + "\": " + thrown.what());
    }
}

} // namespace placedpar
