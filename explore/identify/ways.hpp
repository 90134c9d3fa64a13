#pragma once

#include "explore/identify/identify_settings.hpp"
#include "explore/load.hpp"
#include "identification/compliance_search.hpp"
#include "identification/identification.hpp"

#include <boost/json/fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A record of measurements of any length, which is read in pieces to save memory.
class RecordStream {
public:
    /// Approximate length of a piece of a text; a piece ends at the end of a line. All streams must have pieces of the
    /// same length, because readings are interpolated only within a piece.
    static constexpr std::size_t piece_bytes = 1 << 20;

    virtual ~RecordStream() = default;
    /// Returns the next piece, or nullopt when the record is over. Throws an exception if the record is invalid.
    virtual std::optional<hydraulics::Record> next() = 0;
    virtual std::uint64_t bytes() const = 0; ///< number of bytes read so far
    virtual bool stopped() const = 0;        ///< whether the caller has ended the record early
    virtual const std::vector<Diagnostic>& warnings() const = 0;
};

/// Functions that read the record to be identified, as a whole or in pieces. Only one of them is called, and only once.
struct RecordInput {
    std::function<LoadedRecord(const hydraulics::RecordNeeds&)> whole;
    std::function<std::unique_ptr<RecordStream>(hydraulics::RecordNeeds)> pieces;
};

/// Receives the results of an identification.
struct IdentifyOutput {
    boost::json::object& json; ///< receives the results, in the form of `placedpar identify --json`
    bool keeps_movements;      ///< false if `json` must not contain movements, so that memory does not grow
    std::function<void(const std::string&)> print;    ///< text for people
    WarningSink warn;                                 ///< warnings about the machine's constants
    std::function<void(const std::string&)> progress; ///< receives a text after each piece of a record
};

enum class IdentifyEnd { sound, doubtful, interrupted };

// These are the ways in which identify_record() finds an excavator's compliances in a record. Each way prints its
// results, adds them to the JSON, and throws RefusedInput, UserError or UnfitRecord. REQUIRES: settle_way() has chosen
// the way.

/// Evaluates all movements of the machine, as the program `monitor` does. Without a given configuration (which links
/// move), calls identify_moving() if the record shows the configuration, and otherwise assumes configuration a.
IdentifyEnd identify_as_service(const IdentifySettings&, const RecordInput&, const IdentifyOutput&);
/// Recognises the configuration of each sample, and runs a genetic algorithm with a population for each set of links in
/// Figure 3.13. `first` is the piece of the stream that has been read already.
IdentifyEnd identify_moving(const IdentifySettings&, hydraulics::Record first, RecordStream&, const IdentifyOutput&);
/// Runs one search for several links over the whole movement (identification/whole_search.hpp), and prints the least
/// standard error that the record's noise allows, and the cost on T800s.
IdentifyEnd identify_over_whole(const IdentifySettings&, const RecordInput&, const IdentifyOutput&);

/// The result of the way "thesis", as text and as JSON.
struct ThesisAnswer {
    identification::IdentificationWay way;
    identification::ComplianceSearch prepared;
    identification::Identified identified;
    std::string text;
};
/// Runs one search over the first transient, as in chapter 3 of the thesis. Prints nothing.
ThesisAnswer identify_by_thesis(const IdentifySettings&, const RecordInput&, const IdentifyOutput& output);

} // namespace placedpar
