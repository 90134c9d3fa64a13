#pragma once

namespace placedpar {

/// Numbers of floating-point operations.
struct Operations {
    double additions = 0, multiplications = 0, divisions = 0;

    double all() const { return additions + multiplications + divisions; }
    /// Returns the cycles on a T800 in single precision (instruction table: 6, 11 and 16, typically), each operation
    /// with the load of one operand, fpldnlsn after ldl.
    double t800_cycles() const { return 4 * all() + 6 * additions + 11 * multiplications + 16 * divisions; }
};

/// A number whose operations are counted in its thread. A change of sign counts as none.
class Counted {
public:
    Counted(double value = 0) : value_(value) {}
    explicit operator int() const { return static_cast<int>(value_); }

    /// Returns the operations that `work` takes.
    template <class Work>
    static Operations in(Work work) {
        counts() = {};
        work();
        return counts();
    }

    Counted operator-() const { return -value_; }
    friend Counted abs(Counted a) { return a.value_ < 0 ? -a.value_ : a.value_; }
    friend Counted operator+(Counted a, Counted b) { return one_of(&Operations::additions, a.value_ + b.value_); }
    friend Counted operator-(Counted a, Counted b) { return one_of(&Operations::additions, a.value_ - b.value_); }
    friend Counted operator*(Counted a, Counted b) { return one_of(&Operations::multiplications, a.value_ * b.value_); }
    friend Counted operator/(Counted a, Counted b) { return one_of(&Operations::divisions, a.value_ / b.value_); }
    Counted& operator+=(Counted b) { return *this = *this + b; }
    Counted& operator-=(Counted b) { return *this = *this - b; }

private:
    static Operations& counts() {
        thread_local Operations done;
        return done;
    }
    static Counted one_of(double Operations::*kind, double result) {
        ++(counts().*kind);
        return result;
    }

    double value_;
};

} // namespace placedpar
