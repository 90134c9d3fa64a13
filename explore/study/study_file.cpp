// Debian's package would have a library linked otherwise.
#define TOML_HEADER_ONLY 1
// What the parser asserts, it promises to the compiler where assertions are off, and "[(set]" breaks the promise. With
// neither, it goes on and says itself what is wrong with such a text.
#define TOML_ASSERT(condition) static_cast<void>(0)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "explore/study/study_file.hpp"

#include "explore/study/measure.hpp"
#include "explore/time_text.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/paint.hpp"
#include "text/reporter.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

/// Of one file. Reports everything that is wrong, not only the first.
class StudyReader {
public:
    explicit StudyReader(const std::string& path) : folder_(std::filesystem::path(path).parent_path()) {
        LoadedSource loaded = load_input(path);
        source_ = loaded.file;
        if (has_errors(loaded.problems))
            throw RefusedInput(render(loaded.problems));
    }

    Study read() {
        toml::table top = parsed();
        read_top(top);
        refuse_if_failed();
        return std::move(study_);
    }

private:
    using Handler = std::function<void(const toml::node&)>;
    using Handlers = std::map<std::string, Handler>;

    toml::table parsed() {
        try {
            return toml::parse(source_->text(), source_->path());
        } catch (const toml::parse_error& error) {
            report(error.source().begin, described(error), "a study is TOML: https://toml.io");
        }
        refuse_if_failed();
        return {};
    }

    /// The parser garbles the names of keys that are given twice.
    std::string described(const toml::parse_error& error) const {
        const std::string description(error.description());
        if (description.find("redefine existing") == std::string::npos ||
            description.ends_with("as dotted key-value pair"))
            return description;
        return fmt::format("\"{}\" is given twice", key_at(error.source().begin));
    }

    /// Without its quotes. The place may be in the key or in its value.
    std::string key_at(const toml::source_position& place) const {
        std::string key;
        char quote = 0;
        bool complete = false;
        std::size_t column = 0;
        for (char each : source_->line(place.line)) {
            if (const bool past = ++column >= place.column; past && complete)
                break;
            if (quote ? each == quote : each == '"' || each == '\'') {
                quote = quote ? 0 : each;
            } else if (quote == 0 && (each == ',' || each == '{')) {
                key.clear();
                complete = false;
            } else if (quote == 0 && (each == '=' || each == ']')) {
                complete = true;
            } else if (!complete && (quote || std::string_view(" \t\r[").find(each) == std::string_view::npos)) {
                key += each;
            }
        }
        return key;
    }

    void read_top(const toml::table& top) {
        StudyProduct product;
        Handlers handlers = of_product(product);
        handlers["netlist"] = [&](const toml::node& node) { study_.netlist = beside(text(node)); };
        handlers["seeds"] = [&](const toml::node& node) { study_.seeds = whole(node, 1); };
        handlers["first_seed"] = [&](const toml::node& node) { study_.first_seed = whole(node, 0); };
        handlers["measure"] = [&](const toml::node& node) { study_.measures = measures(node); };
        handlers["also"] = [&](const toml::node& node) { read_further(node); };
        handlers["include"] = [&](const toml::node& node) {
            for (const std::string& each : texts(node))
                study_.read.include_folders.emplace_back(beside(each));
        };
        handlers["fault"] = [&](const toml::node& node) { study_.read.faults = texts(node); };
        handlers["use"] = [&](const toml::node& node) { read_programs(node); };
        handlers["search"] = [&](const toml::node& node) { read_search(node); };
        handlers["relative_to"] = [&](const toml::node& node) { read_reference(node); };
        handlers["until"] = [&](const toml::node& node) { study_.until = time(node); };
        of_whole_study_ = names_of(handlers);
        read_table(top, handlers);
        if (study_.netlist.empty())
            report(top.source().begin, "it names no netlist", "netlist = \"figure-e2.cfs\"");
        if (study_.search && !study_.relative_to.empty())
            report(top.get("relative_to")->source().begin, "a search compares figures as they are",
                   "leave out relative_to, or [search]");
        study_.products.insert(study_.products.begin(), std::move(product));
    }

