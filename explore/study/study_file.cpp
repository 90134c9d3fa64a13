#include "explore/study/study_file.hpp"

#include "explore/study/figure_names.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/study_settings.hpp"
#include "explore/study/toml_reader.hpp"
#include "explore/time_text.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace placedpar {

namespace {

class StudyReader : TomlReader {
public:
    explicit StudyReader(const std::string& path)
        : TomlReader(path), folder_(std::filesystem::path(path).parent_path()) {}

    Study read() {
        toml::table top = parsed();
        read_top(top);
        refuse_if_failed();
        return std::move(study_);
    }

private:
    static constexpr const char* form_of_variants = "[{name = \"8 slaves\", set = {slaves = 8}}]";

    void read_top(const toml::table& top) {
        StudyProduct product;
        Handlers handlers = of_product(product);
        handlers["netlist"] = [&](const toml::node& node) { study_.netlist = beside(text(node)); };
        handlers["seeds"] = [&](const toml::node& node) { study_.seeds = whole(node, 1); };
        handlers["first_seed"] = [&](const toml::node& node) { study_.first_seed = whole(node, 0); };
        handlers["measure"] = [&](const toml::node& node) { study_.measures = measures(node); };
        handlers["notes"] = [&](const toml::node& node) { study_.notes = text(node); };
        handlers["also"] = [&](const toml::node& node) {
            read_in_turn(node, &StudyReader::read_product, "[[also]] must be a table", "[[also]]");
        };
        handlers["table"] = [&](const toml::node& node) {
            read_in_turn(node, &StudyReader::read_figures, "\"table\" must be a list of tables", "[[table]]");
        };
        handlers["include"] = [&](const toml::node& node) {
            for (const std::string& each : texts(node))
                study_.read.include_folders.emplace_back(beside(each));
        };
        handlers["fault"] = [&](const toml::node& node) { study_.read.faults = texts(node); };
        handlers["use"] = [&](const toml::node& node) { read_programs(node); };
        handlers["price"] = [&](const toml::node& node) { study_.prices = numbers(node, "price = {T800 = 300}"); };
        handlers["search"] = [&](const toml::node& node) { read_search(node); };
        handlers["relative_to"] = [&](const toml::node& node) { read_reference(node); };
        handlers["until"] = [&](const toml::node& node) {
            attempt_at(node, [&] { study_.until = parse_time(text(node)); });
        };
        of_whole_study_ = names_of(handlers);
        read_table(top, handlers);
        if (top.contains("table"))
            require_simple(top);
        study_.figures = study_.measures; // --measure does not change these
        if (study_.figures.empty())
            study_.figures = {"time"};
        if (study_.netlist.empty())
            report(top.source().begin, "the study names no netlist", "netlist = \"figure-e2.cfs\"");
        if (study_.search && !study_.relative_to.empty())
            report(top.get("relative_to")->source().begin, "a search cannot use relative figures",
                   "leave out relative_to or [search]");
        if (top.contains("set") || !top.contains("table"))
            add(std::move(product));
        for (const auto& [line, read_part] : parts_)
            read_part();
    }

    /// Refuses keys that cannot be combined with tables.
    void require_simple(const toml::table& top) {
        if (top.contains("where") && !top.contains("set"))
            report(top.get("where")->source().begin,
                   "\"where\" selects combinations of [set], but the study has no [set]",
                   "leave out \"where\": all runs of a table are made, and each [[also]] has its own \"where\"");
        if (top.contains("search"))
            report(top.get("search")->source().begin, "a study with [search] cannot have [[table]]",
                   "leave out [search] or [[table]]; use two studies for both");
    }

    /// Returns the handlers for a product's members.
    Handlers of_product(StudyProduct& product) {
        return {{"set", [&](const toml::node& node) { read_axes(node, "", product.axes); }},
                {"where", [&](const toml::node& node) {
                     attempt_at(node, [&] { product.where = StudyExpression(text(node)); });
                 }}};
    }

