#include "occam/language/tree.hpp"

#include <doctest/doctest.h>

using namespace placedpar::occam;

TEST_CASE("a type is made once, and names itself as the language does") {
    Types types;
    const Type* const bytes = types.array(types.basic(Basic::byte), std::nullopt);
    CHECK(bytes == types.array(types.basic(Basic::byte), std::nullopt));
    CHECK(bytes != types.array(types.basic(Basic::byte), 4));
    CHECK(name_of(*types.array(bytes, 4)) == "[4][]BYTE");
    const ProtocolType* const counted =
        types.protocol({.kind = ProtocolType::Kind::sequence, .items = {{bytes, types.basic(Basic::integer)}}});
    CHECK(name_of(*types.channel(counted)) == "CHAN OF INT::[]BYTE");
    CHECK(bytes_of(*types.array(types.array(types.basic(Basic::real64), 3), 2)) == 48);
}
