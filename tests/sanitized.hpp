#pragma once

namespace placedpar::test {

// Sanitizers make a test some ten times as slow: what is tried there by the hundred, other builds try by the thousand.
#ifdef PLACEDPAR_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// Of cases that are counted: under sanitizers every n-th, else each.
class EveryNth {
public:
    explicit EveryNth(int n) : n_(n) {}
    bool passes_over() { return sanitized && count_++ % n_ != 0; }

private:
    int n_, count_ = 0;
};

} // namespace placedpar::test
