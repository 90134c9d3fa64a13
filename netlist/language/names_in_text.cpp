#include "netlist/language/names_in_text.hpp"

#include "netlist/language/parser.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace placedpar {

namespace {

using Category = NetlistName::Category;

/// Finds the names that statements declare and use. A name is visible from its declaration to the end of its block.
class NameWalk {
public:
    explicit NameWalk(NetlistSyntax& syntax) : syntax_(syntax) { walk(syntax.statements); }

private:
    void walk(const Statement& statement) {
        std::visit([&](const auto& form) { walk(form, statement.at); }, statement.form);
    }

    void walk(const ValStatement& form, const Location& at) {
        walk(form.value);
        declare({.name = form.name, .at = at, .category = Category::val});
        if (const auto* text = std::get_if<TextLiteral>(&form.value->form))
            texts_[form.name] = text->value;
    }

    void walk(const DefineStatement& form, const Location&) {
        walk(form.attributes);
        NetlistName name = declared_by(form.base, form.base_at, form.attributes);
        name.category = Category::type;
        declare_all(form.names, name);
    }

    void walk(const Declaration& form, const Location&) {
        walk(form.attributes);
        const NetlistName name = declared_by(form.type, form.type_at, form.attributes);
        if (form.names.empty())
            defaults_ = name;
        declare_all(form.names, name);
    }

    /// Returns a name that is declared with this type. If `define` statements made the type, the result's `type` is the
    /// predefined type from which they derive it.
    NetlistName declared_by(const std::string& type, const Location& at, const DeclarationAttributes& attributes) {
        use(type, at);
        const NetlistName* const base = visible(type);
        NetlistName name = base ? *base : is_process_type(type) ? defaults_ : NetlistName{};
        if (!base)
            name.type = type;
        name.category = is_process_type(name.type) ? Category::process : Category::node;
        if (attributes.interface) {
            name.inputs = name.outputs = name.parameters = {};
            add_interface(name, *attributes.interface);
        }
        return name;
    }

    void walk(const ConnectionDeclaration& form, const Location&) {
        walk(form.attributes);
        declare_all(form.names, {.name = "", .at = {}, .category = Category::connection});
    }

    void walk(const EdgeChannelDeclaration& form, const Location&) {
        declare_all(form.names, {.name = "", .at = {}, .category = Category::edge_channel});
    }

    void walk(const ConnectStatement& form, const Location&) { walk_all(form.a, form.b, form.by); }
    void walk(const PlaceStatement& form, const Location&) { walk_all(form.what, form.where); }
    void walk(const FaultStatement& form, const Location&) { walk_all(form.what, form.attributes); }
    void walk(const ParameterSetting& form, const Location&) { walk_all(form.process, form.values); }
    void walk(const IfStatement& form, const Location&) { walk_all(form.condition, form.then, form.otherwise); }
    void walk(const SetStatement&, const Location&) const {} // options contain such statements, netlists do not

    void walk(const UseStatement& form, const Location&) {
        walk(form.program);
        if (!form.process) {
            default_program_ = text_of(*form.program);
            return;
        }
        walk(*form.process);
        if (NetlistName* const process = visible(form.process->name))
            process->program = text_of(*form.program);
    }

    void walk(const RepStatement& form, const Location&) {
        walk_all(form.first, form.count, form.last);
        const std::size_t mark = declared_.size();
        declare({.name = form.name, .at = form.name_at, .category = Category::replicator});
        walk(*form.body);
        leave(mark);
    }

    void walk(const BlockStatement& form, const Location&) {
        const std::size_t mark = declared_.size();
        walk(form.statements);
        leave(mark);
    }

    template <class... Parts>
    void walk_all(const Parts&... parts) {
        (walk(parts), ...);
    }
    template <class Part>
    void walk(const std::vector<Part>& parts) {
        for (const Part& each : parts)
            walk(each);
    }
    template <class Part>
    void walk(const std::optional<Part>& part) {
        if (part)
            walk(*part);
    }
    template <class Part>
    void walk(const std::unique_ptr<Part>& part) {
        if (part)
            walk(*part);
    }

    void walk(const Reference& reference) {
        use(reference.name, reference.at);
        walk_all(reference.subscripts, reference.field_subscripts);
    }
    void walk(const Attribute& attribute) { walk_all(attribute.value, attribute.group); }
    void walk(const DeclarationAttributes& all) { walk_all(all.attributes, all.interface); }
    void walk(const InterfaceEntry& entry) { walk_all(entry.default_value, entry.declarator.dimensions); }

    void walk(const Expression& expression) {
        std::visit([&](const auto& form) { walk_form(form, expression.at); }, expression.form);
    }
    template <class Literal>
    void walk_form(const Literal&, const Location&) const {}
    void walk_form(const NameUse& form, const Location& at) { use(form.name, at); }
    void walk_form(const UnaryOperation& form, const Location&) { walk(form.operand); }
    void walk_form(const CastOperation& form, const Location&) { walk(form.operand); }
    void walk_form(const SizeOperation& form, const Location&) { walk(form.array); }
    void walk_form(const BinaryOperation& form, const Location&) { walk_all(form.left, form.right); }
    void walk_form(const SubscriptOperation& form, const Location&) { walk_all(form.array, form.subscript); }
    void walk_form(const ArrayConstant& form, const Location&) { walk(form.elements); }
    void walk_form(const ConditionalOperation& form, const Location&) {
        walk_all(form.condition, form.then, form.otherwise);
    }

