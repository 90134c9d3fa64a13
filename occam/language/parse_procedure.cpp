#include "occam/language/parser.hpp"

#include <fmt/format.h>

namespace placedpar::occam {

/// Expects the line with `:` that ends a PROC, FUNCTION, PROTOCOL, DATA TYPE, or part of a configuration.
void Parser::end_body(const Word& head, std::string_view what) {
    if (!peek().is(":")) {
        const Location place = is_at_end() ? at(last_) : at(peek());
        if (!indentation_in_doubt_)
            reading_.reporter.error(place, fmt::format("\":\" is missing at the end of {}", what),
                                    "write \":\" on a line of its own, with the indentation of the first word",
                                    {{"the definition begins here", at(head)}});
        return;
    }
    const Word colon = take();
    if (colon.indentation != head.indentation && !indentation_in_doubt_)
        reading_.reporter.error(
            at(colon),
            fmt::format("wrong indentation: the number of blanks before \":\" is {}, but must be {}", colon.indentation,
                        head.indentation),
            "", {{fmt::format("the \":\" ends {}", what), at(head)}});
    end_line("\":\"");
}

/// Returns whether `REC PROC` begins here. Such a procedure is parsed, but REC is reported as an error.
bool Parser::is_recursive_procedure() const {
    return (peek().is_word("REC") || peek().is_word("RECURSIVE")) && peek(1).is_word("PROC");
}

void Parser::parse_procedure(std::vector<DeclarationBox>& declarations) {
    Procedure procedure;
    const Word head = peek();
    if (is_recursive_procedure()) {
        if (reading_.refused.emplace("REC").second)
            reading_.reporter.error(at(head), fmt::format("{} belongs to occam-pi, which is not supported", head.text));
        take();
    }
    procedure.is_inline = accept_word("INLINE");
    take();
    Word name = peek();
    parse_header([&] {
        expect_name("a procedure");
        procedure.parameters = parse_parameters();
        end_line("the parameters");
    });
    if (name.kind != WordKind::name)
        name.text = {};
    procedure.body = parse_body(head);
    add(declarations, name, std::move(procedure));
    end_body(head, fmt::format("PROC {}", name.text));
}

std::vector<DeclarationBox> Parser::parse_parameters() {
    std::vector<DeclarationBox> parameters;
    expect("(", "before the parameters");
    if (accept(")"))
        return parameters;
    Parameter kind;
    do
        parse_parameter(parameters, kind);
    while (accept(","));
    if (!accept(")"))
        refuse(peek(), fmt::format("\",\" or \")\" is expected after a parameter: found {}", describe(peek())));
    return parameters;
}

/// Reads a parameter. A parameter without a type has the type of the preceding parameter.
void Parser::parse_parameter(std::vector<DeclarationBox>& parameters, Parameter& kind) {
    const Word& behind = peek(1);
    const bool is_name_alone =
        peek().kind == WordKind::name && (behind.is(",") || behind.is(")") || behind.is("!") || behind.is("?"));
    if (!is_name_alone) {
        kind = {};
        if (accept_word("VAL"))
            kind.passing = Parameter::Passing::value;
        else if (accept_word("RESULT"))
            kind.passing = Parameter::Passing::result;
        kind.type = parse_type();
    } else if (!kind.type)
        refuse(peek(), fmt::format("the type of the parameter \"{}\" is missing", peek().text));
    const Word name = peek();
    expect_name("a parameter");
    Parameter parameter = kind;
    accept_direction(parameter.written_output);
    add(parameters, name, std::move(parameter));
}

void Parser::parse_function(std::vector<DeclarationBox>& declarations) {
    Function function;
    const Word head = peek();
    Word name = head;
    bool is_short = false;
    parse_header([&] {
        do
            function.results.push_back(parse_type());
        while (accept(","));
        function.is_inline = accept_word("INLINE");
        expect_word("FUNCTION", "after the types of results");
        name = peek();
        expect_name("a function");
        function.parameters = parse_parameters();
        is_short = accept_word("IS");
        function.body.results_at = peek().at;
        if (is_short)
            function.body.results = parse_expressions();
        else
            end_line("the parameters");
    });
    if (is_short) {
        add(declarations, name, std::move(function));
        return end_declaration("a function");
    }
    parse_block(head, [&] { function.body = parse_value_process(); });
    add(declarations, name, std::move(function));
    end_body(head, fmt::format("FUNCTION {}", name.text));
}

} // namespace placedpar::occam
