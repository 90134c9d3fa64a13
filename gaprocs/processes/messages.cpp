#include "gaprocs/processes/messages.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

namespace placedpar {

std::uint32_t message_bytes(std::size_t individuals, std::uint32_t bytes_each, std::uint32_t others) {
    auto bytes = static_cast<std::int64_t>(individuals) * bytes_each + others;
    if (bytes > largest_message_bytes)
        throw UserError(fmt::format("a message for {} would have {} bytes, but a message can have at most {}",
                                    counted(individuals, "individual"), bytes, largest_message_bytes));
    return static_cast<std::uint32_t>(bytes);
}

} // namespace placedpar
