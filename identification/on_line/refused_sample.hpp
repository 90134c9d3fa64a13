#pragma once

#include "hydraulics/data/link.hpp"
#include "text/user_error.hpp"

#include <variant>

namespace placedpar::identification {

/// Why a sample is refused.
struct NoConfiguration {}; ///< none has been given yet
struct LinkNotRead {
    hydraulics::Link link; ///< active, but without a reading
};
struct TimeNotLater {
    double time_s;      ///< of the sample
    double last_time_s; ///< of the sample before it
};

/// A sample that the diagnosis cannot take, and has not taken. what() is a sentence for people.
class RefusedSample : public UserError {
public:
    using Reason = std::variant<NoConfiguration, LinkNotRead, TimeNotLater>;

    explicit RefusedSample(const Reason& reason);
    const Reason& reason() const { return reason_; }

private:
    Reason reason_;
};

} // namespace placedpar::identification
