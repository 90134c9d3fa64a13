#pragma once

#include "runtime/event.hpp"
#include "runtime/link_timing.hpp"

namespace placedpar {

class Kernel;

/// A direction of a link, as one of the two users of a wire.
class WireUser {
public:
    /// The wire has begun to carry this direction's byte, or its acknowledge.
    virtual void byte_started() = 0;
    virtual void acknowledge_started() = 0;

protected:
    ~WireUser() = default;
};

/// One wire of a link: it carries the bytes of one direction and the acknowledges of the other, one packet
/// after the other. An acknowledge goes before a byte that waits as well.
class Wire {
public:
    Wire(Kernel& kernel, const LinkTiming& timing) : kernel_(kernel), timing_(timing) {}

    void ask_for_byte(WireUser& user) {
        byte_for_ = &user;
        serve();
    }
    void ask_for_acknowledge(WireUser& user) {
        acknowledge_for_ = &user;
        serve();
    }

private:
    struct Freed final : Event {
        explicit Freed(Wire& w) : wire(w) {}
        void happen() noexcept override { wire.serve(); }
        Wire& wire;
    };
    void serve();

    Kernel& kernel_;
    const LinkTiming& timing_;
    Time free_at_{};
    WireUser* byte_for_ = nullptr;
    WireUser* acknowledge_for_ = nullptr;
    Freed freed_{*this};
};

} // namespace placedpar
