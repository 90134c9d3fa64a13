#pragma once

#include "netlist/elaborate/attributes.hpp"
#include "netlist/elaborate/draft.hpp"
#include "netlist/elaborate/evaluator.hpp"
#include "netlist/elaborate/overrides.hpp"
#include "netlist/elaborate/scope.hpp"
#include "netlist/elaborate/settable.hpp"
#include "netlist/language/syntax.hpp"
#include "netlist/network/names.hpp"

#include <filesystem>
#include <functional>
#include <set>

namespace placedpar {

inline constexpr std::size_t most_dimensions = 8;
inline constexpr std::size_t most_interface_entries = 1000;

/// Executes the statements of a netlist, including `rep` and `if`, and collects all declarations, connections and
/// placements in a draft. After an error in a statement, reports the error and continues with the next statement.
class Elaborator {
public:
    /// `overrides` are the options `--set NAME=VALUE` as SetStatements. The value of a constant (`val`) is replaced
    /// where the `val` is declared. To apply the other overrides, call run() with them after use(). REQUIRES: catalogue
    /// and overrides outlive this object.
    Elaborator(const Catalogue& catalogue, const Statements& overrides, Reporter& reporter);

    void run(const Statements& statements);
    /// Declares a constant (`val`) that an occam source defines, so that options can set it. The netlist may declare
    /// the name again. Returns the value of the constant: the value that an option sets, or `original`.
    Value choose_val(const std::string& name, const Value& original, const Location& at);
    /// Replaces the programs that the netlist names by kinds of processes, as the options `--use PROGRAM=KIND` say.
    void use(const ProgramKinds& kinds);
    /// Reads the source files in occam that the netlist names as programs. Replaces the names of these files by the
    /// names of the kinds that FileKinds makes from them.
    void read_files(const std::vector<std::filesystem::path>& folders);
    const Draft& draft() const { return draft_; }
    Draft take();

private:
    using Category = DeclaredThings::Category;
    /// Describes elements of one array, which are consecutive in a vector of the draft.
    struct Elements {
        std::size_t first = 0, count = 0;
    };

    // elaborator.cpp
    void execute(const Statement& statement);
    void execute_all(const Statements& statements);
    void perform(const ValStatement& form, const Location& at);
    void perform(const RepStatement& form, const Location& at);
    /// Return the last value of a replicator plus one.
    std::int64_t behind_last(const Expression& last);
    std::int64_t behind_count(std::int64_t first, const Expression& count);
    void perform(const IfStatement& form, const Location& at);
    void perform(const BlockStatement& form, const Location& at);

    // set.cpp
    void perform(const SetStatement& form, const Location& at);
    Constant overridden(const std::string& name, const Constant& original);
    Constant override_val(const SetStatement& set, const Constant& original);
    Constant value_of(const SetStatement& set, bool text_wanted, const std::string& what_it_takes);
    std::vector<Settable> elements_named(const std::string& name, const std::string& member);
    void name_wires();
    void name_attachments();
    template <class Things, class IsMeant>
    void name_connections(Things& things, const std::string& wanted, IsMeant is_meant);
    bool set_once(const SetStatement& set, const std::string& member, const Settable& element);

    // refuse_set.cpp; `name` is the target's name, with its subscripts
    std::vector<std::string> names_of_vals() const;
    [[noreturn]] void refuse_set(const SetStatement& set, const std::string& name, const std::vector<Settable>& named);
    [[noreturn]] void refuse_name(const SetStatement& set, const std::string& name, const std::vector<Settable>& all);
    [[noreturn]] void refuse_element(const SetStatement& set, const std::string& name,
                                     const std::vector<Settable>& all);
    std::string hint_at_other(const std::string& member, const Settable& element,
                              const std::vector<Settable>& all) const;

    // programs.cpp
    void check_option(const std::string& program, const std::string& kind, const std::set<std::string>& programs);

    // declaration.cpp
    void perform(const DefineStatement& form, const Location& at);
    void perform(const Declaration& form, const Location& at);
    void declare_nodes(const NodeType& type, const Declaration& form);
    void perform(const ConnectionDeclaration& form, const Location& at);
    void perform(const EdgeChannelDeclaration& form, const Location& at);
    std::vector<std::int64_t> dimensions(const Declarator& declarator);
    void check_free(const std::string& name, const Location& at);
    std::string claim_name(const std::string& name);
    void count_things(std::size_t count, const Location& at);
    /// Returns the type of this name, with these attributes added.
    Type derived_type(const std::string& name, const Location& at, const DeclarationAttributes& attributes);
    /// Returns the type of this name. If the name is `node`, the attribute `element` says whether the type is for
    /// processors or processes. This attribute is then removed from the settings.
    Type base_type(const std::string& name, const Location& at, std::vector<Setting>& settings);
    Type type_of_element(const Location& at, std::vector<Setting>& settings);
    /// Declares the elements of one declarator, such as `t[4]`. `add` adds an element with a name to the draft.
    void declare(const Declarator& declarator, Category category, std::size_t first,
                 const std::function<void(std::string)>& add, std::size_t weight = 1);

