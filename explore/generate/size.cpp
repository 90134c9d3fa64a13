#include "explore/generate/size.hpp"

#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace placedpar::generate {

namespace {

/// Returns the numbers of a size such as "2x3x4". Returns 0 for each part that is not a whole number.
std::vector<std::size_t> numbers_of(const TopologyRequest& request) {
    std::vector<std::size_t> numbers;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = request.size.find('x', begin);
        numbers.push_back(parse_number<std::size_t>(request.size.substr(begin, end - begin)).value_or(0));
    }
    return numbers;
}

void require_not_huge(const TopologyRequest& request, const std::vector<std::size_t>& factors) {
    std::size_t processors = 1;
    for (const std::size_t each : factors)
        if (each > most_processors || (processors *= each) > most_processors)
            refuse_size(request, fmt::format("a generated machine has at most {} processors", most_processors));
}

} // namespace

void refuse_size(const TopologyRequest& request, const std::string& why) {
    throw UserError(fmt::format("{} of size {}: {}", request.topology, request.size, why));
}

std::size_t count_of(const TopologyRequest& request, std::size_t least) {
    const std::vector<std::size_t> numbers = numbers_of(request);
    if (numbers.size() != 1 || numbers[0] < std::max<std::size_t>(least, 1))
        refuse_size(request, fmt::format("expected a number of processors, from {} to {}", least, most_processors));
    require_not_huge(request, numbers);
    return numbers[0];
}

bool has_three_dimensions(const TopologyRequest& request) { return numbers_of(request).size() == 3; }

Box box_of(const TopologyRequest& request) {
    const std::vector<std::size_t> numbers = numbers_of(request);
    if (std::ranges::count(numbers, 0) > 0)
        refuse_size(request, "expected three numbers of at least 1, such as 2x3x4");
    require_not_huge(request, {2, numbers[0], numbers[1], numbers[2]});
    return {numbers[0], numbers[1], numbers[2]};
}

std::size_t product_of_size(const TopologyRequest& request) {
    const std::vector<std::size_t> numbers = numbers_of(request);
    return std::accumulate(numbers.begin(), numbers.end(), std::size_t{1}, std::multiplies());
}

Grid grid_of(const TopologyRequest& request, std::size_t least_rows, std::size_t least_columns) {
    const std::vector<std::size_t> numbers = numbers_of(request);
    if (numbers.size() == 3)
        refuse_size(request,
                    fmt::format("a node of three dimensions needs six links, but a transputer has {}; only the "
                                "topology mesh builds each node from two processors",
                                links_of_a_node));
    if (numbers.size() != 2 || numbers[0] < least_rows || numbers[1] < least_columns)
        refuse_size(request,
                    fmt::format("expected two numbers such as 4x4, at least {}x{}", least_rows, least_columns));
    require_not_huge(request, numbers);
    return {numbers[0], numbers[1]};
}

} // namespace placedpar::generate
