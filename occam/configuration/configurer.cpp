#include "occam/configuration/configurer.hpp"

#include "occam/network/vals.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Limits the number of statements, repetitions and array elements of a configuration, so that replicators end in
/// reasonable time.
constexpr std::size_t most_steps = 1'000'000;

constexpr const char* allowed_in_network = "NETWORK can have only DO, IF, SET and CONNECT";
constexpr const char* allowed_in_mapping = "MAPPING can have only DO, IF and MAP";
constexpr const char* allowed_in_software =
    "a configuration can have only PAR, IF, PROCESSOR, and instances of PROCs; write a PROC for the rest";

} // namespace

Configurer::Configurer(Program& program, const ValChoice& choose, Reporter& reporter)
    : program_(program), choose_(choose), reporter_(reporter), checker_(program, reporter) {
    program_.has_channel_tables = program_.is_configuration = true;
}

/// Makes the names HOST, HIGH and LOW visible. A configuration may declare other things with these names.
void Configurer::add_predefined() {
    const auto add = [&](const std::string& name, const Type* type) -> Declaration& {
        Declaration& declaration = *program_.predefined.emplace_back(std::make_unique<Declaration>());
        declaration.name = name;
        declaration.form = ReplicatorIndex{};
        declaration.type = type;
        checker_.add(declaration);
        return declaration;
    };
    const Type* const edge = program_.types.hardware(Type::Kind::edge);
    selections_[&add("HOST", edge)] = {{new_object("HOST", edge, {}), 0, 1}};
    const Type* const integer = program_.types.basic(Basic::integer);
    add("HIGH", integer).constant = Constant{0, nullptr};
    add("LOW", integer).constant = Constant{1, nullptr};
}

Configured Configurer::run() {
    try {
        checker_.check_units();
        add_predefined();
        for (const DeclarationBox& each : program_.declarations)
            visit(*each), choose_val(program_, *each, choose_, reporter_);
        if (!has_config_)
            reporter_.error({program_.files.front(), 0, 0}, "the configuration has no CONFIG, so it places no process",
                            "write CONFIG, and below it PROCESSOR with an instance of a PROC");
        if (!reporter_.failed())
            check_whole();
    } catch (const GiveUp&) { // the last diagnostic states the reason
    }
    return std::move(configured_);
}

void Configurer::count_step(const Place& place) {
    if (++steps_ > most_steps)
        reporter_.give_up(at(place), fmt::format("the configuration is too large: it has more than {} elements and "
                                                 "statements, counting repetitions",
                                                 most_steps));
}

void Configurer::visit_all(std::vector<DeclarationBox>& declarations) {
    for (const DeclarationBox& each : declarations)
        visit(*each);
}

void Configurer::visit(Declaration& declaration) {
    count_step(declaration.at);
    if (auto* const part = std::get_if<ConfigurationPart>(&declaration.form))
        execute_part(declaration, *part);
    else if (auto* const placement = std::get_if<Placement>(&declaration.form))
        place(declaration, *placement);
    else
        declare(declaration);
}

void Configurer::declare(Declaration& declaration) {
    checker_.declare(declaration);
    const Type::Kind kind = innermost(*declaration.type).kind;
    const bool has_elements =
        kind == Type::Kind::channel || kind == Type::Kind::node || kind == Type::Kind::arc || kind == Type::Kind::edge;
    const auto* const abbreviation = std::get_if<Abbreviation>(&declaration.form);
    if (has_elements && abbreviation)
        selections_[&declaration] = selection_of(abbreviation->value);
    else if (has_elements && std::holds_alternative<Variable>(declaration.form))
        selections_[&declaration] = {
            {new_object(declaration.name, declaration.type, declaration.at), 0, count_of_elements(*declaration.type)}};
}

void Configurer::execute_part(Declaration& declaration, ConfigurationPart& part) {
    part_ = declaration.name == "NETWORK"   ? Part::network
            : declaration.name == "MAPPING" ? Part::mapping
                                            : Part::software;
    has_config_ |= part_ == Part::software;
    execute(*part.process);
}

void Configurer::execute(Process& process) {
    count_step(process.at);
    std::visit([&](auto& form) { form_of(process, form); }, process.form);
}

template <class Other>
void Configurer::form_of(Process& process, Other&) {
    refuse(process);
}

void Configurer::refuse(const Process& process) {
    const char* const allowed = part_ == Part::network   ? allowed_in_network
                                : part_ == Part::mapping ? allowed_in_mapping
                                                         : allowed_in_software;
    reporter_.error(at(process.at), "this statement is not allowed in a configuration", allowed);
}

void Configurer::form_of(Process&, Scope& scope) {
    const std::size_t mark = checker_.mark();
    visit_all(scope.declarations);
    execute(*scope.process);
    checker_.leave(mark);
}

