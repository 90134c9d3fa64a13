// This program measures how fast programs in occam are compiled and executed. The first programs run on one emulated
// T800-20. A row shows how many simulated seconds pass in a second of the host's processor. The ring has a process for
// each channel, and a token goes around once. The last row is a long program that is only checked and compiled.

#include "bench/measure.hpp"
#include "occam/check/check.hpp"
#include "occam/code/compile.hpp"
#include "occam/library/library.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/transputer/core.hpp"
#include "text/load_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::bench;
using namespace placedpar::transputer;

namespace {

constexpr double clock_hz = 20e6;
constexpr occam::CodeOptions options{.model = Model::t800};

/// Prints what is wrong and ends the program.
[[noreturn]] void give_up(const std::string& what) {
    fmt::print("{}\n", what);
    std::exit(1);
}

Image compiled(std::shared_ptr<const SourceFile> file) {
    occam::ParseOptions reading;
    reading.built_in = [](const std::string& name) { return occam::library_text(name); };
    Reporter reporter;
    occam::Parsed parsed = occam::parse(std::move(file), reading, reporter);
    if (!reporter.failed())
        occam::check(*parsed.program, parsed.options, reporter);
    if (reporter.failed())
        give_up(render(reporter.take()));
    return image_of(occam::compile(*parsed.program, *occam::main_procedure(*parsed.program), options), options);
}

/// A server at link 0 that takes no time. It grants every request; programs request only to write and to exit.
class Server final : public LinkEngines {
public:
    void begin_transfer(int channel, Word address, Word bytes) override {
        (channel == 0 ? output_ : input_) = std::pair<Word, Word>(NodeMemory::offset_of(address), bytes);
    }
    bool byte_waits(int) override { return false; }
    void reset(int) override {}

    /// Performs the transfer that the core waits for. Returns false if the program has ended, or waits for nothing.
    bool serve(Core& core) {
        if (output_) {
            const auto [offset, bytes] = *std::exchange(output_, std::nullopt);
            request_.resize(request_.size() + bytes);
            core.copy_from_memory(offset, {request_.data() + request_.size() - bytes, bytes});
            if (request_.size() > 2)
                answer();
            core.transfer_ended(0);
        } else if (input_ && input_->second <= answer_.size()) {
            const auto [offset, bytes] = *std::exchange(input_, std::nullopt);
            core.copy_to_memory(offset, {answer_.data(), bytes});
            answer_.erase(answer_.begin(), answer_.begin() + bytes);
            core.transfer_ended(4);
        } else {
            return false;
        }
        return !has_exited_;
    }
    bool has_exited() const { return has_exited_; }
    const std::string& text() const { return text_; }

private:
    /// Answers a request. A request is its length and a tag; a request to write also has the stream, the length of a
    /// text, and the text.
    void answer() {
        constexpr int write = 13, puts = 15, exit = 35;
        const int tag = request_[2];
        answer_ = {8, 0, 0, request_[7], request_[8], 0, 0, 0, 0, 0};
        if (tag == write || tag == puts)
            text_.append(request_.begin() + 9, request_.begin() + 9 + request_[7] + 256 * request_[8]);
        if (tag == puts)
            text_ += '\n';
        has_exited_ = tag == exit;
        request_.clear();
    }

