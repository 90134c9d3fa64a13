#include "explore/study/study_file.hpp"

#include "explore/study/figure_names.hpp"
#include "explore/study/measure.hpp"
#include "explore/study/study_keys.hpp"
#include "explore/study/study_nodes.hpp"
#include "explore/study/study_settings.hpp"
#include "explore/time_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace placedpar {

namespace {

class StudyReader : StudyNodes {
public:
    explicit StudyReader(const std::string& path)
        : StudyNodes(path), folder_(std::filesystem::path(path).parent_path()) {}
    /// Makes a reader that has no file and knows only the keys.
    StudyReader() : StudyNodes(std::make_shared<const SourceFile>("", ""), "study") {}

    std::vector<StudyKey> keys(StudyPart part) {
        StudyProduct product;
        StudySearch search;
        TableRead table;
        StudyRow row;
        std::vector<StudyKey> keys;
        for (const Entry& each : part == StudyPart::whole     ? of_whole(product)
                                 : part == StudyPart::product ? of_product(product)
                                 : part == StudyPart::search  ? of_search(search)
                                 : part == StudyPart::table   ? of_table(table)
                                 : part == StudyPart::column  ? of_variant(row.runs)
                                 : part == StudyPart::row     ? joined(of_row(row, {}, {}), of_variant(row.runs))
                                                              : Entries())
            keys.push_back(each.key);
        return keys;
    }

    Study read() {
        toml::table top = parsed();
        read_top(top);
        refuse_if_failed();
        return std::move(study_);
    }

private:
    static constexpr const char* form_of_variants = "[{name = \"8 slaves\", set = {slaves = 8}}]";

    Entries of_whole(StudyProduct& product) { return joined(joined(of_product(product), of_runs()), of_results()); }

    /// Returns the keys that state which runs are made.
    Entries of_runs() {
        return {
            {{.name = "netlist", .form = "a path", .about = "netlist of the runs, as seen from this file"},
             [this](const toml::node& node) { study_.netlist = beside(text(node)); }},
            whole_entry({.name = "seeds", .about = "number of seeds with which each combination is run", .least = 1},
                        study_.seeds),
            whole_entry({.name = "first_seed", .about = "the first of these seeds; 1 if it is not stated"},
                        study_.first_seed),
            {{.name = "until", .form = "a time such as \"10s\"", .about = "virtual time at which runs are stopped"},
             [this](const toml::node& node) { attempt_at(node, [&] { study_.until = parse_time(text(node)); }); }},
            {{.name = "include", .form = "a path or a list", .about = "folders of files that the netlist includes"},
             [this](const toml::node& node) {
                 for (const std::string& each : texts(node))
                     study_.read.include_folders.emplace_back(beside(each));
             }},
            {{.name = "fault", .form = "a text or a list", .about = "faults, such as \"t[0] halts (at = 20ms)\""},
             [this](const toml::node& node) { study_.read.faults = texts(node); }},
            {{.name = "use",
              .form = "a table of programs and kinds",
              .about = "kinds that replace programs of the netlist",
              .members = StudyPart::programs},
             [this](const toml::node& node) { read_programs(node); }},
            {{.name = "also",
              .form = "tables [[also]]",
              .about = "further combinations of settings",
              .members = StudyPart::product},
             [this](const toml::node& node) {
                 read_in_turn(node, &StudyReader::read_product, "[[also]] must be a table", "[[also]]");
             }},
            {{.name = "search",
              .form = "a table",
              .about = "search for the best combination, by placedpar optimise",
              .members = StudyPart::search},
             [this](const toml::node& node) { read_search(node); }},
        };
    }

    /// Returns the keys that state which results are shown.
    Entries of_results() {
        Entry reference = settings_entry(
            {.name = "relative_to",
             .about = "each figure is divided by the figure of the run that differs only in these settings"},
            study_.relative_to);
        reference.read = [this](const toml::node& node) { read_reference(node); };
        return {
            {{.name = "measure",
              .form = "a measure or a list",
              .about = "figures of the runs that are shown; time if none is stated",
              .words = StudyWords::measures},
             [this](const toml::node& node) { study_.measures = measures(node); }},
            text_entry({.name = "notes", .about = "text below the tables"}, study_.notes),
            {{.name = "price",
              .form = "a table of numbers from 0 to 1e12",
              .about = "prices of types of nodes and of a link; the runs then have the measure price",
              .members = StudyPart::prices},
             [this](const toml::node& node) { study_.prices = numbers(node, "price = {T800 = 300}"); }},
            {{.name = "table",
              .form = "tables [[table]]",
              .about = "figures of runs beside known figures",
              .members = StudyPart::table},
             [this](const toml::node& node) {
                 read_in_turn(node, &StudyReader::read_figures, "\"table\" must be a list of tables", "[[table]]");
             }},
            std::move(reference),
        };
    }

