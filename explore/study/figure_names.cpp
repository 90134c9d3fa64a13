#include "explore/study/figure_names.hpp"

#include "explore/study/measure.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace placedpar {

namespace {

using MeaningsByName = std::map<std::string, std::set<std::string>>;

[[noreturn]] void refuse_unknown_name(const std::string& name, const MeaningsByName& known) {
    std::vector<std::string> names;
    for (const auto& each : known)
        if (each.first.find_first_of(". ") == std::string::npos)
            names.push_back(each.first);
    const std::string meant = did_you_mean(name, names);
    throw UserError(fmt::format("the name \"{}\" is undefined; {}", name,
                                !meant.empty()  ? meant
                                : names.empty() ? "no name is defined here"
                                                : fmt::format("the defined names are {}", fmt::join(names, ", "))));
}

} // namespace

void FigureNames::add_settings(const Overrides& set) {
    for (const auto& each : set) {
        const std::string& name = each.first;
        const std::string last = name.substr(name.rfind('.') + 1);
        add(name, fmt::format("the setting {}", name));
        if (!set.contains(last))
            add(last, fmt::format("the setting {}", name));
    }
}

void FigureNames::add_measures(const std::vector<std::string>& measures) {
    for (const std::string& each : measures)
        add(StudyMeasure(each).last_name(), fmt::format("the measure {}", each));
}

void FigureNames::require(const StudyExpression& expression, const FigureNames& other) const {
    for (const std::string& name : expression.names()) {
        std::set<std::string> meanings;
        for (const MeaningsByName* known : {&meanings_, &other.meanings_})
            if (auto found = known->find(name); found != known->end())
                meanings.insert(found->second.begin(), found->second.end());
        if (meanings.empty()) {
            MeaningsByName all = meanings_;
            all.insert(other.meanings_.begin(), other.meanings_.end());
            refuse_unknown_name(name, all);
        }
        if (meanings.size() > 1)
            throw UserError(
                fmt::format("\"{}\" is ambiguous: it stands for {}", name, fmt::join(meanings, " and for ")));
    }
}

} // namespace placedpar