    /// Registers the tables of a list: all tables of [[also]] and [[table]] are read in the order of the file.
    void read_in_turn(const toml::node& node, void (StudyReader::*read)(const toml::table&), const char* what,
                      const char* form) {
        for (const toml::table* each : tables_in(node, what, form))
            parts_.emplace(each->source().begin.line, [this, each, read] { (this->*read)(*each); });
    }

    void read_product(const toml::table& table) {
        StudyProduct product;
        Handlers handlers = of_product(product);
        for (const std::string& name : of_whole_study_)
            handlers.emplace(name, [&](const toml::node& misplaced) { report_misplaced(name, misplaced); });
        read_table(table, handlers);
        add(std::move(product));
    }

    void add(StudyProduct product) {
        settings_.add(product);
        study_.products.push_back(std::move(product));
    }

    using Members = std::map<std::string, const toml::node*>;

    /// A table that has been read, and the data that a later table can take over by "like".
    struct TableRead {
        StudyTable table;
        Members of_rows; ///< members that hold for all its rows
        const toml::node *columns = nullptr, *rows = nullptr;
    };

    void read_figures(const toml::table& source) {
        const toml::node* name = source.get("name");
        if (!name)
            report(source.source().begin, "the table lacks a name", "name = \"as it was measured\"");
        TableRead read = read_like(source);
        read_table(source, of_table(read), "table");
        if (name && !tables_read_.emplace(read.table.name, read).second)
            report(name->source().begin, fmt::format("two tables have the name \"{}\"", read.table.name));
        if (read.columns)
            read_columns(*read.columns, read.table);
        if (!read.columns || !read.rows)
            return report(source.source().begin, "the table lacks columns or rows", form_of_variants);
        if (read.table.columns.empty()) // reported already; without columns the rows cannot be checked
            return;
        read_rows(read);
        add_runs_of(read.table);
        study_.tables.push_back(std::move(read.table));
    }

    TableRead read_like(const toml::table& source) {
        const toml::node* like = source.get("like");
        if (!like)
            return {};
        const std::string name = text(*like);
        auto found = tables_read_.find(name);
        if (found != tables_read_.end())
            return found->second;
        report(like->source().begin, fmt::format("no earlier table has the name \"{}\"", name),
               "\"like\" takes the name of an earlier table");
        return {};
    }

    Handlers of_table(TableRead& read) {
        Handlers handlers = noted(read.of_rows);
        handlers.merge(
            Handlers{{"name", [&](const toml::node& node) { read.table.name = text(node); }},
                     {"like", [](const toml::node&) {}},
                     {"against", [&](const toml::node& node) { read.table.against = against(node); }},
                     {"notes", [&](const toml::node& node) { read.table.notes = node.value_or(std::string()); }},
                     {"judged", [&](const toml::node& node) { read.table.judged = truth(node); }},
                     {"fit", [&](const toml::node& node) { read.table.fit = truth(node); }},
                     {"set", [&](const toml::node& node) { read.table.shared = settings(node); }},
                     {"columns", [&](const toml::node& node) { read.columns = &node; }},
                     {"rows", [&](const toml::node& node) { read.rows = &node; }}});
        return handlers;
    }

    std::string against(const toml::node& node) {
        constexpr std::ptrdiff_t most = 7;
        std::string word = text(node);
        if (std::ranges::count_if(word, [](char each) { return (each & 0xC0) != 0x80; }) > most) // counts the
                                                                                                 // characters of UTF-8
            report(node.source().begin,
                   fmt::format("\"{}\" is too long as a heading: expected at most {} letters", word, most));
        return word;
    }

    /// Returns handlers that only store a row's members, which are read later, when the columns are known.
    static Handlers noted(Members& members) {
        Handlers handlers;
        for (const char* name : {"figure", "unit", "decimals", "relative_to", "known", "tolerance", "origin", "judge",
                                 "interval", "at_least", "at_most"})
            handlers[name] = [&members, name](const toml::node& node) { members[name] = &node; };
        return handlers;
    }

