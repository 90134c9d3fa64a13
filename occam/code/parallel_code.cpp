#include "occam/code/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar::occam {

using transputer::Operation;

namespace {

void name_component(Frame& frame, const Process& p) {
    const Process* inner = &p;
    while (const auto* scope = std::get_if<Scope>(&inner->form))
        inner = scope->process.get();
    const auto* instance = std::get_if<Instance>(&inner->form);
    frame.place = fmt::format("{}:{}", inner->at.line, inner->at.column);
    frame.name = instance ? instance->name : frame.place;
    frame.is_instance = instance != nullptr;
    frame.is_parallel = std::holds_alternative<Parallel>(inner->form);
    frame.need_below(words_of_scheduler);
}

} // namespace

Frame& Generator::new_component(const Process& p) {
    Frame& frame = level_->components.emplace_back(*level_);
    name_component(frame, p);
    return frame;
}

void Generator::parallel(const Process& p, const Parallel& each) {
    if (each.kind == Parallel::Kind::placed)
        refuse(p.at, "PLACED PAR places processes on a network, but a program for one transputer has no network");
    if (each.replicator)
        return replicated_parallel(p, each);
    if (each.kind == Parallel::Kind::priority)
        return priority_parallel(each);
    if (each.processes.empty())
        return;
    const Label done = emitter_.new_label();
    join(done, static_cast<std::int64_t>(each.processes.size()));
    std::vector<Frame*> frames;
    std::vector<Label> starts;
    for (std::size_t i = 0; i < each.processes.size(); ++i) {
        frames.push_back(&new_component(each.processes[i]));
        starts.push_back(emitter_.new_label());
        if (i == 0)
            continue;
        const Label here = emitter_.new_label();
        emitter_.difference(starts[i], here);
        load_base_of(*frames[i]);
        op(Operation::startp);
        mark(here);
    }
    Frame& parent = *frame_;
    const Kept vector(level_->vector_now);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i]->entry = fmt::format("{}PAR {}:{}", path_, each.processes[i].at.line, i);
        emitter_.name(frames[i]->entry);
        if (i == 0)
            adjust(parent, *frames[0]);
        else
            mark(starts[i]);
        component(each.processes[i], *frames[i], parent);
    }
    parent.parallels.push_back(frames);
    mark(done);
    clear_error();
}

/// Stores the two words that the instruction endp uses: the address at which to continue after the PAR, and the number
/// of its processes.
void Generator::join(Label done, std::int64_t processes) {
    frame_->need_low(2);
    constant(processes);
    store({frame_, Cell::Area::low, 1});
    emitter_.address(done);
    count(1);
    store({frame_, Cell::Area::low, 0});
}

void Generator::load_base_of(Frame& frame) {
    emitter_.put(Operation::ldlp, Cell{&frame, Cell::Area::base, 0}, *frame_);
    stack_ = 1;
}

void Generator::adjust(Frame& from, Frame& to) { emitter_.put(Operation::ajw, Cell{&to, Cell::Area::base, 0}, from); }

/// Generates the code of a component of a PAR, with its own workspace (frame) and with the instruction endp at its end.
void Generator::component(const Process& p, Frame& frame, Frame& parent) {
    const std::int64_t most = std::exchange(level_->vector_most, level_->vector_now);
    {
        const Kept current(frame_, &frame);
        stack_ = 0;
        clear_error();
        process(p);
        load_base_of(parent);
        op(Operation::endp);
    }
    stack_ = 0;
    level_->vector_now = level_->vector_most;
    level_->vector_most = std::max(level_->vector_most, most);
}

/// Generates a PRI PAR. The process starts the component of high priority, and itself becomes the component of low
/// priority. The component that ends last continues after the PAR. If this is the component of high priority, it first
/// changes to low priority.
void Generator::priority_parallel(const Parallel& each) {
    const Label done = emitter_.new_label(), start = emitter_.new_label(), low = emitter_.new_label();
    join(done, is_main_ && !options_.awaits_high ? 1 : 2);
    Frame& parent = *frame_;
    const std::vector<Frame*> frames = {&new_component(each.processes[0]), &new_component(each.processes[1])};
    emitter_.address(start);
    count(1);
    emitter_.put(Operation::stl, Cell{frames[0], Cell::Area::base, 0}, parent, -1);
    load_base_of(*frames[0]);
    op(Operation::runp);
    const Kept vector(level_->vector_now);
    adjust(parent, *frames[1]);
    component(each.processes[1], *frames[1], parent);
    mark(start);
    component(each.processes[0], *frames[0], parent);
    parent.parallels.push_back(frames);
    parent.need_below(words_of_scheduler);
    mark(done);
    op(Operation::ldpri);
    op(Operation::eqc, 0);
    jump_if_false(low);
    load_base_of(parent);
    op(Operation::adc, 1);
    op(Operation::runp);
    op(Operation::stopp);
    mark(low);
    stack_ = 0;
    clear_error();
}

