#include "explore/generate/size.hpp"

#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::generate {

namespace {

/// Returns the number; 0 if the text is not a whole number that could be a size.
std::size_t number_of(const std::string& text) { return parse_number<std::size_t>(text).value_or(0); }

void require_not_huge(const TopologyRequest& request, std::size_t processors) {
    if (processors > most_processors)
        refuse_size(request, fmt::format("a generated machine has at most {} processors", most_processors));
}

} // namespace

void refuse_size(const TopologyRequest& request, const std::string& why) {
    throw UserError(fmt::format("{} of size {}: {}", request.topology, request.size, why));
}

std::size_t count_of(const TopologyRequest& request, std::size_t least) {
    std::size_t count = number_of(request.size);
    if (count < least || count == 0)
        refuse_size(request, fmt::format("expected a number of processors, from {} to {}", least, most_processors));
    require_not_huge(request, count);
    return count;
}

bool has_three_dimensions(const TopologyRequest& request) { return std::ranges::count(request.size, 'x') == 2; }

Box box_of(const TopologyRequest& request) {
    const std::size_t first = request.size.find('x'), second = request.size.find('x', first + 1);
    const Box box{number_of(request.size.substr(0, first)),
                  number_of(request.size.substr(first + 1, second - first - 1)),
                  number_of(request.size.substr(second + 1))};
    for (const std::size_t length : {box.planes, box.rows, box.columns}) {
        if (length == 0)
            refuse_size(request, "expected three numbers such as 2x3x4");
        require_not_huge(request, length);
    }
    require_not_huge(request, 2 * box.planes * box.rows * box.columns);
    return box;
}

std::size_t product_of_size(const TopologyRequest& request) {
    std::size_t product = 1;
    for (std::size_t begin = 0; begin < request.size.size();) {
        const std::size_t end = std::min(request.size.find('x', begin), request.size.size());
        product *= number_of(request.size.substr(begin, end - begin));
        begin = end + 1;
    }
    return product;
}

Grid grid_of(const TopologyRequest& request, std::size_t least_rows, std::size_t least_columns) {
    if (has_three_dimensions(request))
        refuse_size(request,
                    fmt::format("a node of three dimensions needs six links, but a transputer has {}; only the "
                                "topology mesh builds each node from two processors",
                                links_of_a_node));
    auto cross = request.size.find('x');
    std::string columns = cross == std::string::npos ? "" : request.size.substr(cross + 1);
    Grid grid{number_of(request.size.substr(0, cross)), number_of(columns)};
    if (grid.rows < least_rows || grid.columns < least_columns)
        refuse_size(request,
                    fmt::format("expected two numbers such as 4x4, at least {}x{}", least_rows, least_columns));
    require_not_huge(request, grid.rows);
    require_not_huge(request, grid.columns);
    require_not_huge(request, grid.rows * grid.columns);
    return grid;
}

} // namespace placedpar::generate