    void read_columns(const toml::node& node, StudyTable& table) {
        std::set<std::string> names;
        for (const toml::table* each : tables_in(node, "expected a list of tables", form_of_variants)) {
            read_table(*each, of_variant(table.columns.emplace_back()), "column");
            require_name(*each, "column", table.columns.back().name, names);
        }
    }

    void require_name(const toml::table& source, const char* what, const std::string& name,
                      std::set<std::string>& names) {
        if (!source.contains("name"))
            report(source.source().begin, fmt::format("the {} lacks a name", what), form_of_variants);
        else if (!names.insert(name).second)
            report(source.get("name")->source().begin,
                   fmt::format("two {}s of the table have the name \"{}\"", what, name));
    }

    void read_rows(TableRead& read) {
        std::set<std::string> names;
        FigureNames known_names;
        known_names.add_measures(study_.figures);
        for (const toml::table* each : tables_in(*read.rows, "expected a list of tables", form_of_variants)) {
            StudyRow row;
            Members members = read.of_rows;
            Handlers handlers = noted(members);
            handlers.merge(of_variant(row.runs));
            read_table(*each, handlers, "row");
            require_name(*each, "row", row.runs.name, names);
            for (const auto& [name, node] : members)
                of_row(row, read.table.columns).at(name)(*node);
            if (!members.contains("figure"))
                report(each->source().begin, "the row lacks a figure", "figure = \"time\"");
            for (std::size_t i = 0; i < read.table.columns.size(); ++i)
                check_cell(members, row, read.table.set(row, read.table.columns[i]), i, known_names);
            known_names.add(row.runs.name, "the row above");
            read.table.rows.push_back(std::move(row));
        }
    }

    /// Checks a cell as far as possible before its run is made.
    void check_cell(const Members& members, const StudyRow& row, const Overrides& set, std::size_t column,
                    const FigureNames& measures_and_rows) {
        FigureNames settings;
        settings.add_settings(set);
        if (row.figure)
            attempt_at(*members.at("figure"), [&] { settings.require(row.figure, measures_and_rows); });
        StudyExpression::Figures known;
        if (column < row.known.size() && row.known[column])
            attempt_at(value_at(members, "known", column), [&] {
                settings.require(row.known[column], {});
                known["known"] = row.known[column].value(set, {});
            });
        for (const auto& each : {std::pair("at_least", &row.at_least), std::pair("at_most", &row.at_most)})
            if (const auto& bounds = *each.second; column < bounds.size() && bounds[column])
                attempt_at(value_at(members, each.first, column), [&] { settings.require(bounds[column], {}); });
        if (column < row.tolerances.size() && row.tolerances[column].amount)
            attempt_at(value_at(members, "tolerance", column),
                       [&] { check_tolerance(row.tolerances[column].amount, settings, set, known); });
    }

    static void check_tolerance(const StudyExpression& amount, const FigureNames& settings, const Overrides& set,
                                const StudyExpression::Figures& known) {
        FigureNames of_known;
        of_known.add("known", "the known figure");
        settings.require(amount, of_known);
        if (known.empty() && amount.names().contains("known"))
            return;
        if (const double value = amount.value(set, known); !(value >= 0))
            throw UserError(fmt::format("the tolerance is {}; expected 0 or more", value));
    }

    /// Returns the node of a value, whose position is used in messages.
    static const toml::node& value_at(const Members& members, const char* name, std::size_t column) {
        const toml::node& node = *members.at(name);
        const toml::array* list = node.as_array();
        return list && column < list->size() ? *list->get(column) : node;
    }

    Handlers of_variant(StudyVariant& variant) {
        return {{"name", [&](const toml::node& node) { variant.name = text(node); }},
                {"set", [&](const toml::node& node) { variant.set = settings(node); }}};
    }

