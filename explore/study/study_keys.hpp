#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The parts of a study's file. The keys of the last three parts are names of the user's: settings of the netlist,
/// parts of a machine with prices, and programs of the netlist.
enum class StudyPart : std::uint8_t { whole, product, search, table, column, row, settings, prices, programs };

/// The words that may occur in a value, for completion in editors. A condition has names of settings; a figure also has
/// names of measures.
enum class StudyWords : std::uint8_t { any, truths, measures, conditions, figures, judges, origins, tables };

/// Describes a key of a study's file.
struct StudyKey {
    static constexpr std::uint64_t no_most = std::numeric_limits<std::uint64_t>::max();
    static constexpr std::string_view whole_number = "a whole number";

    std::string_view name = {};
    std::string_view form = {};            ///< form of the value, such as "a text"
    std::string_view about = {};           ///< meaning of the value, and its unit
    std::int64_t least = 0;                ///< least whole number
    std::uint64_t most = no_most;          ///< greatest whole number; no_most: there is no limit
    StudyWords words = StudyWords::any;    ///< words that the value has
    std::optional<StudyPart> members = {}; ///< part with the members of the value, if the value is a table
};

/// Returns the keys of a part, which the reader of studies accepts (study_file.cpp). Empty for the parts whose keys are
/// names.
std::vector<StudyKey> study_keys(StudyPart);

/// Returns two lines: the key with the form and the range of its value, and the meaning.
std::string print_study_key(const StudyKey&);

} // namespace placedpar
