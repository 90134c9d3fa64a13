#pragma once

#include "tests/occam/language/print.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Writes pieces of a tree as text: expressions in a line, processes and declarations as lines.
class Printer {
public:
    explicit Printer(const Program* program, std::size_t indentation = 0)
        : program_(program), indentation_(indentation) {}

    std::string expression(const Expression&);
    std::string type(const TypeText&);
    void declarations(const std::vector<DeclarationBox>&);
    std::string take() { return std::move(text_); }

private:
    /// Characters that enclose the lines of a value process within a line.
    static constexpr char lines_begin = '\x01', lines_end = '\x02';

    // Expressions (print_expression.cpp)
    std::string list(const std::vector<Expression>&);
    std::string operand(const Expression&);
    std::string item(const ItemText&);
    std::string protocol(const ProtocolText&);
    std::string written(const NameUse&);
    std::string written(const IntegerLiteral&);
    std::string written(const RealLiteral&);
    std::string written(const StringLiteral&);
    std::string written(const TableLiteral&);
    std::string written(const UnaryOperation&);
    std::string written(const BinaryOperation&);
    std::string written(const Conversion&);
    std::string written(const Subscript&);
    std::string written(const Segment&);
    std::string written(const Call&);
    std::string written(const ValueProcess&);
    std::string written(const TypeBound&);
    std::string written(const OffsetOf&);

    // Processes (print_process.cpp)
    void line(const std::string&);
    void below(const Process&);
    void below(const ProcessBox& process) { below(*process); }
    std::string replicator(const std::optional<Replicator>&);
    std::string items(const std::vector<Item>&);
    void process(const Process&);
    void put(const Skip&) { line("SKIP"); }
    void put(const Stop&) { line("STOP"); }
    void put(const Assignment&);
    void put(const Input&);
    void put(const Delay&);
    void put(const VariantInput&);
    void put(const Output&);
    void put(const Sequence&);
    void put(const Parallel&);
    void put(const If&);
    void put(const Case&);
    void put(const While&);
    void put(const Alternation&);
    void put(const Instance&);
    void put(const Scope&);
    void put(const Processor&);
    void put(const Wiring&);
    void put(const Connect&);
    void put(const SetNode&);
    void put(const MapOnto&);
    void variants(const std::string& head, const VariantInput&);
    void alternative(const Alternative&);
    void value_process(const ValueProcess&);

    // Declarations (print_declaration.cpp)
    void declaration(const Declaration&, const std::string& names);
    void put(const Declaration&, const std::string& names, const Variable&);
    void put(const Declaration&, const std::string&, const Abbreviation&);
    void put(const Declaration&, const std::string&, const Retyping&);
    void put(const Declaration&, const std::string&, const Parameter&) {}
    void put(const Declaration&, const std::string&, const ReplicatorIndex&) {}
    void put(const Declaration&, const std::string&, const Procedure&);
    void put(const Declaration&, const std::string&, const Function&);
    void put(const Declaration&, const std::string&, const Protocol&);
    void put(const Declaration&, const std::string&, const DataType&);
    void put(const Declaration&, const std::string&, const Placement&);
    void put(const Declaration&, const std::string&, const Use&);
    void put(const Declaration&, const std::string&, const Predefined&) {}
    void put(const Declaration&, const std::string&, const ConfigurationPart&);
    std::string parameters(const std::vector<DeclarationBox>&);

    const Program* program_;
    std::size_t indentation_;
    std::string text_;
};

} // namespace placedpar::occam
