// Tests the order of turns on a kernel of a native run: neither processes that others wake nor those that are always
// ready wait for ever.

#include "runtime/kernel.hpp"
#include "runtime/process.hpp"
#include "runtime/simulation.hpp"
#include "runtime/surroundings.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

/// Other kernels whose messages wake each process that waits for them at once.
class EagerSurroundings final : public Surroundings {
public:
    explicit EagerSurroundings(Simulation& simulation) : simulation_(simulation) { simulation.run_among(*this, 0); }
    /// Lets the running process wait for a message.
    void wait_for_message() {
        Process& self = Kernel::here().running();
        waiting_.push_back(&self);
        self.wait_for(Activity::inputting, nullptr, SourceLocation::current());
    }
    Time now() const override { return std::chrono::steady_clock::now() - begun_; }
    void take_arrivals() noexcept override {
        for (Process* const each : std::exchange(waiting_, {}))
            each->kernel().make_ready(*each);
    }
    Rest rest(Time, bool) override { return waiting_.empty() ? Rest::forever : Rest::over; }
    void wait_for_stop(bool) override {}
    std::vector<const Kernel*> kernels() const override { return {&simulation_.kernel()}; }
    void wait_for_reports() override {}

private:
    Simulation& simulation_;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
    std::vector<Process*> waiting_;
};

/// Runs processes that others always wake, and processes that are always ready. Returns a letter for each turn.
std::string turns_of(int woken, int ready) {
    constexpr int rounds = 40;
    Simulation simulation;
    EagerSurroundings others(simulation);
    std::string turns;
    const auto is_woken = [&] {
        for (int i = 0; i < rounds; ++i) {
            others.wait_for_message();
            turns += 'w';
        }
    };
    const auto is_ready = [&] {
        for (int i = 0; i < rounds; ++i) {
            wait_until(Time{});
            turns += 'r';
        }
    };
    for (int i = 0; i < woken; ++i)
        simulation.process("woken", is_woken);
    for (int i = 0; i < ready; ++i)
        simulation.process("ready", is_ready);
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(turns.size() == static_cast<std::size_t>(rounds * (woken + ready)));
    return turns;
}

} // namespace

TEST_CASE("a process that is always ready has every ninth turn among processes that others always wake") {
    CHECK(turns_of(10, 1).substr(0, 36) == "wwwwwwwwrwwwwwwwwrwwwwwwwwrwwwwwwwwr");
}

TEST_CASE("a process that others wake is next, however many processes are always ready") {
    const std::string turns = turns_of(1, 10).substr(0, 78);
    for (std::size_t i = 0; i < turns.size(); i += 2)
        CHECK(turns.substr(i, 2) == "wr");
}
