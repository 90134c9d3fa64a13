#pragma once

#include "netlist/language/made_netlist.hpp"
#include "occam/check/checker.hpp"
#include "occam/configuration/configured.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Executes the statements of an occam configuration, which describes processors, wires, and the processes on each
/// processor. Conditions, and the base, count and step of replicators, must be constants.
class Configurer {
public:
    /// The ValChoice, by which options change values, chooses the value of each VAL. REQUIRES: the program was parsed
    /// without errors, and is a configuration.
    Configurer(Program&, const ValChoice&, Reporter&);

    /// Returns what the configuration describes. The result is incomplete if an error was reported.
    Configured run();

private:
    /// Holds consecutive elements of an array of channels, nodes, arcs or edges.
    struct Range {
        std::size_t object = 0, first = 0, count = 0;
    };
    using Selection = std::vector<Range>;
    enum class Part { network, mapping, software };
    /// Describes the node whose PROCESSOR statement is being executed.
    struct CurrentProcessor {
        Element node;
        Place at;
        bool high_priority = false;
        bool has_priority_par = false;
    };

    // Declarations and constructs (configurer.cpp)
    void add_predefined();
    void visit(Declaration&);
    void visit_all(std::vector<DeclarationBox>&);
    void declare(Declaration&);
    void execute(Process&);
    void execute_part(Declaration&, ConfigurationPart&);
    void form_of(Process&, Skip&) {}
    void form_of(Process&, Scope&);
    void form_of(Process&, Sequence&);
    void form_of(Process&, Parallel&);
    void form_of(Process&, If&);
    void form_of(Process&, Processor&);
    void form_of(Process&, Instance&);
    void form_of(Process&, Wiring&);
    template <class Other>
    void form_of(Process&, Other&);
    void refuse(const Process&);
    bool execute_if(If&);
    bool execute_choices(If&);
    void repeat(std::optional<Replicator>&, const std::function<bool()>& body);
    std::optional<std::int64_t> constant(Expression&, const std::string& role);
    void count_step(const Place&);

    // Paths to channels, nodes, arcs and edges (paths.cpp)
    Selection selection_of(const Expression&);
    Selection slice(const Selection&, std::size_t first, std::size_t count) const;
    std::vector<Element> elements(Expression&, Type::Kind, const std::string& what);
    std::vector<Element> elements(const Selection&, const Place&);
    std::optional<Element> single(Expression&, Type::Kind, const std::string& what);
    bool has_kind(const Expression&, Type::Kind, const std::string& what);
    std::size_t new_object(std::string name, const Type*, const Place&);

    // NETWORK and MAPPING (wiring.cpp)
    void connect(const Place&, Connect&);
    void name_wire(const Element& arc, const Place&);
    std::optional<WireEnd> end_of(ConnectionEnd&);
    void set(SetNode&);
    void set_type(NodeState&, const Element&, Setting&);
    void set_memory(NodeState&, const Element&, Setting&);
    void map(MapOnto&);
    void map_node(const Element&, const Place&, const Element& onto, bool high_priority);
    void place_on_arc(const Element& channel, const Place&, const Element& arc);
    void place(Declaration&, Placement&);
    void place_at_link(Expression& path, std::int64_t word, const Place& word_at);

    // CONFIG and PLACED PAR (software.cpp)
    void instance(Process&, Instance&);
    std::optional<Element> node_of(Processor&);
    std::optional<Element> numbered_node(Processor&);
    const ProcessKind* kind_of_procedure(const Declaration&);
    void argument(Expression&, const Declaration& parameter, const ProcessKind&, std::size_t& port, PlacedProcess&);
    void channel_argument(Expression&, const PortDescription&, ChannelEnd);
    void add_end(const Element& channel, const PortDescription&, const ChannelEnd&);

    // Checks after the last statement (conclusion.cpp)
    void check_whole();
    void visit_channels(void (Configurer::*)(const Element&, ChannelState&));
    void check_nodes();
    void check_node(const Element&, const NodeState&, const Place& declared);
    void find_processors();
    void check_channel(const Element&, ChannelState&);
    bool is_local(const ChannelState&) const;
    void follow_arc(const Element&, ChannelState&);
    void check_arc(const Element&, const ChannelState&, const WrittenWire&);
    bool is_at_its_process(const Element&, const std::optional<WireEnd>&, const std::optional<ChannelEnd>&,
                           bool is_output);
    void connect_placed(const Element&, ChannelState&);
    void add_wire(const WireEnd&, const WireEnd&);

    Location at(const Place& place) const { return program_.location(place); }
    std::string text(const Element& element) const { return text_of(configured_, element); }

    Program& program_;
    const ValChoice& choose_;
    Reporter& reporter_;
    Checker checker_;
    Configured configured_;
    std::map<const Declaration*, Selection> selections_;
    std::map<std::int64_t, Element> numbered_;
    std::map<Element, std::vector<WireEnd>> links_used_; ///< for each node: the ends of wires at this node
    Part part_ = Part::software;
    std::optional<CurrentProcessor> here_;
    bool has_config_ = false;
    std::size_t steps_ = 0;
};

} // namespace placedpar::occam