    void read_top(const toml::table& top) {
        StudyProduct product;
        const Handlers handlers = handlers_of(of_whole(product));
        of_whole_study_ = names_of(handlers);
        read_table(top, handlers);
        if (top.contains("table"))
            require_simple(top);
        study_.figures = study_.measures; // --measure does not change the figures
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

    Entries of_product(StudyProduct& product) {
        return {
            {{.name = "set",
              .form = "a table of settings, each with a value, a list or a range such as \"0..7\"",
              .about = "constants, attributes and parameters of the netlist; all combinations are run",
              .members = StudyPart::settings},
             [&](const toml::node& node) { read_axes(node, "", product.axes); }},
            {{.name = "where",
              .form = "an expression over settings",
              .about = "condition; only combinations for which it holds are run",
              .words = StudyWords::conditions},
             [&](const toml::node& node) { attempt_at(node, [&] { product.where = StudyExpression(text(node)); }); }}};
    }

    /// Registers the tables of a list: all tables of [[also]] and [[table]] are read in the order of the file.
    void read_in_turn(const toml::node& node, void (StudyReader::*read)(const toml::table&), const char* what,
                      const char* form) {
        for (const toml::table* each : tables_in(node, what, form))
            parts_.emplace(each->source().begin.line, [this, each, read] { (this->*read)(*each); });
    }

    void read_product(const toml::table& table) {
        StudyProduct product;
        Handlers handlers = handlers_of(of_product(product));
        for (const auto& each : table)
            if (const std::string name(each.first.str());
                std::ranges::find(of_whole_study_, name) != of_whole_study_.end())
                handlers.emplace(name, [this, name](const toml::node& node) { report_misplaced(name, node); });
        read_table(table, handlers);
        add(std::move(product));
    }

    void add(StudyProduct product) {
        settings_.add(product);
        study_.products.push_back(std::move(product));
    }

    /// A table that has been read, and the data that a later table can take over by the key "like".
    struct TableRead {
        StudyTable table;
        Members of_rows; ///< members that hold for all rows of the table
        const toml::node *columns = nullptr, *rows = nullptr;
    };

    void read_figures(const toml::table& source) {
        const toml::node* name = source.get("name");
        if (!name)
            report(source.source().begin, "the table lacks a name", "name = \"as it was measured\"");
        TableRead read = read_like(source);
        read_table(source, handlers_of(of_table(read)), "table");
        if (name && !tables_read_.emplace(read.table.name, read).second)
            report(name->source().begin, fmt::format("two tables have the name \"{}\"", read.table.name));
        if (read.columns)
            read_columns(*read.columns, read.table);
        if (!read.columns || !read.rows)
            return report(source.source().begin, "the table lacks columns or rows", form_of_variants);
        if (read.table.columns.empty()) // the reader has reported the error, and cannot check rows without columns
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

    Entries of_table(TableRead& read) {
        StudyTable& table = read.table;
        Entries entries{
            text_entry({.name = "name", .about = "text above the table"}, table.name),
            {{.name = "like",
              .form = "the name of an earlier table",
              .about = "table that has the keys that are missing here",
              .words = StudyWords::tables},
             [](const toml::node&) {}},
            {{.name = "against", .form = "a text of at most 7 letters", .about = "heading of the known figures"},
             [&](const toml::node& node) { table.against = against(node); }},
            {{.name = "notes", .form = "a text", .about = "text below the table"},
             [&](const toml::node& node) { table.notes = node.value_or(std::string()); }},
            truth_entry({.name = "judged", .about = "a miss counts, even if this is not the first table"},
                        table.judged),
            truth_entry({.name = "fit", .about = "adds a line with the deviation of all figures"}, table.fit),
            settings_entry({.name = "set", .about = "settings of all runs of the table"}, table.shared),
            {{.name = "columns",
              .form = "a list of {name, set}",
              .about = "columns of the table",
              .members = StudyPart::column},
             [&](const toml::node& node) { read.columns = &node; }},
            {{.name = "rows", .form = "a list of tables", .about = "rows of the table", .members = StudyPart::row},
             [&](const toml::node& node) { read.rows = &node; }}};
        StudyRow none;
        return joined(std::move(entries), noted(of_row(none, {}, {}), read.of_rows));
    }

    void read_columns(const toml::node& node, StudyTable& table) {
        std::set<std::string> names;
        for (const toml::table* each : tables_in(node, "expected a list of tables", form_of_variants)) {
            read_table(*each, handlers_of(of_variant(table.columns.emplace_back())), "column");
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
            const Entries of_members = of_row(row, read.table.columns, study_.figures);
            const Handlers handlers = handlers_of(of_members);
            read_table(*each, handlers_of(joined(noted(of_members, members), of_variant(row.runs))), "row");
            require_name(*each, "row", row.runs.name, names);
            for (const auto& [name, node] : members)
                handlers.at(name)(*node);
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
        read_table(*table, handlers_of(of_search(search)), "search");
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

    void read_programs(const toml::node& node) {
        if (const toml::table* table = node.as_table())
            for (const auto& [key, value] : *table)
                study_.read.programs[std::string(key.str())] = text(value);
        else
            report(node.source().begin, "expected a table of programs and kinds",
                   "use = {\"sim.lku\" = \"ga.master\"}");
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

std::vector<StudyKey> study_keys(StudyPart part) { return StudyReader().keys(part); }

} // namespace placedpar
