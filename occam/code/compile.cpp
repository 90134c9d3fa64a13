#include "occam/code/compile.hpp"

#include "occam/check/checker.hpp"

#include "occam/code/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace placedpar::occam {

using transputer::Operation;

namespace {

/// The words of an array `[]INT memory` that a main procedure gets.
constexpr std::int64_t words_of_free_memory = 64 * 1024;

constexpr std::uint64_t most_bytes_of_program = std::uint64_t{1} << 31;
constexpr const char* end_of_program = "the end of the program";

bool is_array_of_integers(const Type& type) {
    return type.kind == Type::Kind::array && !type.count && type.element->is(Basic::integer);
}

/// Adds the components of the only PAR of a frame, and of PARs that are components themselves. `base`: the workspace
/// pointer of the procedure, in words from the first one.
void add_workspaces(const Frame& frame, std::int64_t base, std::vector<CodeWorkspace>& to) {
    if (frame.parallels.size() != 1)
        return;
    for (const Frame* each : frame.parallels.front()) {
        const std::int64_t at = base + each->coordinate;
        if (each->is_parallel && each->parallels.size() == 1)
            add_workspaces(*each, base, to);
        else
            to.push_back({at - each->below, at + each->words(), each->name, each->place, each->entry});
    }
}

/// Tells instances of one PROC apart by their places.
void make_names_unique(std::vector<CodeWorkspace>& workspaces) {
    std::map<std::string, int> counts;
    for (const CodeWorkspace& each : workspaces)
        ++counts[each.name];
    for (CodeWorkspace& each : workspaces)
        if (counts[each.name] > 1)
            each.name += " " + each.place;
}

} // namespace

/// Declares what stands outside of all procedures. The channels of a configuration are not of a program.
void Generator::declare_outermost(const Declaration& d) {
    const bool has_place = std::holds_alternative<Variable>(d.form) && innermost(*d.type).kind != Type::Kind::timer;
    if (has_place && !program_.is_configuration)
        refuse(d.at, fmt::format("the variable or channel \"{}\" is declared outside of all PROCs", d.name));
    if (!has_place)
        declare(d);
}

/// Calls the main procedure with the channels of link 0 and with free memory behind the vector space.
Code Generator::generate(const Declaration& main) {
    for (const DeclarationBox& each : program_.routines)
        declare(*each);
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
    const std::int64_t base = -4 - routine.level->main.words();
    add_workspaces(routine.level->main, base, code.workspaces);
    code.channels = channels_of_main(main, base);
    make_names_unique(code.workspaces);
    code.vector_space_bytes = static_cast<std::uint64_t>(memory * 4);
    if (4 * code.workspace_words + code.bytes.size() + code.vector_space_bytes > most_bytes_of_program)
        refuse(main.at, fmt::format("the program needs {} bytes of workspace and {} of vector space, more than a "
                                    "transputer can have",
                                    4 * code.workspace_words, code.vector_space_bytes));
    return code;
}

/// `base`: the workspace pointer of the procedure, in words from the first one.
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

/// Sends the host the request that ends a run with success, as so.exit does.
void Generator::end_run() {
    constexpr std::array<std::uint8_t, 10> request = {8, 0, 35, 0xff, 0xc9, 0x9a, 0x3b, 0, 0, 0}; // 999999999
    address({.base = Storage::Base::constant, .label = emitter_.constant(request, true), .type = basic(Basic::byte)});
    op(Operation::mint);
    constant(request.size());
    op(Operation::out);
    stack_ = 0;
}

void Generator::add_main_argument(Arguments& words, const Declaration& parameter, std::int64_t memory) {
    const bool is_channel = parameter.type->kind == Type::Kind::channel;
    if (is_channel && words.size() < 2) {
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
        words.push_back({1, [this] { constant(words_of_free_memory); }});
    } else {
        refuse(parameter.at, "the main procedure cannot have this parameter; it has (CHAN OF SP fs, ts), perhaps with "
                             "[]INT memory behind these, or none");
    }
}

Code compile(const Program& program, const Declaration& main, const CodeOptions& options) {
    return Generator(program, options).generate(main);
}

} // namespace placedpar::occam
