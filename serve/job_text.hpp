#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::serve {

/// A job, as serve/answer.hpp describes its members.
struct Job {
    std::string task, main, exercise, keys;
    std::vector<std::pair<std::string, std::string>> files; ///< names and texts
    std::optional<std::string> expected = {};
    std::uint64_t seed = 1;
};

/// Reads a job. Throws std::invalid_argument if the text is not JSON or not a job, or if the job has more than
/// `most_files` files. The message names the member that is wrong.
Job job_of(const std::string& text, std::size_t most_files = std::numeric_limits<std::size_t>::max());
bool is_job(const std::string& text);

} // namespace placedpar::serve
