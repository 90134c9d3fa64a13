#include "explore/identify/record_text.hpp"

#include "explore/netlist_run.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/refused_text.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace placedpar {

namespace {

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

} // namespace

RecordInput record_of_text(std::string_view text, const Interruption& interruption, std::vector<Diagnostic>& warnings) {
    return {[text, &warnings](const hydraulics::RecordNeeds& needs) {
                hydraulics::ReadRecord read = hydraulics::read_record(text, needs);
                keep_warnings(read.faults, warnings);
                return LoadedRecord{std::move(*read.record), warnings};
            },
            [text, &interruption, &warnings](hydraulics::RecordNeeds needs) {
                return std::make_unique<TableStream>(text, std::move(needs), interruption, warnings);
            }};
}

} // namespace placedpar
