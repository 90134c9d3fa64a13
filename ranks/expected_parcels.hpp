#pragma once

#include "ranks/rank_mail.hpp"

#include <algorithm>
#include <cstddef>
#include <list>
#include <optional>
#include <utility>

namespace placedpar {

/// The parcels that a rank expects, each with the MPI request that receives its bytes. A rank is a copy of the program,
/// started by mpirun; a parcel is a message of any length (RankMail). Parcels with the same sender and number are
/// returned in the order in which they were expected, even if MPI completes a later request earlier.
template <class Request>
class ExpectedParcels {
public:
    struct Expected {
        RankParcel parcel; ///< with memory for its bytes
        Request request{};
    };

    Expected& add(int from, int number, std::size_t bytes) {
        return expected_.emplace_back(Expected{{from, number, std::vector<std::uint8_t>(bytes)}, {}});
    }
    bool empty() const { return expected_.empty(); }
    /// Returns the first parcel that has arrived; nothing if none has arrived. `is_complete` returns whether the parcel
    /// of an Expected has arrived.
    template <class IsComplete>
    std::optional<RankParcel> take(IsComplete is_complete) {
        for (auto each = expected_.begin(); each != expected_.end(); ++each)
            if (is_next_of_its_number(*each) && is_complete(*each)) {
                std::optional<RankParcel> parcel = std::move(each->parcel);
                expected_.erase(each);
                return parcel;
            }
        return std::nullopt;
    }

private:
    bool is_next_of_its_number(const Expected& expected) const {
        const auto first = std::ranges::find_if(expected_, [&](const Expected& each) {
            return each.parcel.from == expected.parcel.from && each.parcel.number == expected.parcel.number;
        });
        return &*first == &expected;
    }

    std::list<Expected> expected_; ///< at fixed addresses, because the requests write to them
};

} // namespace placedpar