    /// The product's members.
    Handlers of_product(StudyProduct& product) {
        return {{"set", [&](const toml::node& node) { read_axes(node, "", product.axes); }},
                {"where", [&](const toml::node& node) { read_condition(node, product); }}};
    }

    void read_further(const toml::node& node) {
        const toml::array* tables = node.as_array();
        if (!tables || !tables->is_homogeneous(toml::node_type::table))
            return report(node.source().begin, "a further product is a table", "[[also]]");
        for (const toml::node& each : *tables) {
            StudyProduct product;
            Handlers handlers = of_product(product);
            for (const std::string& name : of_whole_study_)
                handlers.emplace(name, [&](const toml::node& misplaced) { report_misplaced(name, misplaced); });
            read_table(*each.as_table(), handlers);
            study_.products.push_back(std::move(product));
        }
    }

    void read_search(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (!table)
            return report(node.source().begin, "a study has one search, which is a table", "[search]");
        StudySearch search;
        const std::uint64_t most_machines = StudySearch::most_population, most_bred = StudySearch::most_generations;
        read_table(*table,
                   {{"minimise", [&](const toml::node& each) { search.minimise = measures(each); }},
                    {"population", [&](const toml::node& each) { search.population = whole(each, 4, most_machines); }},
                    {"generations", [&](const toml::node& each) { search.generations = whole(each, 1, most_bred); }},
                    {"seed", [&](const toml::node& each) { search.seed = whole(each, 0); }}},
                   "search");
        if (search.minimise.empty() || search.minimise.size() > 2)
            report(node.source().begin, "a search minimises one measure or two",
                   "minimise = \"time\", or minimise = [\"time\", \"processors\"]");
        else if (search.minimise.front() == search.minimise.back() && search.minimise.size() == 2)
            report(table->get("minimise")->source().begin,
                   fmt::format("\"{}\" is to be minimised twice", search.minimise.front()),
                   "two different measures are weighed against each other; minimise = \"time\" has one");
        study_.search = std::move(search);
    }

    void read_reference(const toml::node& node) {
        if (!node.is_table())
            return report(node.source().begin, "it takes a table", "relative_to = {slaves = 0}");
        std::vector<StudyAxis> axes;
        read_axes(node, "", axes);
        for (const StudyAxis& axis : axes)
            if (axis.count() == 1)
                study_.relative_to[axis.name] = axis.at(0);
            else
                report(node.source().begin, fmt::format("\"{}\" has several values", axis.name),
                       "a study is relative to one value of each");
    }

    /// What stands below a line in brackets is of that table.
    void report_misplaced(const std::string& name, const toml::node& node) {
        report(node.source().begin, fmt::format("\"{}\" is of the whole study, not of this part of it", name),
               "it stands above [set] and [[also]]");
    }

    /// Each member by what takes it.
    void read_table(const toml::table& table, const Handlers& handlers, std::string_view what = "study") {
        for (const auto& [key, node] : table) {
            std::string name(key.str());
            if (auto found = handlers.find(name); found != handlers.end())
                found->second(node);
            else
                report(key.source().begin, fmt::format("a {} has no \"{}\"", what, name), hint_for(name, handlers));
        }
    }

    static std::vector<std::string> names_of(const Handlers& handlers) {
        std::vector<std::string> names;
        for (const auto& each : handlers)
            names.push_back(each.first);
        return names;
    }

    static std::string hint_for(const std::string& name, const Handlers& handlers) {
        std::string meant = did_you_mean(name, names_of(handlers));
        return meant.empty() ? "what is set in the netlist stands below [set]" : meant;
    }

