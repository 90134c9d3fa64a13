#include "executed.hpp"

#include "occam/check/check.hpp"
#include "occam/code/place_table.hpp"
#include "runtime/transputer/core.hpp"
#include "runtime/transputer/error_text.hpp"
#include "runtime/transputer/waiting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

namespace placedpar::test {

namespace {

constexpr std::uint32_t memory_bytes = 1 << 20, words_of_results = 1024;

/// A link 0 that brings the rest of a bootable file.
class BootLink final : public transputer::LinkEngines {
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

struct Compiled {
    std::unique_ptr<occam::Program> program;
    occam::Code code;
};

Compiled compiled_program(const std::string& text, const occam::CodeOptions& options) {
    Reporter reporter;
    const auto file = std::make_shared<SourceFile>("test.occ", text);
    occam::Parsed parsed = occam::parse(file, {}, reporter);
    if (!reporter.failed())
        occam::check(*parsed.program, parsed.options, reporter);
    if (reporter.failed())
        throw std::runtime_error(render(reporter.take()));
    occam::Code code = occam::compile(*parsed.program, *occam::main_procedure(*parsed.program), options);
    return {std::move(parsed.program), std::move(code)};
}

/// Describes the error with its place in the text without the lines that execute() adds.
std::string described(const transputer::Core& core, const transputer::ErrorNote& found,
                      const transputer::CodeLines& lines) {
    const transputer::ErrorNote error = error_to_name(core, found, lines);
    const std::string place = lines.file_place(error.after - 1);
    return place.substr(place.find(':') + 1) + " " + print_error(core, error, lines);
}

/// Runs the core until nothing can happen any more.
void run_to_end(transputer::Core& core, BootLink& link) {
    constexpr transputer::HalfCycles most = 4'000'000'000;
    while (core.stopped() == transputer::Stopped::nothing) {
        const auto pause = core.run(most);
        if (pause == transputer::Core::Pause::limit)
            throw std::runtime_error("the program does not end");
        if (pause != transputer::Core::Pause::idle)
            continue;
        if (core.next_timer() != Time::max())
            core.pass_idle_time(std::max(core.next_timer(), core.local_time()));
        else if (!link.serve(core))
            return;
    }
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

Executed execute(std::string_view body, const occam::CodeOptions& options, std::string_view declarations) {
    const std::string text = fmt::format("PROTOCOL SP IS INT16::[]BYTE:\n{}PROC main (CHAN OF SP fs, ts, []INT "
                                         "memory)\n{}:\n",
                                         declarations, indented(body, 2));
    const auto [program, code] = compiled_program(text, options);
    std::vector<std::uint8_t> file = bootable(code, options);
    const std::size_t loader = file.front();
    BootLink link({file.begin() + 1 + static_cast<std::ptrdiff_t>(loader), file.end()});
    transputer::Core core(options.model, memory_bytes, {.memory_cycles = 1}, link);
    const transputer::Word start = transputer::traits_of(options.model).memory_start;
    core.copy_to_memory(start, {file.data() + 1, loader});
    const transputer::CodeLines lines(place_table(code, *program, where_code_is(code, options) - start), "",
                                      transputer::most_negative + start);
    core.know_errors(lines);
    core.boot(static_cast<transputer::Word>(loader), 4);
    run_to_end(core, link);
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
    const auto memory =
        static_cast<transputer::Word>(where_code_is(code, options) + code.bytes.size() + code.vector_space_bytes);
    for (transputer::Word i = 0; i < words_of_results; ++i)
        done.results.push_back(static_cast<std::int32_t>(core.memory().word(memory + 4 * i)));
    return done;
}

} // namespace placedpar::test
