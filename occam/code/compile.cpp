#include "occam/code/compile.hpp"

#include "occam/check/checker.hpp"

#include "occam/code/generator.hpp"
#include "occam/code/workspaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace placedpar::occam {

using transputer::Operation;

namespace {

constexpr std::uint64_t most_bytes_of_program = std::uint64_t{1} << 31;
constexpr const char* end_of_program = "the end of the program";

bool is_array_of_integers(const Type& type) {
    return type.kind == Type::Kind::array && !type.count && type.element->is(Basic::integer);
}

} // namespace

/// Makes code for a declaration outside of all procedures. Ignores the channels of a configuration, since they join
/// programs and are not part of one.
void Generator::declare_outermost(const Declaration& d) {
    const bool has_place = std::holds_alternative<Variable>(d.form) && innermost(*d.type).kind != Type::Kind::timer;
    if (has_place && !program_.is_configuration)
        refuse(d.at, fmt::format("the variable or channel \"{}\" is declared outside of all PROCs: move it into a PROC",
                                 d.name));
    if (!has_place)
        declare(d);
}

/// Generates a program that calls the main procedure. Its channels to the host are those of link 0; its free memory is
/// after the memory for arrays (vector space).
Code Generator::generate(const Declaration& main) {
    declare_library();
    for (const std::unique_ptr<Unit>& unit : program_.units)
        for (const DeclarationBox& each : unit->declarations)
            declare_outermost(*each);
    for (const DeclarationBox& each : program_.declarations)
        declare_outermost(*each);
    main_ = &main;
    Routine& routine = routine_of(main);
    Level& level = levels_.emplace_back(nullptr);
    level.main.need_below(3);
    level.link = level.vector = level.main.allocate(1);
    const Label entry = emitter_.new_label();
    const std::int64_t memory = (routine.level->vector_most + 3) / 4;
    generate_level(level, entry, "start", [&] {
        emitter_.address(end_of_code);
        count(1);
        store(level.vector);
        Arguments words;
        for (const DeclarationBox& each : std::get<Procedure>(main.form).parameters)
            add_main_argument(words, *each, memory);
        const bool tells_host = words.empty() && options_.ends_run;
        call_with(routine, std::move(words));
        if (tells_host)
            end_run();
        op(Operation::stopp);
        emitter_.name(end_of_program);
    });
    std::vector<const CodeBuffer*> buffers;
    for (const CodeBuffer& each : buffers_)
        buffers.push_back(&each);
    Code code = emitter_.finish(buffers, entry);
    code.end = std::ranges::find(code.names, end_of_program, &CodeName::name)->offset;
    code.workspace_words = static_cast<std::uint64_t>(level.main.words() + level.main.below);
    code.first_workspace_words = static_cast<std::uint64_t>(level.main.words());
    code.workspaces = workspaces_of(level.main, main.name);
    code.channels = channels_of_main(main, -words_of_call - routine.level->main.words());
    code.vector_space_bytes = static_cast<std::uint64_t>(memory * 4);
    if (4 * code.workspace_words + code.bytes.size() + code.vector_space_bytes > most_bytes_of_program)
        refuse(main.at, fmt::format("the program needs {} bytes of workspace and {} bytes of vector space, more than a "
                                    "transputer can have",
                                    4 * code.workspace_words, code.vector_space_bytes));
    return code;
}

/// Returns the channels that the main procedure declares. `base` is the workspace pointer of this procedure, in words
/// from the first workspace pointer of the program.
std::vector<CodeChannel> Generator::channels_of_main(const Declaration& main, std::int64_t base) const {
    std::vector<CodeChannel> channels;
    const auto* const scope = std::get_if<Scope>(&std::get<Procedure>(main.form).body->form);
    for (std::size_t i = 0; scope && i < scope->declarations.size(); ++i)
        if (const Declaration& each = *scope->declarations[i];
            std::holds_alternative<Variable>(each.form) && each.type->kind == Type::Kind::channel) {
            const Storage& storage = bindings_.at(&each);
            const bool is_placed = storage.base == Storage::Base::absolute;
            channels.push_back(
                {is_placed ? storage.offset / 4 : base + coordinate_of(storage.cell), is_placed, each.name});
        }
    return channels;
}

/// Generates an output to the host: the request that ends a run with success, as so.exit of the library hostio sends
/// it.
void Generator::end_run() {
    constexpr std::array<std::uint8_t, 10> request = {8,    0,    35, 0xff, 0xc9,
                                                      0x9a, 0x3b, 0,  0,    0}; // result 999999999: success
    address({.base = Storage::Base::constant, .label = emitter_.constant(request, true), .type = basic(Basic::byte)});
    op(Operation::mint);
    constant(request.size());
    op(Operation::out);
    stack_ = 0;
}

void Generator::add_main_argument(Arguments& words, const Declaration& parameter, std::int64_t memory) {
    if (carries_host_protocol(*parameter.type) && words.size() < 2) {
        const bool is_input = words.empty();
        words.push_back({1, [this, is_input] {
                             op(Operation::mint);
                             if (is_input)
                                 op(Operation::ldnlp, 4);
                         }});
    } else if (words.size() == 2 && is_array_of_integers(*parameter.type)) {
        words.push_back({1, [this, memory] {
                             load(level_->vector);
                             add_offset(4 * memory);
                         }});
        words.push_back({1, [this] { constant(bytes_of_free_memory / 4); }});
    } else {
        refuse(parameter.at, "the main procedure cannot have this parameter: write (), (CHAN OF SP fs, ts), (CHAN OF "
                             "SP fs, ts, []INT memory), or (CHAN OF BYTE keyboard, screen, error)");
    }
}

ErrorMode error_mode(std::string_view name) {
    constexpr std::array<std::string_view, 3> names = {"halt", "stop", "universal"};
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw std::invalid_argument("no error mode has this name");
    return static_cast<ErrorMode>(found - names.begin());
}

Code compile(const Program& program, const Declaration& main, const CodeOptions& options) {
    return Generator(program, options).generate(main);
}

} // namespace placedpar::occam
