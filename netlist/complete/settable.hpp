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

    const char* noun() const;
    const char* word_for_member() const;
    /// What a simulation looks at.
    std::vector<std::string> members() const;
    /// "it has memory, clock ..."; cut short when they are many.
    std::string text_of_members() const;
    /// Whether a name that stands for all of its kind means this one, too: a connection that has no speed of its own
    /// follows its ends.
    bool has(const std::string& member) const;
    /// Whether it can be given: what is read and kept for the real tool, too.
    bool may_have(const std::string& member) const;
    bool takes_text(const std::string& member) const;
    /// REQUIRES: may_have(setting.name). Throws StatementRefused after having reported; values of parameters are
    /// checked later, with those of the netlist.
    void set(const Setting& setting, Reporter&) const;
};

/// All of a draft, in its order. They refer to it.
std::vector<Settable> settable_elements(Completion&);

/// For a hint.
std::vector<std::string> element_names(Completion&);
/// Of vals, attributes, parameters and elements.
std::vector<std::string> names_to_set(Completion&);
/// Lines, cut short where there is much.
std::vector<std::string> what_can_be_set(Completion&);

} // namespace placedpar