void Configurer::form_of(Process& process, Sequence& sequence) {
    if (!sequence.is_do || part_ == Part::software)
        return refuse(process);
    repeat(sequence.replicator, [&] {
        for (Process& each : sequence.processes)
            execute(each);
        return true;
    });
}

void Configurer::form_of(Process& process, Parallel& parallel) {
    if (part_ != Part::software)
        return refuse(process);
    const bool is_priority = parallel.kind == Parallel::Kind::priority;
    if (is_priority && (!here_ || parallel.replicator || parallel.processes.size() != 2 || here_->has_priority_par))
        return reporter_.error(
            at(process.at),
            "a PRI PAR of a configuration must have two processes, and can be used once below each PROCESSOR",
            "the first process gets the high priority");
    const std::optional<CurrentProcessor> outer = here_;
    repeat(parallel.replicator, [&] {
        for (Process& each : parallel.processes) {
            if (is_priority) {
                here_->has_priority_par = true;
                here_->high_priority = &each == parallel.processes.data();
            }
            execute(each);
        }
        return true;
    });
    here_ = outer;
}

void Configurer::form_of(Process& process, If& conditional) {
    if (!execute_if(conditional))
        reporter_.error(at(process.at), "no condition of this IF is true", "write TRUE and SKIP as the last choice");
}

bool Configurer::execute_if(If& conditional) {
    bool found = false;
    repeat(conditional.replicator, [&] {
        found = execute_choices(conditional);
        return !found;
    });
    return found;
}

/// Executes the first choice whose condition is true. Returns true if a condition was true or had an error.
bool Configurer::execute_choices(If& conditional) {
    for (Choice& choice : conditional.choices) {
        const std::size_t mark = checker_.mark();
        visit_all(choice.declarations);
        bool is_true = false;
        if (choice.nested)
            is_true = execute_if(*choice.nested);
        else {
            checker_.constant_of_type(*choice.condition, program_.types.basic(Basic::boolean), "a condition");
            is_true = !choice.condition->constant || choice.condition->constant->bits != 0;
            if (choice.condition->constant && is_true)
                execute(*choice.process);
        }
        checker_.leave(mark);
        if (is_true)
            return true;
    }
    return false;
}

/// Executes a body once, or for each value of an index, until the body returns false.
void Configurer::repeat(std::optional<Replicator>& replicator, const std::function<bool()>& body) {
    if (!replicator) {
        body();
        return;
    }
    const auto base = constant(replicator->base, "the base of a replicator");
    const auto count = constant(replicator->count, "the count of a replicator");
    const auto step = replicator->step ? constant(*replicator->step, "the step of a replicator") : 1;
    if (!base || !count || !step)
        return;
    if (*count < 0)
        return reporter_.error(at(replicator->count.at), fmt::format("the count of this replicator is {}", *count),
                               "the count must be 0 or more");
    for (std::int64_t i = 0; i < *count; ++i) {
        count_step(replicator->index->at);
        const std::size_t mark = checker_.mark();
        replicator->index->type = program_.types.basic(Basic::integer);
        replicator->index->constant = Constant{static_cast<std::int32_t>(*base + i * *step), nullptr};
        checker_.add(*replicator->index);
        const bool goes_on = body();
        checker_.leave(mark);
        if (!goes_on)
            return;
    }
}

/// Returns the value of a constant expression of type INT. If the expression has another type or is not constant,
/// reports an error, and returns nothing.
std::optional<std::int64_t> Configurer::constant(Expression& expression, const std::string& role) {
    checker_.constant_of_type(expression, program_.types.basic(Basic::integer), role);
    if (!expression.constant || !expression.type->is(Basic::integer))
        return std::nullopt;
    return expression.constant->bits;
}

void Configurer::form_of(Process& process, Processor& processor) {
    if (part_ != Part::software)
        return refuse(process);
    if (here_)
        return reporter_.error(at(process.at), "a PROCESSOR cannot be within another PROCESSOR", "",
                               {{"the outer PROCESSOR is here", at(here_->at)}});
    const std::optional<Element> node = node_of(processor);
    if (!node)
        return;
    here_ = CurrentProcessor{.node = *node, .at = processor.number.at};
    execute(*processor.process);
    here_.reset();
}

void Configurer::form_of(Process& process, Instance& called) {
    if (part_ != Part::software)
        return refuse(process);
    instance(process, called);
}

void Configurer::form_of(Process& process, Wiring& wiring) {
    const bool is_map = std::holds_alternative<MapOnto>(wiring.form);
    if (part_ != (is_map ? Part::mapping : Part::network))
        return refuse(process);
    if (auto* const connection = std::get_if<Connect>(&wiring.form))
        connect(process.at, *connection);
    else if (auto* const setting = std::get_if<SetNode>(&wiring.form))
        set(*setting);
    else
        map(std::get<MapOnto>(wiring.form));
}

} // namespace placedpar::occam
