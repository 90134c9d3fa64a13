#include "netlist/complete/complete.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "netlist/elaborate/declared_type.hpp"
#include "netlist/kinds/own_code.hpp"
#include "netlist/network/names.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

/// Evaluates and checks the parameters of one process.
class Parameters {
public:
    Parameters(Completion& c, std::size_t process)
        : c_(c), draft_(c.draft.processes[process]), kind_(c.kinds[process]),
          result_(c.network.processes[process].parameters), given_(c.network.processes[process].given),
          order_(c.network.processes[process].given_in_order) {}

    void run() {
        if (draft_.interface)
            for (const auto& parameter : draft_.interface->parameters)
                if (parameter.default_value)
                    take({parameter.name, *parameter.default_value, parameter.at});
        for (const auto& settings : draft_.settings)
            for (const auto& setting : *settings)
                take_once(setting);
        for (const auto& setting : draft_.overrides) {
            set_.emplace(setting.name, setting.at);
            take(setting);
        }
        if (kind_ != nullptr)
            fill_in_defaults();
        else if (draft_.interface)
            check_all_given();
    }

private:
    /// Takes a setting that a statement of the netlist makes, in place of the default value in the interface. Refuses a
    /// second setting of this name.
    void take_once(const Setting& setting) {
        auto [known, is_new] = set_.emplace(setting.name, setting.at);
        if (is_new)
            return take(setting);
        bool attribute = declaration(setting.name) == nullptr && is_process_attribute(setting.name);
        refuse_given_twice(c_.reporter, setting, attribute ? "attribute" : "parameter", draft_.name, known->second);
    }

    void take(const Setting& setting) {
        note_order(setting.name);
        const auto* known = kind_ == nullptr ? nullptr : kind_->parameter(setting.name);
        const auto* declared = declaration(setting.name);
        if (known != nullptr)
            take_for_kind(setting, *known, declared);
        else if (declared != nullptr && kind_ == nullptr)
            take_for_stand_in(setting, *declared);
        else if (declared == nullptr && is_process_attribute(setting.name))
            apply_process_attribute(draft_, setting, c_.reporter);
        else if (declared == nullptr)
            refuse_unknown(setting);
    }

    void note_order(const std::string& name) {
        bool parameter = kind_ == nullptr ? declaration(name) != nullptr : kind_->parameter(name) != nullptr;
        if (parameter && noted_.insert(name).second)
            order_.push_back(name);
    }

    const ParameterDeclaration* declaration(const std::string& name) const {
        return draft_.interface ? find_named(draft_.interface->parameters, name) : nullptr;
    }

    std::vector<std::string> known_names() const {
        if (kind_ != nullptr)
            return names_in(kind_->parameters);
        return draft_.interface ? names_in(draft_.interface->parameters) : std::vector<std::string>{};
    }

    void refuse_unknown(const Setting& setting) {
        auto whose = kind_ != nullptr ? fmt::format("the kind \"{}\"", kind_->name)
                                      : fmt::format("the process \"{}\"", draft_.name);
        c_.reporter.error(setting.at, fmt::format("{} has no parameter \"{}\"", whose, setting.name),
                          did_you_mean(setting.name, known_names()));
    }

    void take_for_kind(const Setting& setting, const ParameterDescription& known,
                       const ParameterDeclaration* declared) {
        taken_.insert(known.name);
        auto value = convert(setting, known.type);
        if (!value || (declared != nullptr && !fits(setting, *declared, *value)))
            return;
        if (const auto* text = std::get_if<std::string>(&*value))
            check_choice(setting, known, *text);
        else
            check_range(setting, known, *value);
        result_[known.name] = *value;
        given_[known.name] = setting.at;
    }

    void check_choice(const Setting& setting, const ParameterDescription& known, const std::string& text) {
        const auto& choices = known.choices;
        if (known.check)
            return check_text(setting, known, text);
        if (choices.empty() || std::find(choices.begin(), choices.end(), text) != choices.end())
            return;
        auto guess = did_you_mean(text, choices);
        c_.reporter.error(
            setting.at, fmt::format("illegal value of the parameter \"{}\": \"{}\"", known.name, text),
            fmt::format("expected one of \"{}\"{}", fmt::join(choices, "\", \""), guess.empty() ? "" : "; " + guess));
    }

    void check_text(const Setting& setting, const ParameterDescription& known, const std::string& text) {
        try {
            ask_kind(*kind_, [&] { known.check(text); });
        } catch (const UserError& error) {
            auto what = fmt::format("illegal value of the parameter \"{}\": \"{}\"", known.name, text);
            c_.reporter.error(setting.at, what, error.what());
        }
    }

    void check_range(const Setting& setting, const ParameterDescription& known, const Value& value) {
        const auto* integer = std::get_if<std::int64_t>(&value);
        auto number = integer != nullptr ? static_cast<double>(*integer) : std::get<double>(value);
        if (in_range(known, number))
            return;
        c_.reporter.error(
            setting.at,
            fmt::format("the parameter \"{}\" is out of range: {}", known.name, with_unit(number, known.unit)),
            "expected " + range_of(known));
    }