    /// In the order of the text, which the parser's tables do not keep. Names with dots are tables in tables.
    void read_axes(const toml::node& node, const std::string& prefix, std::vector<StudyAxis>& axes) {
        const toml::table* table = node.as_table();
        if (!table)
            return report(node.source().begin, "it takes a table", "[set]");
        std::vector<std::pair<const toml::key*, const toml::node*>> members;
        for (const auto& [key, value] : *table)
            members.emplace_back(&key, &value);
        std::ranges::stable_sort(members, [](const auto& a, const auto& b) {
            toml::source_position one = a.first->source().begin, other = b.first->source().begin;
            return std::pair(one.line, one.column) < std::pair(other.line, other.column);
        });
        for (const auto& [key, value] : members)
            if (value->is_table() && prefix.empty() && key->str() == "relative_to") // which no process will be called
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
            return report(node.source().begin, fmt::format("\"{}\" is set twice", name), "each name once");
        attempt_at(node, [&] { axes.push_back({name, read_values(name, values)}); });
    }

    /// As --set takes it.
    std::string value_text(const toml::node& node) {
        if (const auto* text = node.as_string())
            return text->get();
        if (const auto* integer = node.as_integer())
            return fmt::format("{}", integer->get());
        if (const auto* real = node.as_floating_point())
            return fmt::format("{}", real->get());
        if (const auto* truth = node.as_boolean())
            return truth->get() ? "1" : "0";
        report(node.source().begin, "it takes numbers and texts", "[1, 2, 5], [\"5M\", \"10M\"] or \"0..7\"");
        return "0";
    }

    void read_condition(const toml::node& node, StudyProduct& product) {
        attempt_at(node, [&] { product.where = StudyCondition(text(node)); });
    }

    void read_programs(const toml::node& node) {
        if (const toml::table* table = node.as_table())
            for (const auto& [key, value] : *table)
                study_.read.programs[std::string(key.str())] = text(value);
        else
            report(node.source().begin, "it takes a table of programs and kinds",
                   "use = {\"sim.lku\" = \"ga.master\"}");
    }

    std::vector<std::string> measures(const toml::node& node) {
        std::vector<std::string> names = texts(node);
        for (const std::string& each : names)
            attempt_at(node, [&] { StudyMeasure{each}; });
        return names;
    }

    std::vector<std::string> texts(const toml::node& node) {
        std::vector<std::string> found;
        if (const toml::array* array = node.as_array())
            for (const toml::node& each : *array)
                found.push_back(text(each));
        else
            found.push_back(text(node));
        return found;
    }

    std::string text(const toml::node& node) {
        if (const auto* text = node.as_string(); text && !text->get().empty())
            return text->get();
        report(node.source().begin, "it takes a text in quotes");
        return "?";
    }

    std::uint64_t whole(const toml::node& node, std::int64_t least,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
        std::int64_t number = node.value_exact<std::int64_t>().value_or(least - 1);
        auto found = static_cast<std::uint64_t>(std::max(number, least));
        if (number < least)
            report(node.source().begin, fmt::format("it takes a whole number of at least {}", least));
        else if (found > most)
            report(node.source().begin, fmt::format("it takes a whole number of at most {}", most));
        return std::min(found, most);
    }

    Time time(const toml::node& node) {
        Time until = Time::max();
        attempt_at(node, [&] { until = parse_time(text(node)); });
        return until;
    }

    std::string beside(const std::string& path) const { return (folder_ / path).lexically_normal().string(); }

    template <class Work>
    void attempt_at(const toml::node& node, Work work) {
        try {
            work();
        } catch (const RefusedInput& refused) {
            std::string said = unpainted(refused.what());
            report(node.source().begin, "it cannot be understood: " + said.substr(0, said.find('\n')));
        } catch (const UserError& refused) {
            report(node.source().begin, refused.what());
        }
    }

    void report(const toml::source_position& at, std::string message, std::string hint = "") {
        reporter_.error({source_, at.line, at.column}, std::move(message), std::move(hint));
    }

    void refuse_if_failed() {
        if (reporter_.failed())
            throw RefusedInput(render(reporter_.take()));
    }

    std::filesystem::path folder_;
    std::shared_ptr<const SourceFile> source_;
    Reporter reporter_;
    Study study_;
    std::vector<std::string> of_whole_study_;
};

} // namespace

Study read_study(const std::string& path) { return StudyReader(path).read(); }

} // namespace placedpar
