#pragma once

#include "text/texts_in_memory.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace placedpar::serve {

/// A job, as serve/answer.hpp describes its members.
struct Job {
    std::string task, main, exercise, keys;
    TextsInMemory files;
    std::size_t count_of_files = 0;
    std::optional<std::string> expected = {};
    std::uint64_t seed = 1;
};

/// Reads a job. Throws std::invalid_argument if the text is not JSON or not a job; the message names the member.
Job job_of(const std::string& text);
bool is_job(const std::string& text);

} // namespace placedpar::serve
