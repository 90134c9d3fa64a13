#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include <algorithm>
#include <concepts>
#include <utility>
#include <vector>

namespace placedpar::hydraulics {

/// A system of ordinary differential equations that is smooth except at events: a valve opens or shuts, a curve has a
/// knee, or a command begins. Its `Mode` states, for example, which valves are open. While the mode is unchanged, the
/// system is smooth.
template <typename S>
concept ModalSystem = requires(S system, const std::vector<double>& state, std::vector<double>& rate, double time_s) {
    { system.rate(state, rate, time_s) } -> std::same_as<typename S::Mode>;
    requires std::equality_comparable<typename S::Mode>;
};

/// Integrates a ModalSystem by the classical Runge-Kutta method of order 4 (Boost.Odeint). The method has order 4 only
/// where the system is smooth. Therefore a step ends at each event, and the next step begins there.
///
/// A step is clean if all its stages and its end have the mode of its beginning.
/// 1. Try one step to the end of the demanded time.
/// 2. If it is unclean, bisect to the longest clean step, take that step, and continue from its end.
/// 3. If even a step of length resolution_s is unclean, take this step, a hop, across the event. Each further hop is
///    twice as long, until a step is clean again. Time therefore advances even if events never end.
/// 4. If one call of advance_to() needs too many steps and hops, for example because a valve chatters, step to the end
///    regardless of events.
///
/// If two events cancel each other between the stages of one step, the method does not notice them. Choose steps
/// shorter than the time between such events.
template <ModalSystem System>
class EventStepper {
public:
    using State = std::vector<double>;
    using Mode = typename System::Mode;

    /// The length of the first hop. Times of events have this accuracy, so that the error of the state is far below the
    /// resolution of any reading.
    static constexpr double resolution_s = 1e-12;

    /// `most_pieces` is the largest number of pieces, that is, steps and hops, in one call of advance_to().
    /// `pieces_a_call` is the largest average number over many calls. An event takes about 5 pieces.
    static constexpr double most_pieces = 64, pieces_a_call = 0.5;

    EventStepper(const System& system, State state, double time_s)
        : system_(system), now_{std::move(state), {}, {}}, time_s_(time_s) {
        now_.rate.resize(now_.state.size());
        system_changed();
    }

    const State& state() const { return now_.state; }
    const Mode& mode() const { return now_.mode; }
    double time_s() const { return time_s_; }

    /// Call this function after the system's equations have changed.
    void system_changed() { now_.mode = system_.rate(now_.state, now_.rate, time_s_); }

    /// Advances to `end_s`; calls event(time_s, mode before, mode after) at each event.
    template <typename Event>
    void advance_to(double end_s, Event event) {
        allowance_ = std::min(allowance_ + pieces_a_call, most_pieces);
        double hop_s = resolution_s;
        while (time_s_ < end_s) {
            double rest_s = end_s - time_s_;
            if (rest_s <= hop_s || clean(rest_s) || allowance_ < 1) {
                accept(end_s, rest_s, event);
                return;
            }
            bool hopping = !clean(hop_s);
            allowance_ -= 1;
            double step_s = hopping ? hop_s : long_clean(hop_s, rest_s);
            accept(time_s_ + step_s, step_s, event);
            hop_s = hopping ? 2 * hop_s : resolution_s;
        }
    }

private:
    struct Point {
        State state, rate;
        Mode mode;
    };

    /// Tries a step from the present state, and stores the state at the end of the step in `next_`.
    bool clean(double step_s) {
        tried_s_ = step_s;
        bool same = true;
        auto rate = [&](const State& state, State& derivative, double time_s) {
            same &= system_.rate(state, derivative, time_s) == now_.mode;
        };
        next_.state.resize(now_.state.size());
        next_.rate.resize(now_.state.size());
        stepper_.do_step(rate, now_.state, now_.rate, time_s_, next_.state, step_s);
        next_.mode = system_.rate(next_.state, next_.rate, time_s_ + step_s);
        return same && next_.mode == now_.mode;
    }

    /// Returns a clean step that is shorter than the longest clean step by at most about a thousandth.
    double long_clean(double clean_s, double unclean_s) {
        while (unclean_s - clean_s > std::max(resolution_s, unclean_s / 1024)) {
            double middle_s = clean_s + (unclean_s - clean_s) / 2;
            (clean(middle_s) ? clean_s : unclean_s) = middle_s;
        }
        return clean_s;
    }

    template <typename Event>
    void accept(double end_s, double step_s, Event& event) {
        if (tried_s_ != step_s)
            clean(step_s);
        time_s_ = end_s;
        tried_s_ = 0;
        std::swap(now_, next_);
        if (now_.mode != next_.mode)
            event(time_s_, next_.mode, now_.mode);
    }

    const System& system_;
    boost::numeric::odeint::runge_kutta4<State> stepper_;
    Point now_, next_;
    double time_s_;
    double allowance_ = most_pieces; ///< number of pieces that may still be made
    double tried_s_ = 0;             ///< length of the step to `next_`; 0: none has been tried from the present state
};

} // namespace placedpar::hydraulics
