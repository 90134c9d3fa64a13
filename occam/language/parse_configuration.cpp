#include "occam/language/parser.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace placedpar::occam {

/// Returns whether NETWORK, MAPPING or CONFIG begins a part of a configuration here. These words may also be names of
/// procedures or variables. They begin a part only if the line ends after the word, or after one name that follows it.
bool Parser::is_configuration_part() const {
    if (peek().is_word("PLACED"))
        return true;
    const bool is_word = peek().is_word("NETWORK") || peek().is_word("MAPPING") || peek().is_word("CONFIG");
    const Word& next = peek(1);
    return is_word && (next.kind == WordKind::end || (next.kind == WordKind::name && peek(2).kind == WordKind::end));
}

void Parser::parse_configuration_part(std::vector<DeclarationBox>& declarations) {
    const Word head = peek();
    reading_.program.is_configuration = true;
    ConfigurationPart part;
    const bool has_end = !head.is_word("PLACED");
    if (has_end) {
        take();
        if (peek().kind == WordKind::name)
            take();
        end_line(head.text);
    }
    part.process = has_end ? parse_body(head) : std::make_unique<Process>(parse_process());
    add(declarations, head, std::move(part));
    if (has_end)
        end_body(head, head.text);
}

bool Parser::is_do() const {
    const Word& next = peek(1);
    return peek().is_word("DO") && (next.kind == WordKind::end || (next.kind == WordKind::name && peek(2).is("=")));
}

bool Parser::is_wiring() const {
    if (peek(1).kind != WordKind::name)
        return false;
    if (peek().is_word("CONNECT"))
        return true;
    if (peek().is_word("SET"))
        return peek(2).is("(") || peek(2).is("[");
    if (!peek().is_word("MAP"))
        return false;
    std::size_t ahead = 2;
    while (peek(ahead).kind != WordKind::end && !peek(ahead).is(":") && !peek(ahead).is_word("IS"))
        ++ahead;
    return peek(ahead).kind == WordKind::end;
}

Process Parser::parse_wiring() {
    const Word head = take();
    Wiring wiring;
    if (head.is_word("CONNECT"))
        wiring.form = parse_connect();
    else if (head.is_word("SET"))
        wiring.form = parse_set();
    else
        wiring.form = parse_map();
    end_line(head.text);
    return {head.at, std::move(wiring)};
}

Connect Parser::parse_connect() {
    Connect connect{.from = parse_connection_end(), .to = {}, .arc = nullptr};
    expect_word("TO", "after the first end of a connection");
    connect.to = parse_connection_end();
    if (accept_word("WITH"))
        connect.arc = std::make_unique<Expression>(parse_element("an arc"));
    return connect;
}

/// Reads `node[i][link][n]`, or the name of an edge.
ConnectionEnd Parser::parse_connection_end() {
    const Word first = peek();
    NameUse use{expect_name("a node or an edge")};
    ConnectionEnd end{.path = made(first, std::move(use)), .link = nullptr};
    for (std::size_t depth = 0; peek().is("["); ++depth) {
        const Word bracket = take();
        if (depth >= deepest_nesting)
            reading_.reporter.give_up(at(bracket), fmt::format("at most {} subscripts are allowed", deepest_nesting));
        if (peek().is_word("link") && peek(1).is("]")) {
            take();
            take();
            expect("[", "after [link]");
            end.link = std::make_unique<Expression>(parse_expression());
            expect("]", "after the number of a link");
            return end;
        }
        Subscript subscript;
        subscript.array = std::make_unique<Expression>(std::move(end.path));
        subscript.index = std::make_unique<Expression>(parse_expression());
        expect("]", "after a subscript");
        end.path = made(first, std::move(subscript));
    }
    return end;
}

SetNode Parser::parse_set() {
    SetNode set{.node = parse_element("a node"), .settings = {}};
    expect("(", "after the node of SET");
    do {
        const Place place = peek().at;
        set.settings.push_back({place, expect_name("an attribute"), {}});
    } while (accept(","));
    const Word assign = peek();
    expect(":=", "after the attributes of SET");
    std::vector<Expression> values = parse_expressions();
    if (values.size() != set.settings.size())
        refuse(assign, fmt::format("SET has {} for {}", counted(values.size(), "value"),
                                   counted(set.settings.size(), "attribute")));
    for (std::size_t i = 0; i < values.size(); ++i)
        set.settings[i].value = std::move(values[i]);
    expect(")", "after the values of SET");
    return set;
}

MapOnto Parser::parse_map() {
    MapOnto map;
    do
        map.mapped.push_back(parse_element("a node or channel"));
    while (accept(","));
    expect_word("ONTO", "after what is mapped");
    map.onto = parse_element("a node or an arc");
    if (accept_word("PRI"))
        map.priority = std::make_unique<Expression>(parse_expression());
    return map;
}

/// Reads `PROCESSOR 0 T8` and `PROCESSOR node`. Reads the node as an operand, since in an expression `node T8` would be
/// a conversion.
Process Parser::parse_processor() {
    const Word head = take();
    Processor process;
    parse_header([&] {
        process.number = parse_chain(parse_operand());
        process.type = peek().kind == WordKind::end ? "" : expect_name("a type of processor");
        end_line("PROCESSOR");
    });
    process.process = parse_body(head);
    return {head.at, std::move(process)};
}

} // namespace placedpar::occam