    static bool is_process_type(std::string_view type) {
        static constexpr std::array<std::string_view, 6> types{"process",     "PROCESS",    "highprocess",
                                                               "HIGHPROCESS", "lowprocess", "LOWPROCESS"};
        return std::ranges::find(types, type) != types.end();
    }

    static void add_interface(NetlistName& name, const std::vector<InterfaceEntry>& interface) {
        for (const InterfaceEntry& each : interface) {
            const auto* direction = std::get_if<Direction>(&each.type);
            auto& list = !direction ? name.parameters : *direction == Direction::input ? name.inputs : name.outputs;
            list.push_back(each.declarator.name);
        }
    }

    /// Returns the text of a string constant, or of a val that is a string; "" for any other expression.
    std::string text_of(const Expression& expression) const {
        if (const auto* text = std::get_if<TextLiteral>(&expression.form))
            return text->value;
        const auto* name = std::get_if<NameUse>(&expression.form);
        const auto found = name ? texts_.find(name->name) : texts_.end();
        return found == texts_.end() ? "" : found->second;
    }

    void declare_all(const std::vector<Declarator>& names, NetlistName name) {
        for (const Declarator& each : names) {
            walk(each.dimensions);
            name.name = each.name;
            name.at = each.at;
            if (name.category == Category::process)
                name.program = default_program_;
            declare(name);
        }
    }

    void declare(NetlistName name) {
        declared_.push_back(name.name);
        visible_[name.name].push_back(syntax_.names.size());
        syntax_.uses.push_back({name.at, syntax_.names.size()});
        syntax_.names.push_back(std::move(name));
    }

    NetlistName* visible(std::string_view name) {
        const auto found = visible_.find(name);
        return found == visible_.end() || found->second.empty() ? nullptr : &syntax_.names[found->second.back()];
    }

    void leave(std::size_t mark) {
        for (; declared_.size() > mark; declared_.pop_back())
            visible_[declared_.back()].pop_back();
    }

    void use(const std::string& name, const Location& at) {
        if (const auto found = visible_.find(name); found != visible_.end() && !found->second.empty())
            syntax_.uses.push_back({at, found->second.back()});
    }

    NetlistSyntax& syntax_;
    std::map<std::string, std::vector<std::size_t>, std::less<>> visible_; ///< indices of names, the innermost last
    std::vector<std::string> declared_;                                    ///< in order, for leave()
    std::map<std::string, std::string> texts_;                             ///< vals that are strings
    std::string default_program_;
    NetlistName defaults_; ///< interface that `process (...);` states for the processes that follow
};

bool is_before(const Location& a, const Location& b) { return std::tie(a.line, a.column) < std::tie(b.line, b.column); }

} // namespace

const NetlistName* NetlistSyntax::name_at(const Location& at) const {
    for (const NetlistNameUse& each : uses) {
        const std::size_t end = each.at.column + names[each.name].name.size();
        if (each.at.file == at.file && each.at.line == at.line && each.at.column <= at.column && at.column <= end)
            return &names[each.name];
    }
    return nullptr;
}

const NetlistName* NetlistSyntax::find(std::string_view name) const {
    const auto found = std::find_if(names.rbegin(), names.rend(), [&](const auto& each) { return each.name == name; });
    return found == names.rend() ? nullptr : &*found;
}

NetlistSyntax read_syntax(std::shared_ptr<const SourceFile> file, std::vector<std::filesystem::path> include_folders) {
    NetlistSyntax syntax{.file = file, .tokens = tokens_of(file)};
    Reporter reporter;
    TokenStream tokens(file, file->path(), reporter, std::move(include_folders));
    try {
        syntax.statements = Parser(tokens, reporter).parse_netlist();
    } catch (const GiveUp&) {
        // the last diagnostic states the reason
    }
    syntax.included = tokens.take_included();
    syntax.diagnostics = reporter.take();
    NameWalk walk(syntax);
    return syntax;
}

std::vector<Token> tokens_of(const std::shared_ptr<const SourceFile>& file) {
    std::vector<Token> tokens;
    Reporter ignored;
    Lexer lexer(file, ignored);
    try {
        do {
            tokens.push_back(lexer.next());
            tokens.back().end = lexer.here();
            if (tokens.back().kind != TokenKind::directive)
                continue;
            if (auto name = lexer.read_file_name()) {
                name->end = lexer.here();
                tokens.push_back(std::move(*name));
            }
        } while (tokens.back().kind != TokenKind::end);
    } catch (const GiveUp&) { // the text has too many errors
        tokens.push_back({.kind = TokenKind::end, .text = "", .integer = {}, .real = 0, .at = lexer.here()});
    }
    return tokens;
}

std::optional<std::size_t> token_at(const std::vector<Token>& tokens, const Location& at) {
    const auto behind =
        std::ranges::partition_point(tokens, [&](const Token& each) { return !is_before(at, each.at); });
    if (behind == tokens.begin())
        return std::nullopt;
    const auto found = std::prev(behind);
    const bool touches = !is_before(found->end, at) && found->kind != TokenKind::end;
    return touches ? std::optional(static_cast<std::size_t>(found - tokens.begin())) : std::nullopt;
}

} // namespace placedpar
