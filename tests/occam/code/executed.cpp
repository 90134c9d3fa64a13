#include "executed.hpp"

#include "occam/check/check.hpp"
#include "occam/code/place_table.hpp"
#include "occam/library/library.hpp"
#include "runtime/transputer/core.hpp"
#include "runtime/transputer/error_text.hpp"
#include "runtime/transputer/waiting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

namespace placedpar::test {

/// A link 0 that brings the rest of a bootable file.
class BootedCode::BootLink final : public transputer::LinkEngines {
public:
    explicit BootLink(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
    void begin_transfer(int channel, transputer::Word address, transputer::Word bytes) override {
        if (channel == 4 && bytes <= bytes_.size())
            asked_ = {address, bytes};
    }
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
    /// Brings what was asked for. Returns false if nothing was.
    bool serve(transputer::Core& core) {
        if (!asked_)
            return false;
        core.copy_to_memory(transputer::NodeMemory::offset_of(asked_->first), {bytes_.data(), asked_->second});
        bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(asked_->second));
        asked_.reset();
        core.transfer_ended(4);
        return true;
    }

private:
    std::vector<std::uint8_t> bytes_;
    std::optional<std::pair<transputer::Word, transputer::Word>> asked_;
};

BootedCode::BootedCode(const occam::Code& code, const occam::CodeOptions& options, std::uint32_t memory)
    : results_(
          static_cast<transputer::Word>(where_code_is(code, options) + code.bytes.size() + code.vector_space_bytes)) {
    const std::vector<std::uint8_t> file = bootable(code, options);
    const std::size_t loader = file.front();
    link_ = std::make_unique<BootLink>(
        std::vector<std::uint8_t>(file.begin() + 1 + static_cast<std::ptrdiff_t>(loader), file.end()));
    core_ = std::make_unique<transputer::Core>(
        options.model, memory,
        transputer::CoreTiming{.memory_cycles = 1, .wraps = options.mode == occam::ErrorMode::stop}, *link_);
    core_->copy_to_memory(transputer::traits_of(options.model).memory_start, {file.data() + 1, loader});
    core_->boot(static_cast<transputer::Word>(loader), 4);
}

BootedCode::~BootedCode() = default;

bool BootedCode::run(transputer::HalfCycles most) {
    while (core_->stopped() == transputer::Stopped::nothing) {
        const auto pause = core_->run(most);
        if (pause == transputer::Core::Pause::limit)
            return false;
        if (pause != transputer::Core::Pause::idle)
            continue;
        if (core_->next_timer() != Time::max())
            core_->pass_idle_time(std::max(core_->next_timer(), core_->local_time()));
        else if (!link_->serve(*core_))
            return true;
    }
    return true;
}

void BootedCode::set_results(std::span<const std::int32_t> words) {
    core_->copy_to_memory(results_, {reinterpret_cast<const std::uint8_t*>(words.data()), words.size_bytes()});
}

std::int32_t BootedCode::result(std::uint32_t index) const {
    return static_cast<std::int32_t>(core_->memory().word(results_ + 4 * index));
}

const transputer::Core& BootedCode::core() const { return *core_; }

CompiledProgram compiled_program(const std::string& text, const occam::CodeOptions& options) {
    Reporter reporter;
    const auto file = std::make_shared<SourceFile>("test.occ", text);
    occam::ParseOptions reading;
    reading.built_in = [](const std::string& name) { return occam::library_text(name); };
    occam::Parsed parsed = occam::parse(file, reading, reporter);
    if (!reporter.failed())
        occam::check(*parsed.program, parsed.options, reporter);
    if (reporter.failed())
        throw std::runtime_error(render(reporter.take()));
    occam::Code code = occam::compile(*parsed.program, *occam::main_procedure(*parsed.program), options);
    return {std::move(parsed.program), std::move(code)};
}

namespace {

/// Describes the error with its place in the text without the lines that execute() adds.
std::string described(const transputer::Core& core, const transputer::ErrorNote& found,
                      const transputer::CodeLines& lines) {
    const transputer::ErrorNote error = error_to_name(core, found, lines);
    const std::string place = lines.file_place(error.after - 1);
    return place.substr(place.find(':') + 1) + " " + print_error(core, error, lines);
}

} // namespace

std::string indented(std::string_view text, std::size_t blanks) {
    std::string result;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        result += line.empty() ? "\n" : std::string(blanks, ' ') + std::string(line) + "\n";
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return result;
}

Executed execute(std::string_view body, const occam::CodeOptions& options, std::string_view declarations,
                 std::span<const std::int32_t> initial) {
    const std::string text = fmt::format("PROTOCOL SP IS INT16::[]BYTE:\n{}PROC main (CHAN OF SP fs, ts, []INT "
                                         "memory)\n{}:\n",
                                         declarations, indented(body, 2));
    const auto [program, code] = compiled_program(text, options);
    BootedCode booted(code, options, 1 << 24);
    booted.set_results(initial);
    const transputer::Word start = transputer::traits_of(options.model).memory_start;
    const transputer::CodeLines lines(place_table(code, *program, where_code_is(code, options) - start), "",
                                      transputer::most_negative + start);
    booted.know_errors(lines);
    constexpr transputer::HalfCycles most = 4'000'000'000;
    if (!booted.run(most))
        throw std::runtime_error("the program does not end");
    const transputer::Core& core = booted.core();
    Executed done;
    done.halted = core.stopped() == transputer::Stopped::by_error;
    if (core.stopped() != transputer::Stopped::nothing && !done.halted)
        done.trouble = core.why_stopped();
    if (done.halted)
        done.errors.push_back(described(core, core.error(), lines));
    for (const transputer::Core::StoppedProcess& each : core.stopped_processes())
        done.errors.push_back(described(core, each.error, lines));
    for (const transputer::WaitingProcess& each : transputer::waiting_processes(core))
        done.waiting.push_back(lines.process(each.workspace) + (each.channels.empty() ? " for nothing" : ""));
    done.cycles = core.busy() / 2;
    constexpr std::uint32_t words_of_results = 1 << 17;
    for (std::uint32_t i = 0; i < words_of_results; ++i)
        done.results.push_back(booted.result(i));
    return done;
}

} // namespace placedpar::test
