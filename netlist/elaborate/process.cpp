#include "netlist/elaborate/elaborator.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

template <typename Entries>
void check_unique(const Entries& entries, const Declarator& declarator, Reporter& reporter) {
    const auto* known = find_named(entries, declarator.name);
    if (known == nullptr)
        return;
    reporter.error(declarator.at, fmt::format("\"{}\" is twice in the interface", declarator.name), "",
                   {{"first declared here", known->at}});
    throw StatementRefused{};
}

/// Channel ends and parameters, elements of arrays one by one.
std::size_t entry_count(const Interface* interface) {
    std::size_t count = 0;
    if (interface == nullptr)
        return count;
    for (const auto& port : interface->ports)
        count += element_count(port.dimensions);
    for (const auto& parameter : interface->parameters)
        count += element_count(parameter.dimensions);
    return count;
}

} // namespace

std::shared_ptr<const Interface> Elaborator::interface(const std::vector<InterfaceEntry>& entries) {
    auto result = std::make_shared<Interface>();
    if (entries.size() > most_interface_entries)
        refuse(entries[most_interface_entries].declarator.at,
               fmt::format("the interface is too large: it may have {} entries", most_interface_entries));
    for (const auto& entry : entries) {
        check_unique(result->ports, entry.declarator, reporter_);
        check_unique(result->parameters, entry.declarator, reporter_);
        auto sizes = dimensions(entry.declarator);
        if (const auto* direction = std::get_if<Direction>(&entry.type)) {
            result->ports.push_back({entry.declarator.name, *direction, std::move(sizes), entry.declarator.at});
            continue;
        }
        std::optional<Constant> default_value;
        if (entry.default_value)
            default_value = evaluator_.evaluate(*entry.default_value);
        result->parameters.push_back({entry.declarator.name, std::get<std::string>(entry.type), std::move(sizes),
                                      std::move(default_value), entry.declarator.at});
    }
    return result;
}

void Elaborator::perform(const ProcessDeclaration& form, const Location&) {
    auto settings = evaluate_attributes(evaluator_, reporter_, form.attributes.attributes);
    DraftProcess pattern;
    pattern.interface = default_interface_;
    if (form.attributes.interface)
        pattern.interface = interface(*form.attributes.interface);
    for (const auto* list : {&process_defaults_, &settings})
        apply_process_attributes(pattern, *list);
    if (form.names.empty()) {
        process_defaults_.insert(process_defaults_.end(), settings.begin(), settings.end());
        default_interface_ = pattern.interface;
    }
    for (const auto& name : form.names)
        declare_process(name, pattern);
}

void Elaborator::apply_process_attributes(DraftProcess& pattern, const std::vector<Setting>& settings) {
    for (const auto& setting : settings) {
        if (!is_process_attribute(setting.name))
            refuse(setting.at, fmt::format("a process has no attribute \"{}\"", setting.name),
                   did_you_mean(setting.name, process_attribute_names()));
        apply_process_attribute(pattern, setting, reporter_);
    }
}

void Elaborator::declare_process(const Declarator& name, const DraftProcess& pattern) {
    auto add = [&](std::string unique) {
        auto process = pattern;
        process.name = std::move(unique);
        process.declared = name.at;
        draft_.processes.push_back(std::move(process));
    };
    auto weight = 1 + entry_count(pattern.interface.get()) + pattern.other.size();
    declare(name, Category::process, draft_.processes.size(), add, weight);
}

void Elaborator::perform(const ParameterSetting& form, const Location&) {
    auto found = find(form.process);
    if (!form.process.field.empty())
        refuse(form.process.field_at, "attributes belong to a whole process", "name (parameter = value);");
    auto range = elements(form.process, found);
    auto settings = evaluate_attributes(evaluator_, reporter_, form.values);
    if (found.category == Category::connection) {
        for (std::size_t i = 0; i < range.count; ++i)
            apply_connection_attributes(draft_.connections[range.first + i], settings, reporter_);
        return;
    }
    if (found.category != Category::process)
        refuse(form.process.at, fmt::format("\"{}\" is no process and no connection: its attributes stand where it is "
                                            "declared",
                                            form.process.name));
    count_things(range.count * settings.size(), form.process.at);
    for (std::size_t i = 0; i < range.count; ++i) {
        auto& process = draft_.processes[range.first + i];
        process.settings.insert(process.settings.end(), settings.begin(), settings.end());
    }
}

void Elaborator::perform(const UseStatement& form, const Location& at) {
    auto program = evaluator_.text(*form.program, "the program in use");
    if (program.empty())
        refuse(form.program->at, "the name of the program is empty");
    if (!form.process) {
        draft_.default_kind = program;
        draft_.default_used = at;
        return;
    }
    auto found = find(*form.process);
    if (found.category != Category::process)
        refuse(form.process->at, fmt::format("\"{}\" is no process", form.process->name),
               "use \"program\" for process;");
    auto range = elements(*form.process, found);
    for (std::size_t i = 0; i < range.count; ++i) {
        auto& process = draft_.processes[range.first + i];
        if (process.used)
            refuse(form.process->at, fmt::format("the process \"{}\" is given a program twice", process.name), "",
                   {{"first given here", *process.used}});
        process.kind = program;
        process.used = at;
    }
}

} // namespace placedpar
