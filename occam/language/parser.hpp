#pragma once

#include "occam/language/files.hpp"
#include "occam/language/lines.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::occam {

/// Functions of Parser throw this exception after reporting an error. Parsing then continues with a later line.
struct LineRefused {};

/// Parses one occam file into a tree (occam/language/tree.hpp), by recursive descent. After an error, parsing continues
/// at the next line that is not indented further than the line with the error.
class Parser {
public:
    Parser(Reading& reading, std::uint32_t file);

    /// Reads all declarations of the file.
    std::vector<DeclarationBox> parse_file();

private:
    /// Counts a level of nesting during its lifetime. The constructor refuses too deep a level, so that no text can
    /// exhaust the stack.
    struct Nesting {
        explicit Nesting(Parser&);
        ~Nesting() { --reading.depth; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        Reading& reading;
    };

    // Words (parser.cpp)
    const Word& peek(std::size_t ahead = 0) const;
    const Word& take();
    bool accept(std::string_view symbol);
    bool accept_word(std::string_view word);
    void expect(std::string_view symbol, std::string_view where);
    void expect_word(std::string_view word, std::string_view where);
    std::string expect_name(std::string_view what);
    bool is_at_end() const { return line_.is_end; }
    bool is_at_line_start() const { return position_ == 0; }
    void next_line();
    void end_line(std::string_view behind);
    [[noreturn]] void refuse(const Word& at, std::string message, std::string hint = "");
    [[noreturn]] void refuse_unread(const Word&, std::string_view where);
    Location at(const Word& word) const { return reading_.location(word.at); }

    // Layout (layout.cpp)
    using Component = std::function<void()>;
    void parse_block(const Word& head, const Component&);
    void check_indentation(const Word& first, std::uint32_t wanted, const Word& head);
    std::uint32_t adopt_indentation(const Word& first, const Word& head);
    void parse_header(const Component&);
    void recover(std::uint32_t indentation, std::size_t line);
    bool block_goes_on(std::uint32_t indentation) const;
    ProcessBox parse_body(const Word& head);

    // Types (parse_type.cpp)
    std::shared_ptr<TypeText> parse_type();
    void parse_base_type(TypeText&);
    ProtocolText parse_channel_protocol();
    ItemText parse_item_type();
    ProtocolText parse_sequence();
    std::optional<Basic> basic_type(const Word&) const;
    /// Returns the number of words of the type that begins `ahead` words after the next word; 0 if no type begins
    /// there.
    std::size_t type_length(std::size_t ahead) const;
    std::size_t dimensions_length(std::size_t ahead) const;
    std::size_t bracket_length(std::size_t ahead) const;
    void refuse_foreign_type();

    // Expressions (parse_expression.cpp)
    Expression parse_expression();
    std::vector<Expression> parse_expressions();
    std::vector<Expression> parse_arguments();
    Expression parse_argument();
    Expression parse_operand();
    Expression parse_primary();
    Expression parse_chain(Expression left);
    Expression parse_number_literal();
    Expression parse_boolean();
    Expression parse_character();
    Expression parse_string();
    Expression parse_unary(Operator);
    Expression parse_conversion(std::shared_ptr<TypeText>);
    Expression parse_brackets();
    Expression parse_parentheses();
    Expression parse_name_or_call();
    Expression parse_bound();
    Expression parse_subscripts(Expression);
    Expression parse_element(std::string_view what);
    bool is_conversion() const;
    bool is_value_process() const;
    ValueProcess parse_value_process();
    void parse_value_body(ValueProcess&, const Word& head);
    void parse_literal_type(std::optional<Basic>&, std::string& name);
    template <class Form>
    Expression made(const Word& word, Form form) const {
        Expression expression;
        expression.at = word.at;
        expression.form = std::move(form);
        return expression;
    }