    Handlers of_row(StudyRow& row, const std::vector<StudyVariant>& columns) {
        return {
            {"figure", [&](const toml::node& node) { read_figure(node, row); }},
            {"unit", [&](const toml::node& node) { row.unit = text(node); }},
            {"decimals", [&](const toml::node& node) { row.decimals = static_cast<int>(whole(node, 0, 9)); }},
            {"relative_to", [&](const toml::node& node) { row.relative_to = settings(node); }},
            {"known", [&](const toml::node& node) { row.known = by_column(node, columns, &StudyReader::known); }},
            {"tolerance",
             [&](const toml::node& node) { row.tolerances = by_column(node, columns, &StudyReader::tolerance); }},
            {"judge", [&](const toml::node& node) { row.judge = judge(node); }},
            {"interval", [&](const toml::node& node) { row.interval = truth(node); }},
            {"at_least", [&](const toml::node& node) { row.at_least = by_column(node, columns, &StudyReader::known); }},
            {"at_most", [&](const toml::node& node) { row.at_most = by_column(node, columns, &StudyReader::known); }},
            {"origin", [&](const toml::node& node) { row.origins = by_column(node, columns, &StudyReader::origin); }}};
    }

    void read_figure(const toml::node& node, StudyRow& row) {
        const std::string figure = text(node);
        if (std::ranges::find(study_.figures, figure) != study_.figures.end())
            row.measure = figure;
        else
            row.figure = expression(node, figure);
    }

    /// Reads a value for each column. A value that is not a list holds for all columns.
    template <class Read>
    std::vector<Read> by_column(const toml::node& node, const std::vector<StudyVariant>& columns,
                                Read (StudyReader::*read)(const toml::node&, std::string)) {
        const toml::array* array = node.as_array();
        if (!array)
            return std::vector(columns.size(), (this->*read)(node, value_text(node)));
        if (array->size() != columns.size())
            report(node.source().begin,
                   fmt::format("the list has {} values than the table has columns: {}, {}",
                               array->size() > columns.size() ? "more" : "fewer", counted(array->size(), "value"),
                               counted(columns.size(), "column")),
                   "give one value for each column, or a single value without brackets for all of them");
        std::vector<Read> all;
        for (const toml::node& each : *array)
            all.push_back((this->*read)(each, value_text(each)));
        return all;
    }

    StudyExpression expression(const toml::node& node, const std::string& text) {
        StudyExpression read("");
        if (text.empty())
            report(node.source().begin, "expected a number or an expression; write nan for no value");
        attempt_at(node, [&] { read = StudyExpression(text); });
        return read;
    }

    StudyExpression known(const toml::node& node, std::string text) {
        return text == "nan" ? StudyExpression("") : expression(node, text);
    }

    /// Reads a tolerance: "3 %" is a share of the known figure; ".05" or ".01 * known" is in the figure's unit. With
    /// nan, the cell is not judged.
    StudyTolerance tolerance(const toml::node& node, std::string text) {
        const bool in_percent = text.ends_with('%');
        if (in_percent)
            text.pop_back();
        return {known(node, text), in_percent};
    }

    Judge judge(const toml::node& node) {
        const std::string name = text(node);
        for (Judge each : every_judge)
            if (name == name_of(each))
                return each;
        report(node.source().begin, fmt::format("unknown judge \"{}\"", name),
               "expected \"thesis\", \"published\" or \"own\"");
        return Judge::own;
    }

    Origin origin(const toml::node& node, std::string text) {
        for (Origin each : every_origin)
            if (text == name_of(each))
                return each;
        report(node.source().begin, fmt::format("unknown origin \"{}\"", text),
               "expected \"outcome\", \"calibrated\", \"workload\", \"fitted\" or \"constant\"");
        return Origin::outcome;
    }

    /// Adds the runs that the study does not have yet.
    void add_runs_of(const StudyTable& table) {
        for (const StudyRow& row : table.rows)
            for (const StudyVariant& column : table.columns) {
                Overrides set = table.set(row, column);
                add_run(set);
                for (const auto& [name, value] : row.relative_to)
                    set[name] = value;
                add_run(set);
            }
    }

