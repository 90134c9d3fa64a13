#pragma once

namespace placedpar::test {

// Sanitizers make a test about ten times as slow, so sanitized builds run fewer cases.
#ifdef PLACEDPAR_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// Selects the cases to run: every n-th under sanitizers, otherwise all.
class EveryNth {
public:
    explicit EveryNth(int n) : n_(n) {}
    bool passes_over() { return sanitized && count_++ % n_ != 0; }

private:
    int n_, count_ = 0;
};

} // namespace placedpar::test
