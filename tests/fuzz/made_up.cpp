// Replaces libFuzzer where Clang is not installed: makes random changes to seeds. It takes libFuzzer's options:
//
//   PLACEDPAR_READER=NAME fuzz_ROOMS FOLDER -max_total_time=SECONDS -max_len=BYTES -artifact_prefix=PATH
//   PLACEDPAR_READER=NAME fuzz_ROOMS FILE    reads one input
//
// The n-th input depends only on the seeds, the largest size and n, so a failure can be reproduced. The input being
// read is kept in the file PATH + "input", which remains if the reader fails. An input may take at most a second of
// processor time, ten under sanitizers.

#include "tests/sanitized.hpp"

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

extern "C" int LLVMFuzzerInitialize(int*, char***);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t);

namespace {

namespace fs = std::filesystem;

constexpr int most_seconds = placedpar::test::sanitized ? 10 : 1; ///< processor time per input

struct Told {
    fs::path seeds;
    std::string prefix;
    std::size_t largest = 4096;
    double seconds = 1;
};

Told told(int argc, char** argv) {
    Told told;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const std::string value = word.substr(std::min(word.find('='), word.size() - 1) + 1);
        if (!word.starts_with('-'))
            told.seeds = word;
        else if (word.starts_with("-max_total_time="))
            told.seconds = std::stod(value);
        else if (word.starts_with("-max_len="))
            told.largest = std::stoul(value);
        else if (word.starts_with("-artifact_prefix="))
            told.prefix = value;
    }
    return told;
}

std::string content_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Returns an empty text, then the content of the folder's files in the order of their names.
std::vector<std::string> seeds_in(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder))
        paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<std::string> seeds(1);
    for (const fs::path& path : paths)
        seeds.push_back(content_of(path));
    return seeds;
}

/// A seed after a few changes.
class Mutation {
public:
    Mutation(const std::vector<std::string>& seeds, std::uint64_t number) : seeds_(seeds), random_(number) {}

    std::string text(std::size_t largest) {
        text_ = a_seed();
        for (std::size_t changes = below(6); changes-- > 0;)
            change();
        text_.resize(std::min(text_.size(), largest));
        return text_;
    }

private:
    std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }
    std::size_t place() { return below(text_.size() + 1); }
    const std::string& a_seed() { return seeds_[below(seeds_.size())]; }
    /// Returns a random piece of the text, usually of fewer than 16 bytes.
    std::string a_piece(const std::string& of) {
        const std::size_t begin = below(of.size() + 1);
        return of.substr(begin, below(below(4) == 0 ? of.size() + 1 : 16));
    }
    /// Returns a limit of a number type, a special character of the languages, or bytes that are not UTF-8.
    std::string a_word() {
        static const char* const words[] = {"0",
                                            "-1",
                                            "1e999",
                                            "nan",
                                            "18446744073709551616",
                                            "9223372036854775807",
                                            "\n",
                                            "\"",
                                            "\\",
                                            "{",
                                            "}",
                                            "[",
                                            "]",
                                            "(",
                                            ")",
                                            ",",
                                            "=",
                                            "..",
                                            "#",
                                            "/*",
                                            "\xff\xfe",
                                            "\xc3\xa9",
                                            "\t",
                                            "-0.0"};
        return words[below(std::size(words))];
    }

    void change() {
        switch (below(7)) {
        case 0:
            if (!text_.empty())
                text_[below(text_.size())] ^= static_cast<char>(1u << below(8));
            break;
        case 1:
            if (!text_.empty())
                text_[below(text_.size())] = static_cast<char>(below(256));
            break;
        case 2: text_.resize(place()); break;
        case 3: text_.erase(place(), below(16)); break;
        case 4: text_.insert(place(), a_word()); break;
        case 5: text_.insert(place(), a_piece(a_seed())); break;
        default: {
            const std::size_t at = place();
            text_.replace(at, below(16), a_piece(text_));
        }
        }
    }

    const std::vector<std::string>& seeds_;
    std::mt19937_64 random_;
    std::string text_;
};

/// Keeps the input being read in a file, so that it survives if the program dies.
class KeptInput {
public:
    explicit KeptInput(std::string path)
        : path_(std::move(path)), file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
    KeptInput(const KeptInput&) = delete;
    KeptInput& operator=(const KeptInput&) = delete;
    ~KeptInput() { ::close(file_); }

    void keep(const std::string& input) {
        if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, input.data(), input.size(), 0) < 0)
            throw std::runtime_error(path_ + " cannot be written");
    }
    void remove() const { fs::remove(path_); }

private:
    std::string path_;
    int file_;
};

/// Limits the processor time from now on: SIGPROF ends the program when it is used up. 0 removes the limit.
void allow(int seconds) {
    const itimerval time{{0, 0}, {seconds, 0}};
    ::setitimer(ITIMER_PROF, &time, nullptr);
}

void read(const std::string& input) {
    allow(most_seconds);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    allow(0);
}

/// Returns the seed with this number in an order in which neighbours, which are often alike, are far apart.
const std::string& scattered(const std::vector<std::string>& seeds, std::uint64_t number) {
    constexpr std::uint64_t stride = 7919; // a prime
    return seeds[number * stride % seeds.size()];
}

/// Reads seeds and changed seeds by turns until the time is over. Returns how many inputs were read, 0 after a failure.
std::uint64_t read_all(const Told& told, const std::vector<std::string>& seeds, KeptInput& kept) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(told.seconds);
    std::uint64_t count = 0;
    for (; count == 0 || std::chrono::steady_clock::now() < end; ++count) {
        const bool is_plain = count % 2 == 0 && count / 2 < seeds.size();
        const std::string input =
            is_plain ? scattered(seeds, count / 2).substr(0, told.largest) : Mutation(seeds, count).text(told.largest);
        kept.keep(input);
        try {
            read(input);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "input %llu: thrown: %s\n", static_cast<unsigned long long>(count), error.what());
            return 0;
        }
    }
    return count;
}

} // namespace

int main(int argc, char** argv) {
    LLVMFuzzerInitialize(&argc, &argv);
    const Told asked = told(argc, argv);
    if (fs::is_regular_file(asked.seeds)) {
        read(content_of(asked.seeds));
        return 0;
    }
    KeptInput kept(asked.prefix + "input");
    const std::uint64_t count = read_all(asked, seeds_in(asked.seeds), kept);
    if (count == 0)
        return 1;
    kept.remove();
    std::fprintf(stderr, "stat::number_of_executed_units: %llu\n", static_cast<unsigned long long>(count));
    return 0;
}