    // Processes (parse_process.cpp)
    Process parse_process();
    Process parse_scope();
    Process parse_statement();
    Process parse_assignment_or_communication();
    Process parse_sequence_process();
    Process parse_parallel(Parallel::Kind);
    Process parse_instance();
    Process parse_case();
    Process parse_while();
    Process parse_input(Expression channel, const Word& head);
    Process parse_output(Expression channel);
    std::vector<Item> parse_items();
    Item parse_item();
    std::optional<Replicator> parse_replicator();
    void parse_option(Case&);
    [[noreturn]] void refuse_statement(const Word&);

    // Configurations (parse_configuration.cpp)
    bool is_configuration_part() const;
    void parse_configuration_part(std::vector<DeclarationBox>&);
    /// Returns whether `CONNECT`, `SET` or `MAP` begins here.
    bool is_wiring() const;
    bool is_do() const;
    Process parse_wiring();
    Connect parse_connect();
    ConnectionEnd parse_connection_end();
    SetNode parse_set();
    MapOnto parse_map();
    Process parse_processor();

    // Processes with guards (parse_guard.cpp)
    If parse_if();
    Choice parse_choice();
    Alternation parse_alternation(bool has_priority);
    Alternative parse_alternative();
    void parse_guard(Alternative&);
    Variant parse_variant();
    void parse_variants(VariantInput&, const Word& head);
    void parse_tag(Variant&);

    // Declarations (parse_declaration.cpp)
    /// Returns whether a declaration begins here. `or_expression` is true if an expression may begin here, too; `INT x`
    /// is then read as a conversion.
    bool is_declaration(bool or_expression) const;
    bool is_foreign_statement() const;
    void parse_declarations(std::vector<DeclarationBox>&, bool or_expression);
    void parse_with_start(std::vector<DeclarationBox>&);
    void parse_declaration(std::vector<DeclarationBox>&);
    void parse_typed(std::vector<DeclarationBox>&);
    void parse_value(std::vector<DeclarationBox>&);
    void parse_initial(std::vector<DeclarationBox>&);
    void parse_untyped(std::vector<DeclarationBox>&, bool is_value);
    bool parse_definition(std::vector<DeclarationBox>&, const Word& name, std::shared_ptr<TypeText>, bool is_value);
    void parse_placement(std::vector<DeclarationBox>&);
    void parse_protocol(std::vector<DeclarationBox>&);
    void parse_tags(Protocol&, const Word& head);
    void parse_data_type(std::vector<DeclarationBox>&);
    void parse_record(DataType&, const Word& head);
    void parse_fields(DataType&, const Word& head);
    void parse_use(std::vector<DeclarationBox>&);
    void end_declaration(std::string_view what, const std::string& hint = "");
    bool is_array_by_mistake(std::size_t ahead) const;
    std::string hint_for_value(const std::string& type, const Word& name) const;
    std::string hint_for_array(const std::string& type, const Word& name) const;
    std::string written(std::size_t words) const;
    DeclarationBox& add(std::vector<DeclarationBox>&, const Word& name, decltype(Declaration::form));
    bool accept_direction(std::optional<bool>& is_output);

    // Procedures and functions (parse_procedure.cpp)
    void parse_procedure(std::vector<DeclarationBox>&);
    bool is_recursive_procedure() const;
    void parse_function(std::vector<DeclarationBox>&);
    std::vector<DeclarationBox> parse_parameters();
    void parse_parameter(std::vector<DeclarationBox>&, Parameter& kind);
    void end_body(const Word& head, std::string_view what);

    Reading& reading_;
    Lines lines_;
    Line line_;
    std::size_t position_ = 0;
    std::size_t lines_taken_ = 0;
    bool header_failed_ = false;        ///< parse_header() has reported an error in the line that it read last
    bool indentation_in_doubt_ = false; ///< a line that begins an enclosing construct has a wrong indentation
    Word last_;                         ///< the word that was taken last
};

} // namespace placedpar::occam
