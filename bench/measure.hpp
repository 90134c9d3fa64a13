#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

namespace placedpar::bench {

/// Measures the processor time since its construction, which other programs disturb less than wall-clock time.
class Stopwatch {
public:
    double nanoseconds() const { return static_cast<double>(now() - start_); }
    double seconds() const { return nanoseconds() * 1e-9; }

private:
    static std::int64_t now() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
    }
    std::int64_t start_ = now();
};

/// Returns the bytes of memory that the program uses at present (Linux).
inline double resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Calls the measurement in a new thread. A thread keeps stacks for its next simulation. A new thread has none, so the
/// memory that the simulation needs can be measured.
template <class Measurement>
void in_a_thread_of_its_own(Measurement measurement) {
    std::thread(measurement).join();
}

/// Prints one row of a benchmark's table.
inline void report(const std::string& what, double nanoseconds_per_event, double bytes_per_process,
                   std::uint64_t fingerprint) {
    fmt::print("{:<38} {:8.1f} ns/event   {:8.0f} bytes/process   fingerprint {:016x}\n", what, nanoseconds_per_event,
               bytes_per_process, fingerprint);
}

/// Returns argument number i, or `usual` if it is missing. Ends the program if the argument is not a number of at least
/// 1.
inline long argument(int argc, char** argv, int i, long usual, const char* usage) {
    if (i >= argc)
        return usual;
    char* end = nullptr;
    long value = std::strtol(argv[i], &end, 10);
    if (value >= 1 && *end == '\0')
        return value;
    fmt::print(stderr, "usage: {}\n", usage);
    std::exit(1);
}

} // namespace placedpar::bench
