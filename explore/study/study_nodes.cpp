#include "explore/study/study_nodes.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

StudyNodes::Entries StudyNodes::joined(Entries all, Entries more) {
    std::ranges::move(more, std::back_inserter(all));
    return all;
}

TomlReader::Handlers StudyNodes::handlers_of(const Entries& entries) {
    Handlers handlers;
    for (const Entry& each : entries)
        handlers.emplace(each.key.name, each.read);
    return handlers;
}

StudyNodes::Entries StudyNodes::noted(Entries entries, Members& members) {
    for (Entry& each : entries)
        each.read = [&members, name = each.key.name](const toml::node& node) { members[std::string(name)] = &node; };
    return entries;
}

StudyNodes::Entry StudyNodes::whole_entry(StudyKey key, std::uint64_t& target) {
    key.form = StudyKey::whole_number;
    return {key, [this, key, &target](const toml::node& node) { target = whole(node, key.least, key.most); }};
}

StudyNodes::Entry StudyNodes::text_entry(StudyKey key, std::string& target) {
    key.form = "a text";
    return {key, [this, &target](const toml::node& node) { target = text(node); }};
}

StudyNodes::Entry StudyNodes::truth_entry(StudyKey key, bool& target) {
    key.form = "true or false";
    key.words = StudyWords::truths;
    return {key, [this, &target](const toml::node& node) { target = truth(node); }};
}

StudyNodes::Entry StudyNodes::settings_entry(StudyKey key, Overrides& target) {
    key.form = "a table of settings, each with one value";
    key.members = StudyPart::settings;
    return {key, [this, &target](const toml::node& node) { target = settings(node); }};
}

StudyNodes::Entries StudyNodes::of_search(StudySearch& search) {
    return {{{.name = "minimise",
              .form = "a measure, or a list of two",
              .about = "what the best combination has least of; two measures have a front",
              .words = StudyWords::measures},
             [&](const toml::node& node) { search.minimise = measures(node); }},
            whole_entry({.name = "population",
                         .about = "number of combinations in a generation",
                         .least = 4,
                         .most = StudySearch::most_population},
                        search.population),
            whole_entry({.name = "generations",
                         .about = "number of generations",
                         .least = 1,
                         .most = StudySearch::most_generations},
                        search.generations),
            whole_entry({.name = "seed", .about = "seed of the search's random numbers"}, search.seed)};
}

StudyNodes::Entries StudyNodes::of_variant(StudyVariant& variant) {
    return {text_entry({.name = "name", .about = "name of the row or column"}, variant.name),
            settings_entry({.name = "set", .about = "settings of its runs"}, variant.set)};
}

StudyNodes::Entries StudyNodes::of_row(StudyRow& row, const std::vector<StudyVariant>& columns,
                                       const std::vector<std::string>& measures) {
    StudyKey bound{.form = "a number or an expression over settings, or a list by column",
                   .words = StudyWords::conditions};
    const auto of_columns = [&](std::string_view name, std::string_view about, auto& target, auto read) {
        bound.name = name;
        bound.about = about;
        return column_entry(bound, columns, target, read);
    };
    static constexpr StudyKey decimals{
        .name = "decimals", .form = StudyKey::whole_number, .about = "decimals of the printed figure", .most = 9};
    return {
        {{.name = "figure",
          .form = "a measure, or an expression over settings, measures and earlier rows",
          .about = "figure of the row; an expression calls master.T_exe T_exe",
          .words = StudyWords::figures},
         [&](const toml::node& node) { read_figure(node, row, measures); }},
        text_entry({.name = "unit", .about = "unit of the printed figure"}, row.unit),
        {decimals,
         [&](const toml::node& node) { row.decimals = static_cast<int>(whole(node, decimals.least, decimals.most)); }},
        settings_entry({.name = "relative_to",
                        .about = "the figure is divided by the figure of the run that differs only in these settings"},
                       row.relative_to),
        of_columns("known", "known figure; nan if there is none", row.known, &StudyNodes::known),
        of_columns("tolerance", "tolerance in the figure\'s unit, or a share of the known figure such as \"3 %\"",
                   row.tolerances, &StudyNodes::tolerance),
        of_columns("at_least", "least figure, in place of a tolerance", row.at_least, &StudyNodes::known),
        of_columns("at_most", "greatest figure, in place of a tolerance", row.at_most, &StudyNodes::known),
        truth_entry({.name = "interval", .about = "adds rows with the ends of the 95 % interval over the seeds"},
                    row.interval),
        column_entry({.name = "origin",
                      .form = "a word, or a list by column",
                      .about = "how the simulated figure depends on constants of the model",
                      .words = StudyWords::origins},
                     columns, row.origins, &StudyNodes::origin),
        {{.name = "judge", .form = "a word", .about = "source of the known figures", .words = StudyWords::judges},
         [&](const toml::node& node) { row.judge = judge(node); }}};
}

void StudyNodes::read_figure(const toml::node& node, StudyRow& row, const std::vector<std::string>& measures) {
    const std::string figure = text(node);
    if (std::ranges::find(measures, figure) != measures.end())
        row.measure = figure;
    else
        row.figure = expression(node, figure);
}

