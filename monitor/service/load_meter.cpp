#include "monitor/service/load_meter.hpp"

#include <algorithm>
#include <ctime>

namespace placedpar::monitor {

namespace {

double thread_cpu_s() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

LoadMeter::LoadMeter() { start_ = last_ = read(); }

LoadMeter::Totals LoadMeter::read() const {
    Totals totals = now_;
    totals.time = Clock::now();
    totals.cpu_s = thread_cpu_s();
    return totals;
}

void LoadMeter::count_sample(std::size_t generations) {
    ++now_.samples;
    now_.generations += generations;
}

void LoadMeter::count_work(Clock::duration spent) {
    now_.work_s += std::chrono::duration<double>(spent).count();
    count_turn(spent);
}

void LoadMeter::count_turn(Clock::duration spent) {
    longest_turn_s_ = std::max(longest_turn_s_, std::chrono::duration<double>(spent).count());
}

LoadRates LoadMeter::between(const Totals& from, const Totals& to) {
    double over_s = std::chrono::duration<double>(to.time - from.time).count();
    if (over_s <= 0)
        return {};
    auto rate = [&](std::uint64_t before, std::uint64_t after) { return static_cast<double>(after - before) / over_s; };
    return {over_s, rate(from.samples, to.samples), rate(from.generations, to.generations),
            (to.work_s - from.work_s) / over_s, (to.cpu_s - from.cpu_s) / over_s};
}

void LoadMeter::tick() {
    if (Clock::now() - last_.time < std::chrono::seconds(1))
        return;
    Totals totals = read();
    rates_ = between(last_, totals);
    last_ = totals;
}

Load LoadMeter::load() const {
    Totals totals = read();
    Load load;
    load.rates = rates_.over_s > 0 ? rates_ : between(start_, totals);
    load.samples = totals.samples;
    load.generations = totals.generations;
    load.work_s = totals.work_s;
    load.cpu_s = totals.cpu_s;
    load.longest_turn_s = longest_turn_s_;
    load.uptime_s = std::chrono::duration<double>(totals.time - start_.time).count();
    return load;
}

} // namespace placedpar::monitor
