#include "python/module/interpreter.hpp"
#include "python/module/module.hpp"

#include "explore/identify/identify_record.hpp"
#include "hydraulics/data/record_table.hpp"
#include "python/module/network.hpp"
#include "python/module/signals.hpp"
#include "text/refused_text.hpp"

#include <boost/json.hpp>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::python {

namespace {

namespace py = pybind11;

/// Appends the warnings among the faults to `warnings`. Throws RefusedText if a fault is an error.
void keep_warnings(const std::vector<Diagnostic>& faults, std::vector<Diagnostic>& warnings) {
    std::vector<Diagnostic> errors;
    for (const Diagnostic& each : faults)
        (each.severity == Severity::error ? errors : warnings).push_back(each);
    if (!errors.empty())
        throw RefusedText(std::move(errors));
}

/// A table of readings as comma-separated values, read in pieces.
class TableStream final : public RecordStream {
public:
    /// REQUIRES: the other objects outlive this one.
    TableStream(std::string_view text, hydraulics::RecordNeeds needs, const Interruption& interruption,
                std::vector<Diagnostic>& warnings)
        : text_(text), reader_(std::move(needs)), interruption_(interruption), warnings_(warnings) {}

    std::optional<hydraulics::Record> next() override {
        if (bytes_ == text_.size() || stopped()) {
            keep_warnings(reader_.finish(), warnings_);
            return std::nullopt;
        }
        // The command line reads files in pieces of the same size, so it interpolates the same readings.
        constexpr std::size_t piece_bytes = 1 << 20;
        const std::size_t most = ++pieces_ * piece_bytes;
        const std::size_t end = most < text_.size() ? text_.rfind('\n', most - 1) + 1 : text_.size();
        const std::string_view lines = text_.substr(bytes_, end - bytes_);
        bytes_ += lines.size();
        hydraulics::ReadRecord read = reader_.read(lines);
        keep_warnings(read.faults, warnings_);
        return std::move(*read.record);
    }
    std::uint64_t bytes() const override { return bytes_; }
    bool stopped() const override { return interruption_.requested(); }
    const std::vector<Diagnostic>& warnings() const override { return warnings_; }

private:
    const std::string_view text_;
    hydraulics::RecordReader reader_;
    const Interruption& interruption_;
    std::vector<Diagnostic>& warnings_;
    std::size_t bytes_ = 0, pieces_ = 0;
};

RecordInput input_of(std::string_view text, const Interruption& interruption, std::vector<Diagnostic>& warnings) {
    return {[text, &warnings](const hydraulics::RecordNeeds& needs) {
                hydraulics::ReadRecord read = hydraulics::read_record(text, needs);
                keep_warnings(read.faults, warnings);
                return LoadedRecord{std::move(*read.record), warnings};
            },
            [text, &interruption, &warnings](hydraulics::RecordNeeds needs) {
                return std::make_unique<TableStream>(text, std::move(needs), interruption, warnings);
            }};
}

/// Returns the report as JSON, the text for people, and the warnings about the readings.
py::tuple identify(std::string_view text, IdentifySettings settings) {
    settle_way(settings);
    boost::json::object json;
    std::string printed, of_machine;
    std::vector<Diagnostic> warnings;
    try {
        InterruptedByKeyboard interruption;
        const py::gil_scoped_release unlocked;
        identify_record(settings, input_of(text, interruption, warnings),
                        {json, true, [&printed](const std::string& more) { printed += more; },
                         [&of_machine](const std::string& more) { of_machine += more; }, [](const std::string&) {}});
    } catch (const RefusedText& unfit) {
        raise("RecordError", "", as_dicts(unfit.diagnostics()));
    }
    heed_signals();
    return py::make_tuple(boost::json::serialize(json), printed, as_dicts(warnings), of_machine);
}

} // namespace

void add_identifications(py::module_& module) {
    using Settings = IdentifySettings;
    py::class_<Settings> settings(module, "IdentifySettings");
    settings.def(py::init<>());
    for (const auto& [name, text] : {std::pair{"links", &Settings::links},
                                     {"configuration", &Settings::configuration},
                                     {"way", &Settings::way},
                                     {"offset", &Settings::offset},
                                     {"areas_from", &Settings::areas},
                                     {"missing", &Settings::missing},
                                     {"machine", &Settings::machine},
                                     {"coding", &Settings::coding},
                                     {"side", &Settings::side},
                                     {"columns_from", &Settings::columns_from}})
        settings.def_readwrite(name, text);
    for (const auto& [name, number] : {std::pair{"bits", &Settings::bits},
                                       {"population", &Settings::population},
                                       {"trials", &Settings::trials},
                                       {"window", &Settings::window},
                                       {"elite", &Settings::elite},
                                       {"samples", &Settings::samples}})
        settings.def_readwrite(name, number);
    settings.def_readwrite("columns", &Settings::columns);
    settings.def_readwrite("seed", &Settings::seed);
    settings.def_readwrite("bias", &Settings::bias);
    settings.def_readwrite("rising", &Settings::rising);
    module.def("identify", identify);
}

} // namespace placedpar::python
