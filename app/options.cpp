#include "app/options.hpp"

#include "explore/time_text.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace placedpar {

namespace {

std::string not_a_time(const std::string& text) {
    try {
        parse_time(text);
        return "";
    } catch (const UserError& refused) {
        return refused.what();
    }
}

DeclaredOption declared_option(const CLI::Option& option) {
    DeclaredOption out{.names = {},
                       .label = option.get_name(option.get_positional(), true),
                       .type = option.get_type_name(),
                       .value = option.get_default_str(),
                       .about = option.get_description(),
                       .takes_value = option.get_items_expected_max() > 0};
    for (const std::string& name : option.get_lnames())
        out.names.push_back("--" + name);
    for (const std::string& name : option.get_snames())
        out.names.push_back("-" + name);
    return out;
}

} // namespace

Option Option::type(const std::string& name) { return Option(*option_->type_name(name)); }
Option Option::check(const std::function<std::string(const std::string&)>& wrong) {
    return Option(*option_->check(wrong));
}
Option Option::one_of(const std::vector<std::string>& words) {
    option_->check(CLI::IsMember(words).description(""));
    return type(fmt::format("{}", fmt::join(words, "|")));
}
Option Option::required() { return Option(*option_->required()); }
Option Option::show_default() { return Option(*option_->capture_default_str()); }
Option Option::group(const std::string& heading) { return Option(*option_->group(heading)); }
Option Option::needs(Option other) { return Option(*option_->needs(other.option_)); }

std::vector<std::string> DeclaredCommand::names_of_commands() const {
    std::vector<std::string> names;
    for (const DeclaredCommand& each : commands)
        names.push_back(each.name);
    return names;
}

std::vector<std::string> DeclaredCommand::names_of_options() const {
    std::vector<std::string> names;
    for (const DeclaredOption& each : options)
        names.insert(names.end(), each.names.begin(), each.names.end());
    return names;
}

const DeclaredCommand* DeclaredCommand::command(const std::string& called) const {
    auto found = std::ranges::find(commands, called, &DeclaredCommand::name);
    return found == commands.end() ? nullptr : &*found;
}

const DeclaredOption* DeclaredCommand::option(const std::string& typed) const {
    auto has_it = [&](const DeclaredOption& each) { return std::ranges::count(each.names, typed) > 0; };
    auto found = std::ranges::find_if(options, has_it);
    return found == options.end() ? nullptr : &*found;
}

DeclaredCommand declared(const CLI::App& app) {
    DeclaredCommand out{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options())
        out.options.push_back(declared_option(*option));
    for (const CLI::App* command : app.get_subcommands({}))
        out.commands.push_back(declared(*command));
    return out;
}

template <class Value>
Option Options::add(const std::string& name, Value& value, const std::string& about) {
    if constexpr (std::is_assignable_v<Value&, Time>) {
        auto take = [&value](const std::string& text) { value = parse_time(text); };
        return Option(*command_->add_option_function<std::string>(name, take, about)).type("TIME").check(not_a_time);
    } else {
        return Option(*command_->add_option(name, value, about));
    }
}

template Option Options::add(const std::string&, std::string&, const std::string&);
template Option Options::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Options::add(const std::string&, double&, const std::string&);
template Option Options::add(const std::string&, std::uint16_t&, const std::string&);
template Option Options::add(const std::string&, std::uint64_t&, const std::string&);
template Option Options::add(const std::string&, std::optional<std::uint64_t>&, const std::string&);
template Option Options::add(const std::string&, std::optional<std::string>&, const std::string&);
template Option Options::add(const std::string&, Time&, const std::string&);
template Option Options::add(const std::string&, std::optional<Time>&, const std::string&);

Option Options::add_list(const std::string& name, std::vector<std::string>& values, const std::string& type,
                         const std::string& about) {
    return Option(*command_->add_option(name, values, about)->type_name(type)->allow_extra_args(false));
}
Option Options::add_flag(const std::string& name, bool& value, const std::string& about) {
    return Option(*command_->add_flag(name, value, about));
}
void Options::add_footer(const std::string& text) { command_->footer(text); }

bool Options::is_given(const std::string& name) const { return command_->count(name) > 0; }
DeclaredCommand Options::program() const { return declared(*command_->get_parent()); }

} // namespace placedpar