    std::optional<Value> convert(const Setting& setting, ParameterType type) {
        const auto& value = setting.value;
        if (type == ParameterType::integer && value.integer() != nullptr)
            return value.integer()->value;
        if (type == ParameterType::real && value.real() != nullptr)
            return *value.real();
        if (type == ParameterType::real && value.integer() != nullptr)
            return static_cast<double>(value.integer()->value);
        if (type == ParameterType::text && value.text() != nullptr)
            return *value.text();
        static constexpr const char* wanted[] = {"an integer", "a number", "a string"};
        c_.reporter.error(
            setting.at,
            fmt::format("wrong type for the parameter \"{}\": {} is {}", setting.name, shown(value), type_name(value)),
            fmt::format("expected {}", wanted[static_cast<int>(type)]));
        return std::nullopt;
    }

    /// Returns whether the declared type can hold the value. If not, reports an error.
    bool fits(const Setting& setting, const ParameterDeclaration& declared, const Value& value) {
        auto problem = misfit(declared, value);
        if (!problem)
            return true;
        std::vector<SecondPlace> others;
        if (setting.at != declared.at) // otherwise the value is the declared default
            others.push_back({"declared here", declared.at});
        c_.reporter.error(setting.at, problem->message, problem->hint, std::move(others));
        return false;
    }

    void take_for_stand_in(const Setting& setting, const ParameterDeclaration& declared) {
        std::erase_if(result_, [&](const auto& known) { return base_name(known.first) == declared.name; });
        flatten(setting, declared, {});
    }

    /// Stores an array as one parameter for each element: "a[0]", "a[1]".
    void flatten(const Setting& setting, const ParameterDeclaration& declared, std::vector<std::int64_t> subscripts) {
        bool text_in_numbers = setting.value.array() != nullptr && element_type(declared) == ParameterType::text;
        auto level = subscripts.size();
        if (level == declared.dimensions.size() || (level == element_dimensions(declared) && !text_in_numbers))
            return take_element(setting, declared, subscripts);
        const auto* array = setting.value.array();
        if (array == nullptr || static_cast<std::int64_t>((*array)->size()) != declared.dimensions[level])
            return refuse_array(setting, declared, declared.dimensions[level]);
        subscripts.push_back(0);
        for (const auto& element : **array) {
            flatten({setting.name, element, setting.at}, declared, subscripts);
            ++subscripts.back();
        }
    }

    /// Takes a setting of one element. A setting may also give a single character of a text.
    void take_element(const Setting& setting, const ParameterDeclaration& declared,
                      const std::vector<std::int64_t>& subscripts) {
        bool whole = subscripts.size() == element_dimensions(declared);
        auto value = convert(setting, whole ? element_type(declared) : ParameterType::integer);
        if (value && fits(setting, declared, *value))
            result_[element_name(declared.name, subscripts)] = *value;
    }

    void refuse_array(const Setting& setting, const ParameterDeclaration& declared, std::int64_t size) {
        const auto* array = setting.value.array();
        auto given = array == nullptr ? fmt::format("{} is {}", shown(setting.value), type_name(setting.value))
                                      : fmt::format("an array of {}", counted((*array)->size(), "element"));
        c_.reporter.error(setting.at, fmt::format("wrong type for the parameter \"{}\": {}", setting.name, given),
                          fmt::format("expected an array of {}", counted(static_cast<std::size_t>(size), "element")),
                          {{"declared here", declared.at}});
    }

    void fill_in_defaults() {
        for (const auto& parameter : kind_->parameters) {
            if (taken_.contains(parameter.name))
                continue;
            if (parameter.default_value)
                take_default(parameter.name, *parameter.default_value);
            else if (!was_given(parameter.name))
                refuse_missing(parameter.name);
        }
    }

    void take_default(const std::string& name, const Value& value) {
        const auto* declared = declaration(name);
        if (declared == nullptr || fits({name, {}, declared->at}, *declared, value))
            result_.emplace(name, value);
    }

    void check_all_given() {
        for (const auto& parameter : draft_.interface->parameters)
            if (!parameter.default_value && !was_given(parameter.name))
                refuse_missing(parameter.name);
    }

    bool was_given(const std::string& name) const { return set_.contains(name); }

    void refuse_missing(const std::string& name) {
        c_.reporter.error(draft_.declared, fmt::format("the parameter \"{}\" of \"{}\" is missing", name, draft_.name),
                          fmt::format("{} ({} = ...);", draft_.name, name));
    }

    Completion& c_;
    DraftProcess& draft_;
    const ProcessKind* kind_;
    std::map<std::string, Value>& result_;
    std::map<std::string, Location>& given_;
    std::vector<std::string>& order_;
    std::set<std::string> noted_;              ///< names in `order_`
    std::map<std::string_view, Location> set_; ///< for each name: place of the statement or option that sets it
    std::set<std::string_view> taken_;         ///< parameters of the kind for which a value was given or refused
};

} // namespace

void complete_parameters(Completion& completion, std::size_t process) try {
    Parameters(completion, process).run();
} catch (const StatementRefused&) {
    // a setting was refused; the error has already been reported
}

} // namespace placedpar