    // process.cpp
    void perform(const ParameterSetting& form, const Location& at);
    void perform(const UseStatement& form, const Location& at);
    void use_for_all(const std::string& program, const Location& at);
    void extend(ProcessType& type, const std::vector<Setting>& settings, const DeclarationAttributes& attributes);
    /// Executes a statement such as `name (stacksize = 4k);`, where `name` is a type of processes.
    void set_type(const ProcessType& type, const ParameterSetting& form);
    [[noreturn]] void refuse_after_declaration(const Setting& setting, const Node& node);
    void set_nodes(const Elements& range, const std::vector<Setting>& settings);
    void set_connections(const Elements& range, const std::vector<Setting>& settings);
    void set_processes(const Elements& range, const std::vector<Setting>& settings, const Location& at);
    void apply_process_attributes(DraftProcess& pattern, const std::vector<Setting>& settings);
    void declare_processes(const ProcessType& type, const std::vector<Declarator>& names);
    void declare_process(const Declarator& name, const DraftProcess& pattern);
    std::shared_ptr<const Interface> interface(const std::vector<InterfaceEntry>& entries);

    // connect.cpp
    void perform(const ConnectStatement& form, const Location& at);
    void connect_links(LinkEnd a, LinkEnd b, const ConnectStatement& form, const Location& at);
    void connect_channels(DraftChannelEnd a, DraftChannelEnd b, const ConnectStatement& form, const Location& at);
    void use_link(const LinkEnd& end, const Reference& reference, bool crosspoint);
    [[noreturn]] void refuse_link(const LinkEnd& end, const Location& at, const Location& first, bool crosspoint);
    void check_crosspoints();
    std::size_t connection_for(const ConnectStatement& form, const Location& at);

    // place.cpp
    void perform(const PlaceStatement& form, const Location& at);
    void place_process(const PlaceStatement& form);
    void place_port(const PlaceStatement& form);
    void place_edge_channel(const PlaceStatement& form);
    void place_connection(const PlaceStatement& form);

    // fault.cpp
    void perform(const FaultStatement& form, const Location& at);
    DraftFault failing(const FaultStatement& form);

    // reference.cpp: finds what a reference such as `t[1].link[2]` names
    struct Found {
        Category category;
        std::vector<std::int64_t> dimensions;
        std::size_t first;
    };
    Found find(const Reference& reference);
    Elements elements(const Reference& reference, const Found& found);
    /// Returns the index of the element in its vector of the draft. Refuses a reference that lacks subscripts.
    std::size_t element(const Reference& reference, const Found& found);
    void boot(const Reference& reference, const Found& found, const std::string& file, const Location& at);
    std::size_t host(const Location& used);
    LinkEnd link_end(const Reference& reference, const Found& found);
    LinkEnd place_of_channel(const PlaceStatement& form, const Found& found);
    int link_number(const Reference& reference, const Node& node, int links);
    [[noreturn]] void refuse_unknown_port(const DraftProcess& process, const Reference& reference);
    DraftChannelEnd port_end(const Reference& reference, const Found& found);
    const PortDeclaration& declared_port(const DraftProcess& process, const Reference& reference);
    void check_subscripts(const PortDeclaration& port, const Reference& reference,
                          const std::vector<std::int64_t>& given);
    std::vector<std::int64_t> subscripts(const std::vector<ExpressionPointer>& expressions);

    // attach.cpp
    bool leads_to_bus(const Reference& reference, const Found& found) const;
    void connect_to_bus(const ConnectStatement& form, const Found& a, const Found& b, const Location& at);
    std::size_t bus_end(const Reference& reference, const Found& found);
    std::size_t device_end(const Reference& reference, const Found& found);
    int bus_subscript(const Reference& reference, int least, int most);

    [[noreturn]] void refuse_placed_twice(const PlaceStatement& form, const char* what, const std::string& name,
                                          const Location& first);
    [[noreturn]] void refuse(const Location& at, std::string message, std::string hint = "",
                             std::vector<SecondPlace> others = {});

    const Catalogue& catalogue_;
    Reporter& reporter_;
    Scopes scopes_;
    Evaluator evaluator_;
    Draft draft_;
    ProcessType process_defaults_; ///< settings by `process (...);`, for processes of all types
    std::map<std::pair<std::size_t, int>, Location> used_links_, used_crosspoints_;
    std::set<std::tuple<std::size_t, int, int>>
        crosspoints_; ///< each element: the switch and its two connected links, the lower link first
    /// Describes a second crosspoint at a link, which is an error. The error is reported after all statements have been
    /// executed.
    struct CrosspointAgain {
        LinkEnd end;
        Location at, first;
    };
    std::vector<CrosspointAgain> crosspoints_again_;
    std::map<std::pair<std::size_t, std::string>, Location> used_ports_;
    std::set<std::string> claimed_;     ///< names of nodes, connections and processes so far, without subscripts
    std::map<std::string, int> copies_; ///< for each name that several blocks declare: the last number that was
                                        ///< appended to make the name unique
    const Statements& overrides_;
    std::map<std::string, Location> overridden_vals_; ///< for each val: place of the option that has set it
    std::map<std::pair<std::string, std::string>, const SetStatement*>
        set_; ///< option that has set a value; key: element, and attribute or parameter
    std::map<std::size_t, SetByOption> reached_; ///< what each option has set; key: position of the option
    // The next two members are for messages about options, and filled only if there are options. vals_ holds the vals
    // outside of blocks, with their values in the netlist. vals_in_blocks_ holds the names of the other vals.
    std::vector<std::pair<std::string, Constant>> vals_;
    std::set<std::string> vals_in_blocks_;
    std::size_t host_ = nowhere; ///< node of the predefined edge `host`; nowhere until the netlist uses this edge
};

} // namespace placedpar
