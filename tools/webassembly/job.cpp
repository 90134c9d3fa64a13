#include "explore/netlist_run.hpp"
#include "serve/answer.hpp"

#include <boost/json/src.hpp>

#include <csignal>
#include <iostream>
#include <iterator>
#include <string>

/// Emscripten declares this function without defining it. WebAssembly has no signals that would need another stack.
extern "C" int sigaltstack(const stack_t*, stack_t*) { return -1; }

/// Reads a job from standard input, and writes the answer to standard output, as `placedpar serve --job` does.
int main() {
    constexpr std::uint64_t most_megabytes = 2048; // -sMAXIMUM_MEMORY of the linker
    const std::string job(std::istreambuf_iterator<char>(std::cin), {});
    placedpar::Interruption never;
    std::cout << placedpar::serve::answer_of(job, most_megabytes, never) << std::endl;
}