    using Transfer = std::optional<std::pair<Word, Word>>; ///< offset in memory and bytes
    Transfer output_, input_;
    std::vector<std::uint8_t> request_, answer_;
    std::string text_;
    bool has_exited_ = false;
};

/// The output of a program, which usually prints its result and its ticks, and the time of its run.
struct Ran {
    std::string text;
    double simulated_s = 0, host_s = 0;
    std::uint64_t instructions = 0;
    double resident = 0; ///< bytes of the host at the end
};

Ran run(const Image& image, std::uint64_t memory_bytes) {
    Stopwatch watch;
    Server server;
    Core core(Model::t800, memory_bytes, {}, server);
    core.copy_to_memory(image.offset, image.code);
    core.copy_to_memory(traits_of(Model::t800).memory_start, image.start);
    core.boot(static_cast<Word>(image.start.size()), 0);
    constexpr HalfCycles most = 1'000'000'000'000;
    while (core.run(most) != Core::Pause::stopped && core.local() < most)
        if (!core.is_active() && !server.serve(core))
            break;
    if (!server.has_exited())
        give_up(core.stopped() == Stopped::nothing ? "the program waits for ever" : core.why_stopped());
    return {server.text(), static_cast<double>(core.busy()) / (2 * clock_hz), watch.seconds(), core.instructions(),
            resident_bytes()};
}

std::uint64_t fingerprint_of(const Ran& ran) {
    Fingerprint fingerprint;
    for (const char c : ran.text)
        fingerprint.mix(static_cast<std::uint64_t>(c));
    return fingerprint.value();
}

/// Runs a program of examples/occam/beside-inmos several times. `turns`: number of turns of its loop; 0 if the rate of
/// turns is not reported.
void measure_program(const std::string& name, long repeats, double turns) {
    const std::string path = fmt::format("{}/examples/occam/beside-inmos/{}.occ", PLACEDPAR_SOURCE_DIR, name);
    const LoadedSource source = load_source(path);
    if (has_errors(source.problems))
        give_up(render(source.problems));
    const Image image = compiled(source.file);
    double simulated_s = 0, host_s = 0;
    Ran ran;
    for (long i = 0; i < repeats; ++i) {
        ran = run(image, 1 << 20);
        simulated_s += ran.simulated_s;
        host_s += ran.host_s;
    }
    const std::string turn =
        turns > 0 ? fmt::format("{:.0f} ns a turn", host_s * 1e9 / (turns * static_cast<double>(repeats))) : "";
    fmt::print("{:<24} {:7.1f} simulated seconds a second   {:<14} fingerprint {:016x}\n", name, simulated_s / host_s,
               turn, fingerprint_of(ran));
}

/// A ring of processes, each of which adds 1 to a token. The program tells the host whether the sum is right.
std::string ring_of(long processes) {
    return fmt::format(R"(PROC main ()
  VAL n IS {}:
  [n]CHAN OF INT link:
  PAR
    PAR i = 0 FOR n - 1
      INT token:
      SEQ
        link[i] ? token
        link[i + 1] ! token + 1
    INT token:
    SEQ
      link[0] ! 1
      link[n - 1] ? token
      IF
        token = n
          SKIP
:
)",
                       processes);
}

void measure_ring(long processes) {
    const double before = resident_bytes();
    Stopwatch watch;
    const Image image = compiled(std::make_shared<SourceFile>("ring.occ", ring_of(processes)));
    const double compiling_s = watch.seconds();
    const std::uint64_t page = NodeMemory::page_bytes;
    const Ran ran = run(image, std::max<std::uint64_t>(2048, (image.bytes + page - 1) / page * page));
    const auto each = [&](double bytes) { return bytes / static_cast<double>(processes); };
    fmt::print("{} processes in a ring: compiled in {:.3f} s, once around in {:.2f} s, {:.1f} bytes of a transputer "
               "each   {} instructions\n",
               processes, compiling_s, ran.host_s, each(static_cast<double>(image.bytes)), ran.instructions);
    fmt::print("    and {:.0f} bytes of the host each\n", each(ran.resident - before));
}

/// Returns a program of about `lines` lines: copies of a procedure with declarations, loops, decisions, channels and
/// calls.
std::string long_program(long lines) {
    std::string text, calls;
    for (long i = 0; 30 * i < lines; ++i) {
        text += fmt::format(R"(PROC part.{0} (VAL INT limit, INT sum)
  [100]INT values:
  CHAN OF INT left, right:
  INT FUNCTION twice (VAL INT x) IS x + x:
  SEQ
    sum := 0
    SEQ i = 0 FOR 100
      IF
        ((i * {0}) \ 3) = 0
          values[i] := twice (i) + limit
        values[(i + 1) \ 100] > limit
          values[i] := (i /\ 15) >< limit
        TRUE
          values[i] := i - limit
    PAR
      SEQ i = 0 FOR 100
        left ! values[i]
      SEQ i = 0 FOR 100
        INT x:
        SEQ
          left ? x
          right ! x TIMES {0}
      SEQ i = 0 FOR 100
        INT x:
        SEQ
          right ? x
          sum := sum PLUS x
:
)",
                            i);
        calls += fmt::format("    part.{} (7, sum)\n", i);
    }
    return text + "PROC main ()\n  INT sum:\n  SEQ\n" + calls + ":\n";
}

void measure_compiler(long lines) {
    const std::string text = long_program(lines);
    const auto count = std::ranges::count(text, '\n');
    Stopwatch watch;
    const Image image = compiled(std::make_shared<SourceFile>("long.occ", text));
    fmt::print("{} lines: checked and compiled in {:.3f} s to {} bytes\n", count, watch.seconds(), image.code.size());
}

} // namespace

int main(int argc, char** argv) {
    const char* const usage = "occam [REPEATS [PROCESSES [LINES]]]";
    const long repeats = argument(argc, argv, 1, 10, usage);
    const long processes = argument(argc, argv, 2, 1'000'000, usage), lines = argument(argc, argv, 3, 5000, usage);
    measure_program("sieve", repeats, 0);
    measure_program("matrix32", repeats, 0);
    measure_program("ring-seq", repeats, 20'016);
    measure_program("ring-par", repeats, 20'016);
    measure_program("two-clients", repeats, 0);
    in_a_thread_of_its_own([processes] { measure_ring(processes); });
    measure_compiler(lines);
}
