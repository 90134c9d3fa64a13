#include "occam/code/generator.hpp"

#include <algorithm>
#include <iterator>

namespace placedpar::occam {

using transputer::Operation;

void Generator::declare_routine(const Declaration& d) {
    auto routine = std::make_unique<Routine>();
    routine->outer = level_;
    routine->path = path_;
    routines_[&d] = std::move(routine);
}

/// Returns the Routine of a procedure or function. The first call generates its code.
Generator::Routine& Generator::routine_of(const Declaration& d) {
    Routine& routine = *routines_.at(&d);
    if (!routine.level) {
        routine.level = &levels_.emplace_back(routine.outer);
        generate_routine(d, routine);
    }
    return routine;
}

bool Generator::returns_in_register(const Function& f) const {
    return f.result_types.size() == 1 && (is_word(*f.result_types.front()) || is_real(*f.result_types.front()));
}

void Generator::generate_routine(const Declaration& d, Routine& routine) {
    Level& level = *routine.level;
    level.main.need_below(3);
    routine.entry = emitter_.new_label();
    const auto* procedure = std::get_if<Procedure>(&d.form);
    const auto* function = std::get_if<Function>(&d.form);
    const Kept path(path_, routine.path);
    const Kept is_main(is_main_, &d == main_);
    const Kept is_library(is_library_, !routine.errors.empty());
    const Placed placed(emitter_, d.at);
    generate_level(level, routine.entry, routine.path + d.name, [&] {
        bind_parameters(procedure ? procedure->parameters : function->parameters, level);
        if (procedure)
            process(*procedure->body);
        else
            return_results(*function, level);
        emitter_.put_words(Operation::ajw, level.main, 1);
        emitter_.put(Operation::ret);
    });
}

void Generator::bind_parameters(const std::vector<DeclarationBox>& parameters, Level& level) {
    const auto next = [&] { return Cell{&level.main, Cell::Area::parameter, level.parameters++}; };
    for (const DeclarationBox& each : parameters) {
        const Type& type = plain(*each->type);
        const bool is_value = std::get<Parameter>(each->form).passing == Parameter::Passing::value;
        if (type.kind == Type::Kind::timer)
            continue;
        Storage location{.base = Storage::Base::pointer, .cell = next(), .type = each->type};
        if (is_value && type.kind == Type::Kind::basic && bytes_of(type.basic) <= 4) {
            location.base = Storage::Base::cell;
            location.is_scalar = bytes_of(type.basic) < 4;
        }
        for (const Type* dimension = &type; dimension->kind == Type::Kind::array;
             dimension = &plain(*dimension->element))
            if (!dimension->count)
                location.extents.push_back({std::nullopt, next()});
        bindings_[each.get()] = location;
    }
}

/// Leaves the result of a function in a register, or stores the results at the caller's addresses.
void Generator::return_results(const Function& f, Level& level) {
    const bool in_register = returns_in_register(f);
    std::vector<Storage> targets;
    for (const Type* type : f.result_types)
        if (!in_register)
            targets.push_back({.base = Storage::Base::pointer,
                               .cell = {&level.main, Cell::Area::parameter, level.parameters++},
                               .type = type});
    value_process(f.body, [&] {
        if (f.body.results.size() == 1 && targets.size() > 1) {
            if (std::holds_alternative<Call>(f.body.results.front().form))
                return call_function(f.body.results.front(), targets);
            const auto& values = std::get<ValueProcess>(f.body.results.front().form);
            return value_process(values, [&] {
                for (std::size_t i = 0; i < targets.size(); ++i)
                    assign_to(values.results[i], targets[i]);
            });
        }
        for (std::size_t i = 0; i < targets.size(); ++i)
            assign_to(f.body.results[i], targets[i]);
        if (!in_register)
            return;
        stack_ = 0;
        if (f.body.process)
            clear_error();
        if (is_real(*f.result_types.front())) {
            real(f.body.results.front());
            check_reals();
        } else {
            expression(f.body.results.front());
        }
        settle();
    });
}

// Calls

void Generator::instance(const Process& p, const Instance& i) {
    if (std::holds_alternative<Predefined>(i.meaning->form))
        return predefined_instance(p, i);
    call(*i.meaning, pointers_to(i.arguments), {});
    clear_error();
}

std::vector<const Expression*> Generator::pointers_to(const std::vector<Expression>& expressions) {
    std::vector<const Expression*> pointers;
    for (const Expression& each : expressions)
        pointers.push_back(&each);
    return pointers;
}

/// Calls a procedure or function. Passes the arguments, then the words of `more`, then the addresses of the results.
void Generator::call(const Declaration& d, const std::vector<const Expression*>& arguments,
                     const std::vector<Storage>& results, Arguments more) {
    Routine& routine = routine_of(d);
    const auto* procedure = std::get_if<Procedure>(&d.form);
    const auto& parameters = procedure ? procedure->parameters : std::get<Function>(d.form).parameters;
    Arguments words;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        add_argument(words, *parameters[i], *arguments[i]);
    std::ranges::move(more, std::back_inserter(words));
    for (const Storage& each : results)
        words.push_back({1, [this, each] { address(each); }});
    call_with(routine, std::move(words));
}

void Generator::add_argument(Arguments& words, const Declaration& parameter, const Expression& e) {
    const Type& type = plain(*parameter.type);
    const bool is_value = std::get<Parameter>(parameter.form).passing == Parameter::Passing::value;
    if (type.kind == Type::Kind::timer)
        return;
    if (type.kind == Type::Kind::channel) {
        words.push_back({depth_of_channel(e), [this, &e] { channel(e); }});
    } else if (is_value && type.kind == Type::Kind::basic && bytes_of(type.basic) <= 4) {
        add_value(words, e);
    } else if (const auto* table = std::get_if<TableLiteral>(&e.form); table && is_channel(type)) {
        add_pointer(words, channel_table(*table, *e.type), type);
    } else if (!is_value && fixed_size(type)) {
        words.push_back({depth_of_location(e), [this, &e] { address(locate(e)); }});
    } else {
        add_pointer(words, is_channel(type) || !is_value ? locate(e) : value_in_memory(e), type);
    }
}

/// Makes an array of pointers to the channels of a table such as [c, d], so that the channels can be passed as an
/// array.
Storage Generator::channel_table(const TableLiteral& table, const Type& type) {
    Storage pointers =
        in_workspace(*array_of(*basic(Basic::integer), static_cast<std::uint32_t>(table.elements.size())));
    for (std::size_t i = 0; i < table.elements.size(); ++i) {
        Storage pointer = pointers;
        pointer.offset += 4 * static_cast<std::int64_t>(i);
        pointer.type = basic(Basic::integer);
        channel(table.elements[i]);
        store(pointer);
    }
    pointers.type = &type;
    return pointers;
}

/// Adds an argument that is passed by value and has at most four bytes.
void Generator::add_value(Arguments& words, const Expression& e) {
    if (is_word(*e.type)) {
        words.push_back({depth_of(e), [this, &e] { expression(e); }});
    } else if (const auto bits = constant_of(e)) {
        words.push_back({1, [this, bits] { constant(*bits); }});
    } else {
        const Storage location = pointer_to(value_in_memory(e));
        words.push_back({1, [this, location] { load_bits(location); }});
    }
}

/// Adds the address of a value as an argument. For each dimension whose size the parameter leaves open, also adds the
/// number of elements.
void Generator::add_pointer(Arguments& words, Storage location, const Type& parameter) {
    location = pointer_to(location);
    stack_ = 0;
    words.push_back({1, [this, location] { address(location); }});
    for (const Type* dimension = &parameter; dimension->kind == Type::Kind::array;
         dimension = &plain(*dimension->element)) {
        const Extent extent = outer_extent(location);
        if (!dimension->count)
            words.push_back({1, [this, extent] { load_extent(extent); }});
        if (!plain(*location.type).count)
            location.extents.erase(location.extents.begin());
        location.type = plain(*location.type).element;
    }
}

/// Loads all arguments, including hidden ones such as the address of the enclosing frame, and calls the routine. The
/// first three words are in registers.
void Generator::call_with(Routine& routine, Arguments words) {
    const Level& level = *routine.level;
    const std::int64_t vector_now = level_->vector_now;
    if (level.uses_link)
        words.insert(words.begin(), {1, [this, &level] { load_frame_of(*level.outer); }});
    if (level.uses_vector) {
        level_->uses_vector = true;
        words.push_back({1, [this, vector_now] {
                             load(level_->vector);
                             add_offset(vector_now);
                         }});
    }
    level_->vector_most = std::max(level_->vector_most, vector_now + level.vector_most);
    const int low = std::max(static_cast<int>(words.size()) - 3, 0);
    for (std::size_t i = 0; i < words.size(); ++i) {
        stack_ = 0;
        // If an argument needs three registers, it may contain a call. This call would overwrite arguments that are
        // already in memory.
        if (words[i].depth <= (low > 0 ? std::min(static_cast<int>(i) + 1, 2) : static_cast<int>(i) + 1))
            continue;
        words[i].load();
        const Cell saved = temporary();
        settle();
        store(saved);
        words[i] = {1, [this, saved] { load(saved); }};
    }
    const int moved = words_moved(low);
    if (moved == 0)
        frame_->need_low(low);
    for (int i = low; i-- > 0;) {
        stack_ = 0;
        words[static_cast<std::size_t>(i) + 3].load();
        settle();
        if (moved == 0)
            store({frame_, Cell::Area::low, i});
        else
            op(Operation::stl, i - moved);
    }
    stack_ = 0;
    for (std::size_t i = std::min<std::size_t>(words.size(), 3); i-- > 0;)
        words[i].load();
    settle();
    if (moved == 0)
        frame_->need_low(low); // a second call, for temporaries that the loading of the words has allocated
    call_moved(routine.entry, moved, {routine.errors, {}});
    stack_ = 0;
    frame_->need_below(level.need() + moved);
    if (level.main.starters() > 0 && std::ranges::find(frame_->calls, &level) == frame_->calls.end())
        frame_->calls.push_back(&level);
}

/// Returns by how many words the workspace pointer is moved down for a call with `low` words of arguments in memory.
/// Between the instructions alt and altend, the words below the workspace pointer hold the state of the ALT, which a
/// call at the usual place would overwrite.
int Generator::words_moved(int low) const { return guards_are_enabled_ ? words_of_alternation + low : 0; }

/// Generates a call with the workspace pointer moved down by `moved` words. If reports show errors of the routine at
/// the place of the call, `errors` tells what an error means; otherwise its text is "".
void Generator::call_moved(Label entry, int moved, const ErrorText& errors) {
    if (moved > 0)
        op(Operation::ajw, -moved);
    emitter_.branch(Operation::call, entry);
    if (!errors.text.empty())
        fails(errors, moved);
    if (moved > 0)
        op(Operation::ajw, moved);
}

/// Calls a function. If `results` is empty, leaves the only result in a register.
void Generator::call_function(const Expression& e, const std::vector<Storage>& results) {
    const auto& c = std::get<Call>(e.form);
    const bool is_predefined = std::holds_alternative<Predefined>(c.meaning->form);
    if (is_predefined && predefined_call(e, c, results))
        return;
    const Declaration& called = is_predefined ? library_routine(e.at, c.name) : *c.meaning;
    const auto* function = std::get_if<Function>(&called.form); // null for a library routine that is a procedure
    const bool in_register = function && returns_in_register(*function);
    call(called, pointers_to(c.arguments), in_register ? std::vector<Storage>() : results);
    const bool is_word_result = in_register && is_word(*function->result_types.front());
    stack_ = is_word_result ? 1 : 0;
    if (!in_register)
        return clear_error();
    if (results.empty())
        return;
    if (is_word_result)
        store(results.front());
    else
        real_store(results.front());
}

} // namespace placedpar::occam
