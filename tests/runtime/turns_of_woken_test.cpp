// Tests the order of turns on a kernel of a native run: neither processes that others wake nor those that are always
// ready wait for ever.

#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"
#include "runtime/simulation.hpp"
#include "runtime/surroundings.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <deque>
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

/// Runs processes that others always wake, and pairs of processes of which one is always ready, since they communicate.
/// Returns a letter for each message. In a turn, one of a pair receives or sends at most two.
std::string messages_of(int woken, int pairs) {
    constexpr int messages = 40;
    Simulation simulation;
    EagerSurroundings others(simulation);
    std::deque<Channel<int>> channels;
    std::string course;
    const auto is_woken = [&] {
        for (int i = 0; i < messages; ++i) {
            others.wait_for_message();
            course += 'w';
        }
    };
    for (int i = 0; i < woken; ++i)
        simulation.process("woken", is_woken);
    for (int i = 0; i < pairs; ++i) {
        Channel<int>& channel = channels.emplace_back("between two");
        simulation.process("sender", [&] {
            for (int j = 0; j < messages; ++j) {
                channel.out().output(j);
                course += 'r';
            }
        });
        simulation.process("receiver", [&] {
            for (int j = 0; j < messages; ++j) {
                channel.in().input();
                course += 'r';
            }
        });
    }
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(course.size() == static_cast<std::size_t>(messages * (woken + 2 * pairs)));
    return course;
}

} // namespace

TEST_CASE("processes that are always ready have every ninth turn among processes that others always wake") {
    const std::string course = messages_of(20, 1);
    const std::size_t first = course.find('r'), last = course.rfind('r');
    const std::string while_both = course.substr(first, last - first);
    CHECK(while_both.find("wwwwwwww") != std::string::npos);
    CHECK(while_both.find("wwwwwwwww") == std::string::npos);
}

TEST_CASE("a process that others wake is next, however many processes are always ready") {
    const std::string course = messages_of(1, 20);
    const std::string while_both = course.substr(0, course.rfind('w'));
    CHECK(while_both.find("rrr", while_both.find('w')) == std::string::npos);
}
