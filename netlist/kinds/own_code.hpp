#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "netlist/network/network.hpp"
#include "runtime/user_code.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <string>

namespace placedpar {

/// What `work`, which asks the kind's own code, gives. What is thrown by a kind that a program adds is that program's:
/// a UserError that says the same. A UserError is thrown on, whoever's it is.
template <class Work>
auto ask_kind(const ProcessKind& kind, const Work& work) {
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

/// The same of a process of the kind: what is thrown also says its place in the netlist, and `what` it was asked.
template <class Work>
auto ask_kind(const ProcessKind& kind, const ProcessInstance& process, const char* what, const Work& work) {
    try {
        return ask_kind(kind, work);
    } catch (const UserError& thrown) {
        throw UserError(fmt::format("{}: process {} ({}), asked {}: {}", process.declared.text(), process.name,
                                    process.kind, what, thrown.what()));
    }
}

} // namespace placedpar
