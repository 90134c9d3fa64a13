#pragma once

#include <string>
#include <vector>

namespace placedpar {

/// An exercise of the course in occam in docs/occam-course.
struct Exercise {
    std::string number;   ///< page and number on the page, such as "3.2"
    std::string start;    ///< the program to start from; its first comment is the task
    std::string expected; ///< output of a correct solution

    /// Returns the title of the task: "An adder".
    std::string title() const;
};

/// Returns all exercises in the order of the course. The build embeds their files in the program.
std::vector<Exercise> exercises();
std::vector<std::string> numbers_of_exercises();
/// Throws UserError if there is no exercise of this number.
Exercise exercise_of(const std::string& number);

} // namespace placedpar
