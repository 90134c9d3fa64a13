#include "report/policies_report.hpp"

#include "gaprocs/policies/nouns.hpp"
#include "report/kinds_report.hpp"
#include "text/nearest.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

namespace placedpar {

namespace {

/// A parameter that selects a policy, and the process kinds that have it.
struct PolicyParameter {
    const ParameterDescription* parameter;
    std::vector<std::string> kinds;
};

/// The result of a query by name: a step of the algorithm, such as selection, with the policies (ways to do the step)
/// that fit the name.
struct PolicyQuery {
    Noun noun; ///< the step, with all its policies, or with only the policies that the name matches
    std::vector<std::string>
        written; ///< each policy as a netlist writes it, such as "tournament(size = 3)", with the numbers of the query
    std::vector<PolicyParameter> parameters;
};

/// Adds the parameter of a kind of processes. If the parameter is equal in every respect to a parameter of other kinds,
/// adds the kind to the entry of these kinds.
void add_parameter(std::vector<PolicyParameter>& all, const ParameterDescription& parameter, const std::string& kind) {
    auto is_it = [&](const PolicyParameter& each) {
        return parameter_json(*each.parameter) == parameter_json(parameter);
    };
    auto found = std::ranges::find_if(all, is_it);
    if (found == all.end())
        all.push_back({&parameter, {kind}});
    else
        found->kinds.push_back(kind);
}

std::vector<PolicyParameter> parameters_deciding(const Catalogue& catalogue, const std::string& noun) {
    std::vector<PolicyParameter> all;
    for (const auto& [name, kind] : catalogue.kinds())
        for (const ParameterDescription& parameter : kind.parameters)
            if (parameter.noun == noun)
                add_parameter(all, parameter, name);
    return all;
}

/// Returns "tournament" for "Tournament (3)", "initial-population" for "initial population".
std::string name_alone(const std::string& name) {
    std::string alone = lower_case(name.substr(0, name.find('(')));
    alone.resize(alone.find_last_not_of(' ') + 1);
    std::ranges::replace_if(
        alone, [](char c) { return c == ' ' || c == '_'; }, '-');
    return alone;
}

bool has_numbers(const std::string& name) { return name.find('(') != std::string::npos; }

bool is_whole_noun(const PolicyQuery& asked, const std::string& name) {
    auto has_name = [&](const PolicyParameter& each) { return each.parameter->name == name; };
    return name == policies_group || name_alone(name) == asked.noun.name ||
           std::ranges::count(asked.noun.also_called, name_alone(name)) > 0 ||
           std::ranges::any_of(asked.parameters, has_name);
}

/// Returns the query for a step of the algorithm with all its policies and forms.
PolicyQuery ask_all(const Catalogue& catalogue, Noun noun) {
    PolicyQuery asked{.noun = std::move(noun), .written = {}, .parameters = {}};
    asked.parameters = parameters_deciding(catalogue, asked.noun.name);
    for (const PolicyDescription& policy : asked.noun.policies)
        asked.written.push_back(asked.noun.printed(policy.text()));
    return asked;
}

/// Returns the query with only the policies and forms of that name. Returns nothing if no policy or form has the name.
std::optional<PolicyQuery> ask_one(PolicyQuery asked, const std::string& base) {
    std::vector<PolicyDescription>& policies = asked.noun.policies;
    std::erase_if(asked.noun.forms, [&](const Form& form) { return form.name != base; });
    std::erase_if(policies, [&](const PolicyDescription& policy) { return policy.name != base; });
    if (policies.empty() && asked.noun.forms.empty())
        return std::nullopt;
    asked.written.clear();
    for (const PolicyDescription& policy : policies)
        asked.written.push_back(asked.noun.printed(policy.text()));
    return asked;
}

/// Returns the meanings of the name: steps of the algorithm with all their policies or, if no step has this name, the
/// policies and forms of that name.
std::vector<PolicyQuery> find_asked(const Catalogue& catalogue, const std::string& name) {
    std::vector<PolicyQuery> whole, parts;
    for (Noun& noun : policy_nouns()) {
        PolicyQuery asked = ask_all(catalogue, std::move(noun));
        auto part = ask_one(asked, name_alone(name));
        if (!has_numbers(name) && is_whole_noun(asked, lower_case(name)))
            whole.push_back(std::move(asked));
        else if (part)
            parts.push_back(std::move(*part));
    }
    return whole.empty() ? parts : whole;
}

/// Applies the numbers in the name to the policies, and returns the queries whose policy accepts these numbers. Throws
/// UserError if no policy accepts them.
std::vector<PolicyQuery> with_numbers(std::vector<PolicyQuery> all, const std::string& name) {
    std::erase_if(all, [](const PolicyQuery& asked) { return asked.noun.policies.empty(); });
    if (all.empty())
        throw UserError(fmt::format("{} takes no number", name_alone(name)));
    std::vector<PolicyQuery> taking;
    std::exception_ptr refusal;
    for (PolicyQuery& asked : all)
        try {
            asked.noun.forms.clear();
            asked.written = {asked.noun.printed(lower_case(name))};
            taking.push_back(std::move(asked));
        } catch (const UserError&) {
            if (!refusal) // keep the refusal of the first step
                refusal = std::current_exception();
        }
    if (taking.empty())
        std::rethrow_exception(refusal);
    return taking;
}

std::vector<PolicyQuery> ask(const Catalogue& catalogue, const std::string& name) {
    auto asked = find_asked(catalogue, name);
    return has_numbers(name) ? with_numbers(std::move(asked), name) : asked;
}

std::string print_number(const PolicyNumberDescription& number) {
    std::string about = number.about.empty() ? "" : fmt::format("  {:<28} {}\n", "", number.about);
    return fmt::format("  {:<16} {:<7} default {:<14} {} .. {}\n", number.name, number.whole ? "int" : "double",
                       number.by_default, number.least, number.most) +
           about;
}

std::string print_deciding(const PolicyParameter& deciding) {
    return print_parameter(*deciding.parameter, deciding.parameter->default_value) +
           fmt::format("  {:<28} of {}\n", "", fmt::join(deciding.kinds, ", "));
}

/// Returns the text that selects the policy in a netlist: `reproduction = "roulette"`. Returns "" if no parameter
/// accepts the policy.
std::string assignment(const PolicyQuery& asked, const std::string& written) {
    auto takes_policies = [](const PolicyParameter& each) { return each.parameter->check != nullptr; };
    auto found = std::ranges::find_if(asked.parameters, takes_policies);
    return found == asked.parameters.end() ? "" : fmt::format("{} = \"{}\"", found->parameter->name, written);
}

std::string print_one(const PolicyQuery& asked, const PolicyDescription& policy, const std::string& written) {
    std::string in_netlist = assignment(asked, written);
    std::string out = fmt::format("\n{}\n  {}\n", painted(Paint::heading, written), policy.about);
    if (!policy.strings.empty())
        out += fmt::format("  of {}\n", fmt::join(policy.strings, ", "));
    if (!in_netlist.empty())
        out += fmt::format("  in a netlist: {}\n", in_netlist);
    out += fmt::format("  source: {}\n", policy.source.empty() ? "this program" : policy.source);
    for (const PolicyNumberDescription& number : policy.numbers)
        out += print_number(number);
    return out;
}

std::string print_form(const Form& form) {
    return fmt::format("\n{}\n  {}\n  in a netlist: {}\n  source: {}\n  example: placedpar {}\n",
                       painted(Paint::heading, form.name), form.about, form.written, form.source, form.example);
}

std::string print_parameters_deciding(const std::vector<PolicyParameter>& all) {
    std::string out = all.empty() ? "" : painted(Paint::heading, "\nparameters\n");
    for (const PolicyParameter& deciding : all)
        out += print_deciding(deciding);
    return out;
}

std::string print_asked(const PolicyQuery& asked) {
    std::string out = fmt::format("{}\n{}\n", painted(Paint::heading, asked.noun.name), asked.noun.about) +
                      print_parameters_deciding(asked.parameters);
    for (std::size_t i = 0; i < asked.written.size(); ++i)
        out += print_one(asked, asked.noun.policies[i], asked.written[i]);
    for (const Form& form : asked.noun.forms)
        out += print_form(form);
    return out;
}

boost::json::array texts_json(const std::vector<std::string>& texts) {
    return boost::json::array(texts.begin(), texts.end());
}

boost::json::object form_json(const Form& form) {
    return {{"name", form.name},
            {"about", form.about},
            {"written", form.written},
            {"source", form.source},
            {"example", form.example}};
}

boost::json::object asked_json(const PolicyQuery& asked) {
    boost::json::array parameters, policies, forms;
    std::ranges::transform(asked.noun.forms, std::back_inserter(forms), form_json);
    for (const PolicyParameter& deciding : asked.parameters) {
        parameters.push_back(parameter_json(*deciding.parameter));
        parameters.back().as_object()["kinds"] = texts_json(deciding.kinds);
    }
    for (std::size_t i = 0; i < asked.written.size(); ++i) {
        const PolicyDescription& policy = asked.noun.policies[i];
        policies.push_back({{"name", policy.name},
                            {"about", policy.about},
                            {"written", asked.written[i]},
                            {"strings", texts_json(policy.strings)},
                            {"source", policy.source},
                            {"numbers", numbers_json(policy)}});
    }
    return {{"name", asked.noun.name},
            {"about", asked.noun.about},
            {"parameters", std::move(parameters)},
            {"policies", std::move(policies)},
            {"forms", std::move(forms)},
            {"also_called", texts_json(asked.noun.also_called)}};
}

struct Entry {
    std::string name, about;
};

/// Returns the policies of a step, as a netlist writes them, and its forms.
std::vector<Entry> entries_of(const Noun& noun) {
    std::vector<Entry> entries;
    for (const PolicyDescription& policy : noun.policies)
        entries.push_back({policy.text(), policy.about});
    for (const Form& form : noun.forms)
        entries.push_back({form.name, form.about});
    return entries;
}

/// Returns the length of the longest name among the entries of all steps.
std::size_t width_of_names(const std::vector<Noun>& nouns) {
    std::size_t width = 0;
    for (const Noun& noun : nouns)
        for (const Entry& entry : entries_of(noun))
            width = std::max(width, entry.name.size());
    return width;
}

} // namespace

std::vector<std::string> policy_names() {
    std::vector<std::string> names{std::string(policies_group)};
    for (const Noun& noun : policy_nouns()) {
        names.push_back(noun.name);
        for (const PolicyDescription& policy : noun.policies)
            names.push_back(policy.name);
        for (const Form& form : noun.forms)
            names.push_back(form.name);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool is_policy(const Catalogue& catalogue, const std::string& name) { return !find_asked(catalogue, name).empty(); }

std::string print_policies() {
    std::string out = painted(Paint::heading, "policies\n");
    std::vector<Noun> nouns = policy_nouns();
    std::size_t width = width_of_names(nouns);
    for (const Noun& noun : nouns) {
        out += fmt::format("  {:<{}} {}\n", noun.name, width + 2, noun.about);
        for (const Entry& entry : entries_of(noun))
            out += fmt::format("    {:<{}} {}\n", entry.name, width, entry.about);
    }
    return out;
}

std::string print_policy(const Catalogue& catalogue, const std::string& name) {
    std::string out;
    for (const PolicyQuery& asked : ask(catalogue, name))
        out += (out.empty() ? "" : "\n\n") + print_asked(asked);
    return out;
}

boost::json::array policies_json(const Catalogue& catalogue, const std::string& name) {
    boost::json::array array;
    for (const PolicyQuery& asked : ask(catalogue, name))
        array.push_back(asked_json(asked));
    return array;
}

std::string print_numbers(const PolicyDescription& policy) {
    std::string out = policy.numbers.empty() ? "" : painted(Paint::heading, "\nnumbers\n");
    for (const PolicyNumberDescription& number : policy.numbers)
        out += print_number(number);
    return out;
}

boost::json::array numbers_json(const PolicyDescription& policy) {
    boost::json::array array;
    for (const PolicyNumberDescription& number : policy.numbers)
        array.push_back({{"name", number.name},
                         {"whole", number.whole},
                         {"default", number.by_default},
                         {"least", number.least},
                         {"most", number.most},
                         {"about", number.about}});
    return array;
}

} // namespace placedpar
