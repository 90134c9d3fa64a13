#include "editor/language/completion.hpp"

#include "editor/language/netlist_context.hpp"
#include "netlist/language/parser.hpp"
#include "text/positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace placedpar::editor {

namespace {

using Category = NetlistName::Category;
using Place = NetlistContext::Place;

/// Collects completions, and adds each word only once.
class NetlistCompletions {
public:
    NetlistCompletions(const NetlistSyntax& syntax, const Catalogue& catalogue)
        : syntax_(syntax), catalogue_(catalogue) {}

    std::vector<Completion> at(const NetlistContext& context) {
        switch (context.place) {
        case Place::statement: add_statements(); break;
        case Place::program: add_kinds(); break;
        case Place::member: add_members(owner_of(syntax_, catalogue_, context.owner)); break;
        case Place::attribute: add_attributes(context); break;
        case Place::value: add_values(context); break;
        case Place::thing: add_things(context.word); break;
        case Place::fault: add_faults(context.owner); break;
        case Place::file:
        case Place::new_name:
        case Place::nothing: break;
        }
        return std::move(found_);
    }

private:
    void add(Completion completion) {
        if (known_.insert(completion.text).second)
            found_.push_back(std::move(completion));
    }

    void add_statements() {
        for (const std::string& each : statement_words())
            add({each, Completion::Kind::keyword});
        for (const char* each : {"else", "fault"})
            add({each, Completion::Kind::keyword});
        for (const auto& [name, type] : catalogue_.node_types())
            add({name, Completion::Kind::type, type.preset.kind->noun, type.preset.kind->about});
        for (const NetlistName& each : syntax_.names)
            if (each.category != Category::val && each.category != Category::replicator)
                add_name(each);
    }

    void add_kinds() {
        for (const auto& [name, kind] : catalogue_.kinds())
            add({name, Completion::Kind::kind, "", kind.about});
    }

    void add_members(const NetlistOwner& owner) {
        if (owner.kind)
            for (const PortDescription& each : owner.kind->ports)
                add({each.name, Completion::Kind::port, fmt::format("{} {}", word(each.direction), each.protocol),
                     each.about});
        if (owner.name) {
            for (const std::string& each : owner.name->inputs)
                add({each, Completion::Kind::port, "input"});
            for (const std::string& each : owner.name->outputs)
                add({each, Completion::Kind::port, "output"});
        }
        if (!owner.device)
            return;
        for (int i = 0; i < owner.links; ++i)
            add({fmt::format("link[{}]", i), Completion::Kind::port, "link"});
        if (owner.device->bus != BusRole::none)
            add({"bus[0]", Completion::Kind::port, "connection to a bus"});
        if (owner.device->is_set_by_link())
            add({"config", Completion::Kind::port, "link over which a program sets the device"});
        if (owner.device->medium)
            add({"slot[1]", Completion::Kind::port, "slot of the bus"});
    }

    void add_attributes(const NetlistContext& context) {
        for (const ParameterDescription& each : attributes_in(syntax_, catalogue_, context))
            add({each.name, Completion::Kind::parameter, range_shown(each), each.about});
        if (const NetlistName* owner = syntax_.find(context.owner))
            for (const std::string& each : owner->parameters)
                add({each, Completion::Kind::parameter, "parameter"});
    }

    void add_values(const NetlistContext& context) {
        for (const ParameterDescription& each : attributes_in(syntax_, catalogue_, context))
            if (each.name == context.attribute)
                for (const std::string& choice : each.choices)
                    add({fmt::format("\"{}\"", choice), Completion::Kind::value});
        for (const NetlistName& each : syntax_.names)
            if (each.category == Category::val || each.category == Category::replicator)
                add_name(each);
    }

    void add_things(const std::string& before) {
        for (const NetlistName& each : syntax_.names) {
            const bool is_place = each.category == Category::node || each.category == Category::connection;
            const bool is_thing =
                is_place || each.category == Category::process || each.category == Category::edge_channel;
            if (before == "for"     ? each.category == Category::process
                : before == "by"    ? each.category == Category::connection
                : before == "on"    ? is_place
                : before == "fault" ? is_place
                                    : is_thing)
                add_name(each);
        }
    }

    void add_faults(const std::string& name) {
        for (const FaultKind& each : faults_of(owner_of(syntax_, catalogue_, name)))
            add({each.name, Completion::Kind::value, "fault", each.about});
    }

    void add_name(const NetlistName& name) {
        static constexpr std::array words{"val", "type", "node", "process", "connection", "edge channel", "replicator"};
        const std::string what = words[static_cast<std::size_t>(name.category)];
        add({name.name, Completion::Kind::variable, name.program.empty() ? what : what + " " + name.program});
    }

    static std::string range_shown(const ParameterDescription& description) {
        return description.least || description.most ? range_of(description) : description.unit;
    }

    const NetlistSyntax& syntax_;
    const Catalogue& catalogue_;
    std::set<std::string> known_;
    std::vector<Completion> found_;
};

/// Returns the index of the token that a completion at this place would replace or follow.
std::size_t index_at(const std::vector<Token>& tokens, const Location& at) {
    const auto touched = token_at(tokens, at);
    const bool is_word = touched && (tokens[*touched].kind == TokenKind::name || tokens[*touched].text.empty() ||
                                     tokens[*touched].kind == TokenKind::text ||
                                     (tokens[*touched].kind == TokenKind::illegal && at != tokens[*touched].at));
    if (is_word)
        return *touched;
    const auto next = std::ranges::find_if(tokens, [&](const Token& each) {
        return each.kind == TokenKind::end || each.at.line > at.line ||
               (each.at.line == at.line && each.at.column >= at.column);
    });
    return static_cast<std::size_t>(next - tokens.begin());
}

bool is_in_comment(const std::vector<Token>& tokens, std::size_t next, const Location& at) {
    const std::size_t from = next == 0 ? 0 : offset_of(tokens[next - 1].end), until = offset_of(at);
    const std::string_view before = std::string_view(at.file->text()).substr(0, until).substr(std::min(from, until));
    const auto opening = before.rfind("/*");
    return opening != before.npos && before.find("*/", opening + 2) == before.npos;
}

} // namespace

std::vector<Completion> complete_netlist(const NetlistSyntax& syntax, const Catalogue& catalogue, const Location& at) {
    const std::size_t index = index_at(syntax.tokens, at);
    const NetlistContext context = context_of(syntax.tokens, index);
    const bool in_string =
        syntax.tokens[index].kind == TokenKind::text || syntax.tokens[index].kind == TokenKind::illegal;
    if ((in_string && context.place != Place::program) || is_in_comment(syntax.tokens, index, at))
        return {};
    return NetlistCompletions(syntax, catalogue).at(context);
}

} // namespace placedpar::editor
