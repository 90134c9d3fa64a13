#include "explore/exercise/course.hpp"

#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

std::string Exercise::title() const {
    const std::string heading = start.substr(0, start.find('\n'));
    return heading.substr(std::min(heading.size(), heading.find(": ") + 2));
}

std::vector<std::string> numbers_of_exercises() {
    std::vector<std::string> numbers;
    for (const Exercise& each : exercises())
        numbers.push_back(each.number);
    return numbers;
}

Exercise exercise_of(const std::string& number) {
    const std::vector<Exercise> all = exercises();
    const auto found = std::ranges::find(all, number, &Exercise::number);
    if (found == all.end())
        throw UserError(fmt::format("there is no exercise \"{}\"; the exercises are {} to {}", number,
                                    all.front().number, all.back().number));
    return *found;
}

} // namespace placedpar
