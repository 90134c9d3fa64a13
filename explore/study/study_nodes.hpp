#pragma once

#include "explore/study/study.hpp"
#include "explore/study/study_keys.hpp"
#include "explore/study/toml_reader.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// Reads the values of a study's keys, and reports their errors.
class StudyNodes : protected TomlReader {
protected:
    using TomlReader::TomlReader;

    /// A key, and the function that reads its value.
    struct Entry {
        StudyKey key;
        Handler read;
    };
    using Entries = std::vector<Entry>;
    using Members = std::map<std::string, const toml::node*>;

    // The functions of the entries store the values in the arguments.
    Entries of_search(StudySearch&);
    Entries of_variant(StudyVariant&);
    /// `measures`: the study's measures, which a row can show without an expression.
    Entries of_row(StudyRow&, const std::vector<StudyVariant>& columns, const std::vector<std::string>& measures);
    /// Returns entries that only store the nodes in `Members`, so that they can be read later.
    static Entries noted(Entries, Members&);
    static Entries joined(Entries, Entries);
    static Handlers handlers_of(const Entries&);

    // These functions add the form of the value, such as "a text", to the key.
    Entry whole_entry(StudyKey, std::uint64_t& target);
    Entry text_entry(StudyKey, std::string& target);
    Entry truth_entry(StudyKey, bool& target);
    Entry settings_entry(StudyKey, Overrides& target);

    std::string against(const toml::node&);
    StudyExpression expression(const toml::node&, const std::string& text);
    StudyExpression known(const toml::node&, std::string text);
    StudyTolerance tolerance(const toml::node&, std::string text);
    Judge judge(const toml::node&);
    Origin origin(const toml::node&, std::string text);
    std::vector<std::string> measures(const toml::node&);
    /// Reads settings as axes, each of which must have a single value.
    Overrides settings(const toml::node&);
    void read_axes(const toml::node&, const std::string& prefix, std::vector<StudyAxis>&);
    void report_misplaced(const std::string& name, const toml::node&);

    /// Reads a value for each column. A value that is not a list holds for all columns.
    template <class Read>
    std::vector<Read> by_column(const toml::node& node, const std::vector<StudyVariant>& columns,
                                Read (StudyNodes::*read)(const toml::node&, std::string)) {
        const toml::array* array = node.as_array();
        if (!array)
            return std::vector(columns.size(), (this->*read)(node, value_text(node)));
        if (array->size() != columns.size())
            report_length(node, array->size(), columns.size());
        std::vector<Read> all;
        for (const toml::node& each : *array)
            all.push_back((this->*read)(each, value_text(each)));
        return all;
    }

private:
    /// Makes the entry of a key with a value for each column.
    template <class Read>
    Entry column_entry(StudyKey key, const std::vector<StudyVariant>& columns, std::vector<Read>& target,
                       Read (StudyNodes::*read)(const toml::node&, std::string)) {
        return {key, [=, this, &columns, &target](const toml::node& node) { target = by_column(node, columns, read); }};
    }

    void read_figure(const toml::node&, StudyRow&, const std::vector<std::string>& measures);
    void report_length(const toml::node&, std::size_t values, std::size_t columns);
    void read_axis_of(const std::string& name, const toml::node&, std::vector<StudyAxis>&);
};

} // namespace placedpar
