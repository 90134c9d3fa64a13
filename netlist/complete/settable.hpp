#pragma once

#include "netlist/complete/complete.hpp"

#include <string>
#include <variant>
#include <vector>

namespace placedpar {

/// A node, a connection or a process whose attributes and parameters an option can set.
struct Settable {
    std::string name;
    std::variant<Node*, DraftConnection*, DraftProcess*> thing;
    const ProcessKind* kind = nullptr; ///< of a process; null for a stand-in
    enum class Connects { wire, master, other };
    Connects connects = Connects::other; ///< of a connection: a wire, or a master and its bus

    const char* noun() const;
    const char* noun_of_member() const;
    /// What a simulation looks at.
    std::vector<std::string> members() const;
    /// "it has memory, clock ..."; cut short when they are many, with the command that lists them all.
    std::string text_of_members() const;
    /// Whether it can be set; what is only kept for the real tool, too. Where every element is meant, a connection
    /// without a speed of its own is not: it follows its ends.
    bool has(const std::string& member, bool as_every_element = false) const;
    bool takes_text(const std::string& member) const;
    /// "it takes an integer: it is at least 1"; "" where that is not known.
    std::string what_it_takes(const std::string& member) const;
    /// REQUIRES: has(setting.name). Throws StatementRefused after having reported; values of parameters are
    /// checked later, with those of the netlist.
    void set(const Setting& setting, Reporter&) const;
};

/// All of a draft, in its order. They refer to it.
std::vector<Settable> settable_elements(Completion&);

/// Of vals, attributes, parameters and elements.
std::vector<std::string> names_to_set(Completion&);
/// Lines, cut short where there is much.
std::vector<std::string> what_can_be_set(Completion&);

} // namespace placedpar