    void add_run(const Overrides& set) {
        if (settings_.has(set))
            return;
        StudyProduct product;
        for (const auto& [name, value] : set)
            product.axes.push_back({name, read_values(name, value)});
        add(std::move(product));
    }

    void read_search(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (!table)
            return report(node.source().begin, "the search must be a single table", "[search]");
        StudySearch search;
        const std::uint64_t most_machines = StudySearch::most_population, most_bred = StudySearch::most_generations;
        read_table(*table,
                   {{"minimise", [&](const toml::node& each) { search.minimise = measures(each); }},
                    {"population", [&](const toml::node& each) { search.population = whole(each, 4, most_machines); }},
                    {"generations", [&](const toml::node& each) { search.generations = whole(each, 1, most_bred); }},
                    {"seed", [&](const toml::node& each) { search.seed = whole(each, 0); }}},
                   "search");
        if (search.minimise.empty() || search.minimise.size() > 2)
            report(node.source().begin, "a search minimises one or two measures",
                   "minimise = \"time\", or minimise = [\"time\", \"processors\"]");
        else if (search.minimise.front() == search.minimise.back() && search.minimise.size() == 2)
            report(table->get("minimise")->source().begin,
                   fmt::format("\"{}\" is named twice in minimise", search.minimise.front()),
                   "name one measure, as in minimise = \"time\", or two different ones");
        study_.search = std::move(search);
    }

    void read_reference(const toml::node& node) {
        if (!node.is_table())
            return report(node.source().begin, "expected a table", "relative_to = {slaves = 0}");
        study_.relative_to = settings(node);
    }

    /// Reads settings as axes, each of which must have a single value.
    Overrides settings(const toml::node& node) {
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

    /// Reports a key of the whole study that stands below a line in brackets, and so became a key of that table.
    void report_misplaced(const std::string& name, const toml::node& node) {
        report(node.source().begin, fmt::format("\"{}\" belongs to the whole study, not to this table", name),
               "move it above [set] and [[also]]");
    }

    /// Reads the axes in the order of the text, which the parser's tables do not keep. The parser makes nested tables
    /// of names with dots.
    void read_axes(const toml::node& node, const std::string& prefix, std::vector<StudyAxis>& axes) {
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
            if (value->is_table() && prefix.empty() && key->str() == "relative_to") // not a process
                report_misplaced("relative_to", *value);
            else if (value->is_table())
                read_axes(*value, prefix + std::string(key->str()) + ".", axes);
            else
                read_axis_of(prefix + std::string(key->str()), *value, axes);
    }

    void read_axis_of(const std::string& name, const toml::node& node, std::vector<StudyAxis>& axes) {
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

    void read_programs(const toml::node& node) {
        if (const toml::table* table = node.as_table())
            for (const auto& [key, value] : *table)
                study_.read.programs[std::string(key.str())] = text(value);
        else
            report(node.source().begin, "expected a table of programs and kinds",
                   "use = {\"sim.lku\" = \"ga.master\"}");
    }

    std::vector<std::string> measures(const toml::node& node) {
        std::vector<std::string> names = texts(node);
        for (const std::string& each : names)
            attempt_at(node, [&] { StudyMeasure{each}; });
        return names;
    }

    std::string beside(const std::string& path) const { return (folder_ / path).lexically_normal().string(); }

    std::filesystem::path folder_;
    Study study_;
    StudySettings settings_; ///< settings of the study's products
    std::vector<std::string> of_whole_study_;
    /// The readers of [[also]] and [[table]] by line, so that runs come in the order of the file.
    std::multimap<toml::source_index, std::function<void()>> parts_;
    std::map<std::string, TableRead> tables_read_; ///< key: name
};

} // namespace

Study read_study(const std::string& path) { return StudyReader(path).read(); }

} // namespace placedpar
