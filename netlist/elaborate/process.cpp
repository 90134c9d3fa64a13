#include "netlist/elaborate/elaborator.hpp"
#include "text/nearest.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace placedpar {

namespace {

template <typename Entries>
void check_unique(const Entries& entries, const Declarator& declarator, Reporter& reporter) {
    const auto* known = find_named(entries, declarator.name);
    if (known == nullptr)
        return;
    reporter.error(declarator.at, fmt::format("the interface has \"{}\" twice", declarator.name), "",
                   {{"first declared here", known->at}});
    throw StatementRefused{};
}

/// Returns the entry's first word: "input", "output", "int" ...
std::string word_for(const EntryType& type) {
    const auto* direction = std::get_if<Direction>(&type);
    return direction != nullptr ? word(*direction) : std::get<std::string>(type);
}

/// Counts the interface's channel ends and parameters; each element of an array counts.
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
               fmt::format("the interface is too large: at most {} entries are allowed", most_interface_entries));
    for (const auto& entry : entries) {
        check_unique(result->ports, entry.declarator, reporter_);
        check_unique(result->parameters, entry.declarator, reporter_);
        auto sizes = dimensions(entry.declarator);
        result->entries.push_back({word_for(entry.type), entry.declarator.name, sizes});
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

/// Adds an interface and settings to a type of processes. Checks them here, so that errors are reported where the type
/// is defined.
void Elaborator::extend(ProcessType& type, const std::vector<Setting>& settings,
                        const DeclarationAttributes& attributes) {
    DraftProcess scratch;
    apply_process_attributes(scratch, settings);
    type.settings.insert(type.settings.end(), settings.begin(), settings.end());
    if (attributes.interface)
        type.interface = interface(*attributes.interface);
}

void Elaborator::declare_processes(const ProcessType& type, const std::vector<Declarator>& names) {
    DraftProcess pattern;
    pattern.interface = type.interface ? type.interface : process_defaults_.interface;
    apply_process_attributes(pattern, process_defaults_.settings);
    apply_process_attributes(pattern, type.settings);
    for (const auto& name : names)
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

void Elaborator::set_type(const ProcessType& type, const ParameterSetting& form) {
    auto changed = type;
    extend(changed, evaluate_attributes(evaluator_, reporter_, form.values), {});
    scopes_.declare(form.process.name, {std::move(changed), form.process.at});
}

void Elaborator::set_connections(const Elements& range, const std::vector<Setting>& settings) {
    for (std::size_t i = 0; i < range.count; ++i) {
        auto& connection = draft_.connections[range.first + i];
        for (const auto& setting : settings)
            if (auto [known, is_new] = connection.settings.emplace(setting.name, setting.at); !is_new)
                refuse_given_twice(reporter_, setting, "attribute", connection.name, known->second);
        apply_connection_attributes(connection, settings, reporter_);
    }
}

void Elaborator::refuse_after_declaration(const Setting& setting, const Node& node) {
    refuse(setting.at,
           fmt::format("the attribute \"{}\" cannot be given after the declaration of \"{}\"", setting.name, node.name),
           setting.name == "type" ? "write the type into the declaration"
                                  : fmt::format("{} kinds {} lists its attributes", program_name(), node.type));
}

/// Sets attributes of nodes that are already declared, so that the elements of an array can have different attributes.
void Elaborator::set_nodes(const Elements& range, const std::vector<Setting>& settings) {
    for (std::size_t i = range.first; i < range.first + range.count; ++i)
        for (const Setting& setting : settings) {
            Node& node = draft_.nodes[i];
            if (!has_node_attribute(node, setting.name))
                refuse_after_declaration(setting, node);
            if (auto [known, is_new] = draft_.node_settings.emplace(std::pair(i, setting.name), setting.at); !is_new)
                refuse_given_twice(reporter_, setting, "attribute", node.name, known->second);
            apply_node_attribute(node, setting, reporter_);
        }
}

/// Adds one shared copy of the settings to each process of the range. Values that are given twice are found later, by
/// Parameters::take_once().
void Elaborator::set_processes(const Elements& range, const std::vector<Setting>& settings, const Location& at) {
    auto is_attribute = [](const Setting& setting) { return is_process_attribute(setting.name); };
    count_things(range.count * static_cast<std::size_t>(std::ranges::count_if(settings, is_attribute)), at);
    auto shared = std::make_shared<const std::vector<Setting>>(settings);
    for (std::size_t i = 0; i < range.count; ++i) {
        evaluator_.step(at);
        draft_.processes[range.first + i].settings.push_back(shared);
    }
}

void Elaborator::perform(const ParameterSetting& form, const Location&) {
    bool whole = form.process.subscripts.empty() && form.process.field.empty();
    if (const auto* symbol = scopes_.find(form.process.name); symbol != nullptr && whole)
        if (const auto* type = std::get_if<ProcessType>(&symbol->meaning))
            return set_type(*type, form);
    auto found = find(form.process);
    if (!form.process.field.empty())
        refuse(form.process.field_at, "attributes belong to a whole process", "name (parameter = value);");
    auto range = elements(form.process, found);
    auto settings = evaluate_attributes(evaluator_, reporter_, form.values);
    if (found.category == Category::connection)
        return set_connections(range, settings);
    if (found.category == Category::node)
        return set_nodes(range, settings);
    if (found.category != Category::process)
        refuse(form.process.at,
               fmt::format("\"{}\" is neither a process nor a connection: write its attributes in its declaration",
                           form.process.name));
    set_processes(range, settings, form.process.at);
}

void Elaborator::use_for_all(const std::string& program, const Location& at) {
    if (!draft_.default_kind.empty())
        refuse(at, "the program for all processes is given twice", "", {first_given(draft_.default_used)});
    draft_.default_kind = program;
    draft_.default_used = at;
}

/// Sets the bootable file of a node. The path of the file is relative to the folder of the netlist.
void Elaborator::boot(const Reference& reference, const Found& found, const std::string& file, const Location& at) {
    Node& node = draft_.nodes[element(reference, found)];
    if (!node.boot_file.empty())
        refuse(reference.at, fmt::format("the processor \"{}\" is given a bootable file twice", node.name), "",
               {first_given(node.boot_stated)});
    if (node.kind->name != "processor")
        refuse(reference.at, fmt::format("\"{}\" is {}: only a processor can be booted", node.name, node.kind->noun));
    const std::filesystem::path folder = at.file ? std::filesystem::path(at.file->path()).parent_path() : "";
    node.boot_file = (folder / file).string();
    node.boot_stated = at;
}

void Elaborator::perform(const UseStatement& form, const Location& at) {
    auto program = evaluator_.text(*form.program, "the program in use");
    if (program.empty())
        refuse(form.program->at, "the name of the program is empty");
    if (!form.process)
        return use_for_all(program, at);
    auto found = find(*form.process);
    if (found.category == Category::node)
        return boot(*form.process, found, program, at);
    if (found.category != Category::process)
        refuse(form.process->at, fmt::format("\"{}\" is neither a process nor a processor", form.process->name),
               "use \"program\" for process;");
    auto range = elements(*form.process, found);
    for (std::size_t i = 0; i < range.count; ++i) {
        auto& process = draft_.processes[range.first + i];
        if (process.used)
            refuse(form.process->at, fmt::format("the process \"{}\" is given a program twice", process.name), "",
                   {first_given(*process.used)});
        process.kind = program;
        process.used = at;
    }
}

} // namespace placedpar
