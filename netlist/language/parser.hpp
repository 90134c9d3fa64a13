#pragma once

#include "netlist/language/syntax.hpp"
#include "netlist/language/token_stream.hpp"

#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar {

/// Limits the nesting of blocks, `rep` and `if` statements, parentheses, brackets, attributes, signs and casts, so that
/// no text can exhaust the stack.
inline constexpr int deepest_nesting = 200;
/// Limits the height of an expression's tree: `1 + 1 + ...` may have 1000 operators.
inline constexpr int highest_expression = 1001;

/// Parses a netlist by recursive descent, with the grammar of docs/reference/netlist-language.md. After an error,
/// parsing continues after the next `;`, so that several errors are reported together.
class Parser {
public:
    Parser(TokenStream& tokens, Reporter& reporter) : tokens_(tokens), reporter_(reporter) {}

    Statements parse_netlist();
    /// Parses a text that consists of one expression. Throws StatementRefused after reporting an error.
    ExpressionPointer parse_whole_expression();
    /// Parses the beginning of an option such as `p[1].n = 4`, up to the `=`. Throws StatementRefused after reporting
    /// an error.
    Reference parse_target();
    /// Parses the value of the option `--fault`, such as `t[0].link[1] silent`: a `fault` statement without the word
    /// `fault` and without the `;`. Throws StatementRefused after reporting an error.
    Statement parse_fault_option();

private:
    // parser.cpp: statements
    void parse_into(Statements& statements);
    Statement parse_statement();
    Statement parse_keyword_statement(const Token& word);
    Statement parse_declaration_or_setting(const Token& first);
    std::unique_ptr<Statement> parse_body(std::string_view whose);
    Statement parse_block();
    void recover();

    // parse_declaration.cpp
    Statement parse_val();
    Statement parse_define();
    Statement parse_declaration();
    Statement parse_connection();
    Statement parse_edge_channel();
    Statement parse_setting();
    std::vector<Declarator> parse_declarators(std::string_view what);
    Declarator parse_declarator(std::string_view what);
    Declarator parse_type_name();
    /// Takes the name of a type, or the reserved word `process`.
    Token expect_type(std::string_view what);

    // parse_attribute.cpp
    std::vector<Attribute> parse_attributes();
    Attribute parse_attribute();
    DeclarationAttributes parse_declaration_attributes();
    Attribute parse_process_attribute();
    void parse_interface_once(DeclarationAttributes& attributes);
    std::vector<InterfaceEntry> parse_interface();
    [[noreturn]] void refuse_entry();
    /// Parses a channel's direction or a parameter's type, if there is one here.
    std::optional<EntryType> parse_entry_type();
    InterfaceEntry parse_entry(const EntryType& type);
    bool behind_attributes_comes_name();

    // parse_mapping.cpp
    Statement parse_connect();
    Statement parse_use();
    Statement parse_place();
    Statement parse_fault();
    FaultStatement parse_fault_itself();
    Statement parse_rep();
    Statement parse_if();
    Reference parse_reference(std::string_view what, std::string_view part = "a link or channel");
    std::vector<ExpressionPointer> parse_subscripts();

    // parse_expression.cpp
    ExpressionPointer parse_expression();
    /// Parses operands and operators, as long as the operators bind more strongly than `weakest`.
    ExpressionPointer parse_operation(int weakest);
    ExpressionPointer parse_conditional(ExpressionPointer condition);
    ExpressionPointer parse_unary();
    ExpressionPointer parse_cast();
    ExpressionPointer parse_size();
    ExpressionPointer parse_postfix();
    ExpressionPointer parse_primary();
    ExpressionPointer parse_array_constant();
    ExpressionPointer combine(const Token& symbol, ExpressionPointer left, ExpressionPointer right);
    /// Returns the height of the tree of an expression with these parts. Refuses the expression if the height exceeds
    /// highest_expression.
    int height_above(const Location& at, std::initializer_list<const Expression*> parts);

    bool accept(std::string_view symbol);
    void expect(std::string_view symbol, std::string_view where);
    void expect_word(std::string_view word, std::string_view where);
    void expect_semicolon(std::string_view statement);
    bool on_another_line();
    bool statement_is_over();
    /// Returns the place for a message that something is missing: the next token, or the end of the last token if the
    /// next token is on a later line.
    Location gap();
    Token expect_name(std::string_view what);
    [[noreturn]] void refuse_missing(std::string_view what, std::string_view where);
    [[noreturn]] void refuse(const Location& at, std::string message, std::string hint = "");

    /// Counts one level of nesting during its lifetime.
    struct Nesting {
        explicit Nesting(Parser& owner);
        ~Nesting() { --parser.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        Parser& parser;
    };

    TokenStream& tokens_;
    Reporter& reporter_;
    int depth_ = 0;
    int arrays_open_ = 0; ///< number of array constants, each in another, that are being parsed
    std::optional<Token>
        misspelt_; ///< first word of the current statement, if it is probably a misspelt word of the language
    std::set<std::string, std::less<>> types_; ///< names of the types that the netlist defines
};

/// Returns the reserved words: words that begin a statement or separate its parts, such as `connect` and `to`.
std::span<const std::string_view> reserved_words();
/// Returns the words that begin a statement.
const std::vector<std::string>& statement_words();
/// Returns the types of parameters in an interface, such as "int".
std::span<const std::string_view> parameter_types();
/// Returns whether the word is one of the reserved words, which cannot be names.
bool is_reserved(std::string_view word);
/// Returns whether a netlist can use the text as a name: a single word that is not reserved.
bool can_be_a_name(std::string_view text);
/// Returns the word of `words` that differs from `word` in one or two letters, or only in upper and lower case; "" if
/// there is none.
std::string word_meant(const std::string& word, const std::vector<std::string>& words);
/// Returns word_meant() among the words that begin a statement.
std::string word_meant(const std::string& word);

} // namespace placedpar
