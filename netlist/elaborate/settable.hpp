#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/names.hpp"
#include "text/reporter.hpp"

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

/// An attribute or a parameter that an option can set.
struct SettableMember {
    std::string name;
    const ParameterDescription* description = nullptr; ///< null where only an interface declares it
    bool takes_text = false;

    /// "it takes an integer: it is at least 1"; "" where that is not known.
    std::string what_it_takes() const;
};

/// A node, a connection or a process whose attributes and parameters an option can set.
struct Settable {
    std::string name;
    std::variant<Node*, DraftConnection*, DraftProcess*> thing;
    std::shared_ptr<const std::vector<SettableMember>> members; ///< what a simulation looks at
    const ProcessKind* kind = nullptr;                          ///< of a process; null for a stand-in

    const char* noun() const;
    const char* noun_of_member() const;
    /// Null for what is only kept for the real tool.
    const SettableMember* member(const std::string& name) const { return find_named(*members, name); }
    /// Whether it can be set; what is only kept for the real tool, too. Where every element is meant, a connection
    /// without a speed of its own is not: it follows its ends.
    bool has(const std::string& member, bool as_every_element = false) const;
    /// REQUIRES: has(setting.name). Throws StatementRefused after having reported; values of parameters are
    /// checked later, with those of the netlist.
    void set(const Setting& setting, Reporter&) const;
    /// "it has memory, clock ..."; cut short when they are many, with the command that lists them all.
    std::string text_of_members() const;
};

/// All of a draft, in its order. They refer to it.
std::vector<Settable> settable_elements(Draft&, const Catalogue&);

/// Vals, attributes and parameters by element: notes, cut short where there is much.
std::vector<SecondPlace> what_can_be_set(const std::vector<std::pair<std::string, Constant>>& vals,
                                         const std::vector<Settable>&);

} // namespace placedpar
