#pragma once

#include "hydraulics/data/link.hpp"
#include "text/user_error.hpp"

#include <variant>

namespace placedpar::identification {

/// These types are the reasons why the on-line diagnosis refuses a sample of an excavator.
struct NoConfiguration {}; ///< no configuration has been set yet
struct LinkNotRead {
    hydraulics::Link link; ///< an active link without a reading
};
struct TimeNotLater {
    double time_s;      ///< time of the sample
    double last_time_s; ///< time of the previous sample
};

/// Reports a sample that the diagnosis refused; what() is a sentence for the user.
class RefusedSample : public UserError {
public:
    using Reason = std::variant<NoConfiguration, LinkNotRead, TimeNotLater>;

    explicit RefusedSample(const Reason& reason);
    const Reason& reason() const { return reason_; }

private:
    Reason reason_;
};

} // namespace placedpar::identification