/// Generates a replicated PAR, with the same code for all components. The addresses of their workspaces are known only
/// at run time. A component therefore finds the variables outside of the PAR by a pointer to the enclosing frame.
void Generator::replicated_parallel(const Process& p, const Parallel& each) {
    const Replicator& replicator = *each.replicator;
    const auto components = constant_of(replicator.count);
    if (!components)
        refuse(replicator.count.at, "the count of a replicated PAR must be known at compile time");
    if (*components <= 0)
        return;
    Level& level = levels_.emplace_back(level_);
    name_component(level.main, each.processes.front());
    level.link = level.main.allocate(1);
    level.vector = level.main.allocate(1);
    const Cell index = level.main.allocate(1);
    bindings_[replicator.index.get()] = {.cell = index, .type = replicator.index->type};
    const Label start = emitter_.new_label(), done = emitter_.new_label();
    Frame& parent = *frame_;
    generate_level(level, start, fmt::format("{}PAR {}", path_, p.at.line), [&] {
        process(each.processes.front());
        load(level.link);
        emitter_.put_remote(Operation::ldnlp, {&parent, Cell::Area::base, 0});
        op(Operation::endp);
    });
    parent.replications.push_back({&level, *components, constant_of(replicator.base)});
    join(done, *components);
    start_components(replicator, *components, level, index, start);
    op(Operation::stopp); // the component that ends last continues at `done`
    mark(done);
    clear_error();
}

/// Generates a loop that stores the parameters of each component in its workspace, and starts the component.
void Generator::start_components(const Replicator& replicator, std::int64_t components, Level& level, const Cell& index,
                                 Label start) {
    const std::int64_t words = level.main.words(), all = words + level.main.below;
    frame_->need_below(words_of_scheduler + components * all);
    const Cell control = temporary(2), workspace = temporary(), vector = temporary();
    expression(replicator.base);
    settle();
    store(control);
    constant(components);
    store(control.after(1));
    emitter_.put(Operation::ldlp, {frame_, Cell::Area::base, 0}, *frame_,
                 static_cast<int>(-words_of_scheduler - words));
    count(1);
    store(workspace);
    if (level.uses_vector) {
        load(level_->vector);
        add_offset(level_->vector_now);
        store(vector);
        level_->vector_most = std::max(level_->vector_most, level_->vector_now + components * level.vector_most);
    }
    const auto store_in_component = [&](const Cell& cell, const auto& load_value) {
        if (!level.main.is_used(cell))
            return; // a word that no code uses has no place in the workspace
        load_value();
        load(workspace);
        op(Operation::stnl, coordinate_of(cell));
    };
    loop(control, emitter_.new_label(), [&] {
        store_in_component(level.link, [&] { load_frame_of(*level_); });
        store_in_component(index, [&] { load(control); });
        if (level.uses_vector) {
            store_in_component(level.vector, [&] { load(vector); });
            load(vector);
            add_offset(level.vector_most);
            store(vector);
        }
        const Label here = emitter_.new_label();
        emitter_.difference(start, here);
        count(1);
        load(workspace);
        op(Operation::startp);
        mark(here);
        stack_ = 0;
        load(workspace);
        op(Operation::ldnlp, -all);
        store(workspace);
    });
    frame_->need_low(2);
}

/// Generates the code of a procedure or of a component of a replicated PAR. The first instructions are generated after
/// the body, since they depend on how many words the body uses.
void Generator::generate_level(Level& level, Label start, std::string name, const std::function<void()>& body) {
    CodeBuffer& head = buffers_.emplace_back();
    CodeBuffer& rest = buffers_.emplace_back();
    const Kept current(level_, &level);
    const Kept frame(frame_, &level.main);
    const Kept weight(weight_, 1.0);
    const Kept stack(stack_, 0);
    const Kept checked(checked_, false);
    const Kept enabled(guards_are_enabled_, false);
    const Kept path(path_, name + "/");
    level.table = level.main.allocate(1);
    const bool is_called = level.link.area == Cell::Area::link;
    CodeBuffer* const before = emitter_.redirect(&rest);
    const Place place = emitter_.place();
    emitter_.line(place);
    clear_error();
    body();
    emitter_.redirect(&head);
    emitter_.line(place);
    emitter_.name(std::move(name));
    mark(start);
    if (is_called)
        emitter_.put_words(Operation::ajw, level.main, -1);
    if (level.uses_table)
        load_table(level);
    emitter_.redirect(before);
    level.lay_out();
}

/// Loads the address of the table of constants that are too large for the operand of a short instruction.
void Generator::load_table(Level& level) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t word : level.constants)
        for (int i = 0; i < 4; ++i)
            bytes.push_back(static_cast<std::uint8_t>(word >> 8 * i));
    emitter_.address(emitter_.constant(bytes, true));
    emitter_.put(Operation::stl, level.table, level.main);
}

} // namespace placedpar::occam