std::string StudyNodes::against(const toml::node& node) {
    constexpr std::ptrdiff_t most = 7;
    std::string word = text(node);
    if (std::ranges::count_if(word, [](char each) { return (each & 0xC0) != 0x80; }) > most) // counts the characters of
                                                                                             // UTF-8
        report(node.source().begin,
               fmt::format("\"{}\" is too long as a heading: expected at most {} letters", word, most));
    return word;
}

void StudyNodes::report_length(const toml::node& node, std::size_t values, std::size_t columns) {
    report(node.source().begin,
           fmt::format("the list has {} values than the table has columns: {}, {}", values > columns ? "more" : "fewer",
                       counted(values, "value"), counted(columns, "column")),
           "give one value for each column, or a single value without brackets for all of them");
}

StudyExpression StudyNodes::expression(const toml::node& node, const std::string& text) {
    StudyExpression read("");
    if (text.empty())
        report(node.source().begin, "expected a number or an expression; write nan for no value");
    attempt_at(node, [&] { read = StudyExpression(text); });
    return read;
}

StudyExpression StudyNodes::known(const toml::node& node, std::string text) {
    return text == "nan" ? StudyExpression("") : expression(node, text);
}

/// Reads a tolerance: "3 %" is a share of the known figure; ".05" or ".01 * known" is in the figure's unit. With nan,
/// the cell is not judged.
StudyTolerance StudyNodes::tolerance(const toml::node& node, std::string text) {
    const bool in_percent = text.ends_with('%');
    if (in_percent)
        text.pop_back();
    return {known(node, text), in_percent};
}

Judge StudyNodes::judge(const toml::node& node) {
    const std::string name = text(node);
    for (Judge each : every_judge)
        if (name == name_of(each))
            return each;
    report(node.source().begin, fmt::format("unknown judge \"{}\"", name),
           "expected \"thesis\", \"published\" or \"own\"");
    return Judge::own;
}

Origin StudyNodes::origin(const toml::node& node, std::string text) {
    for (Origin each : every_origin)
        if (text == name_of(each))
            return each;
    report(node.source().begin, fmt::format("unknown origin \"{}\"", text),
           "expected \"outcome\", \"calibrated\", \"workload\", \"fitted\" or \"constant\"");
    return Origin::outcome;
}

std::vector<std::string> StudyNodes::measures(const toml::node& node) {
    std::vector<std::string> names = texts(node);
    for (const std::string& each : names)
        attempt_at(node, [&] { StudyMeasure{each}; });
    return names;
}

Overrides StudyNodes::settings(const toml::node& node) {
    std::vector<StudyAxis> axes;
    read_axes(node, "", axes);
    Overrides set;
    for (const StudyAxis& axis : axes)
        if (axis.count() == 1)
            set[axis.name] = axis.at(0);
        else
            report(node.source().begin, fmt::format("\"{}\" has several values here", axis.name),
                   "give each name one value");
    return set;
}

/// Reports a key of the whole study that stands below a line in brackets. TOML takes such a key as a part of this
/// table.
void StudyNodes::report_misplaced(const std::string& name, const toml::node& node) {
    report(node.source().begin, fmt::format("\"{}\" belongs to the whole study, not to this table", name),
           "move it above [set] and [[also]]");
}

/// Reads the axes in the order of the text, which the parser's tables do not keep. For names with dots the parser makes
/// nested tables.
void StudyNodes::read_axes(const toml::node& node, const std::string& prefix, std::vector<StudyAxis>& axes) {
    const toml::table* table = node.as_table();
    if (!table)
        return report(node.source().begin, "expected a table", "[set]");
    std::vector<std::pair<const toml::key*, const toml::node*>> members;
    for (const auto& [key, value] : *table)
        members.emplace_back(&key, &value);
    std::ranges::stable_sort(members, [](const auto& a, const auto& b) {
        toml::source_position one = a.first->source().begin, other = b.first->source().begin;
        return std::pair(one.line, one.column) < std::pair(other.line, other.column);
    });
    for (const auto& [key, value] : members)
        if (value->is_table() && prefix.empty() && key->str() == "relative_to") // no process has this name
            report_misplaced("relative_to", *value);
        else if (value->is_table())
            read_axes(*value, prefix + std::string(key->str()) + ".", axes);
        else
            read_axis_of(prefix + std::string(key->str()), *value, axes);
}

void StudyNodes::read_axis_of(const std::string& name, const toml::node& node, std::vector<StudyAxis>& axes) {
    std::string values;
    if (const toml::array* array = node.as_array()) {
        if (array->empty())
            return report(node.source().begin, fmt::format("\"{}\" has no values", name), "[1, 2, 5] or \"0..7\"");
        for (const toml::node& each : *array)
            values += (values.empty() ? "" : ",") + value_text(each);
    } else {
        values = value_text(node);
    }
    if (std::ranges::find(axes, name, &StudyAxis::name) != axes.end())
        return report(node.source().begin, fmt::format("\"{}\" is set twice", name), "set each name once");
    attempt_at(node, [&] { axes.push_back({name, read_values(name, values)}); });
}

} // namespace placedpar
