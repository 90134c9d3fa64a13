// Tests the sizes of machines as a user types them: `--size 8`, `--size 4x4`, `--size 2x3x4`.

#include "explore/generate/size.hpp"

#include "explore/generate/topology_request.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace placedpar::generate;

namespace {

TopologyRequest mesh_of_size(const std::string& size) {
    TopologyRequest request;
    request.topology = "mesh";
    request.size = size;
    return request;
}

} // namespace

TEST_CASE("a number of processors is accepted from the least number that a topology needs up to 4096") {
    CHECK(count_of(mesh_of_size("1"), 1) == 1);
    CHECK(count_of(mesh_of_size("3"), 3) == 3);
    CHECK(count_of(mesh_of_size("4096"), 3) == 4096);
    CHECK_THROWS_WITH_AS(count_of(mesh_of_size("2"), 3),
                         "mesh of size 2: expected a number of processors, from 3 to 4096", UserError);
    CHECK_THROWS_WITH_AS(count_of(mesh_of_size("4097"), 3),
                         "mesh of size 4097: a generated machine has at most 4096 processors", UserError);
    CHECK_THROWS_WITH_AS(count_of(mesh_of_size("0"), 0),
                         "mesh of size 0: expected a number of processors, from 0 to 4096", UserError);
    CHECK_THROWS_AS(count_of(mesh_of_size("2x2"), 1), UserError);
}

TEST_CASE("a grid has rows and columns, each at least as many as the topology needs") {
    const Grid grid = grid_of(mesh_of_size("3x5"), 3, 5);
    CHECK(grid.rows == 3);
    CHECK(grid.columns == 5);
    CHECK(grid_of(mesh_of_size("1x4096"), 1, 1).columns == 4096);
    CHECK(grid_of(mesh_of_size("64x64"), 1, 1).rows == 64);
    for (const char* size : {"3", "2x5", "3x4", "x", "3x", "x5", "3x5x", "-3x5", "3 x5", "3X5"})
        CHECK_THROWS_AS(grid_of(mesh_of_size(size), 3, 5), UserError);
    CHECK_THROWS_WITH_AS(grid_of(mesh_of_size("64x65"), 1, 1), doctest::Contains("at most 4096 processors"), UserError);
}

TEST_CASE("a size whose product exceeds 64 bits is refused, and is not taken for a small size") {
    // In 64 bits the products are 0 and 2.
    for (const char* size : {"4294967296x4294967296", "9223372036854775809x2"})
        CHECK_THROWS_WITH_AS(grid_of(mesh_of_size(size), 1, 1), doctest::Contains("at most 4096 processors"),
                             UserError);
    CHECK_THROWS_WITH_AS(box_of(mesh_of_size("4194304x2097152x2097152")), doctest::Contains("at most 4096 processors"),
                         UserError);
}

TEST_CASE("a mesh of three dimensions has two processors at each node") {
    CHECK(has_three_dimensions(mesh_of_size("2x3x4")));
    CHECK_FALSE(has_three_dimensions(mesh_of_size("2x3")));
    CHECK_FALSE(has_three_dimensions(mesh_of_size("2x3x4x5")));
    const Box box = box_of(mesh_of_size("2x3x4"));
    CHECK(box.planes == 2);
    CHECK(box.rows == 3);
    CHECK(box.columns == 4);
    CHECK(box_of(mesh_of_size("8x16x16")).planes == 8); // 4096 processors
    CHECK_THROWS_AS(box_of(mesh_of_size("9x16x16")), UserError);
    CHECK_THROWS_WITH_AS(box_of(mesh_of_size("2xx4")),
                         "mesh of size 2xx4: expected three numbers of at least 1, such as 2x3x4", UserError);
}

TEST_CASE("the product of a size counts its nodes, whatever the number of dimensions") {
    CHECK(product_of_size(mesh_of_size("7")) == 7);
    CHECK(product_of_size(mesh_of_size("7x3")) == 21);
    CHECK(product_of_size(mesh_of_size("7x3x2")) == 42);
}
