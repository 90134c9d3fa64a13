#pragma once

// The parts of C++20's library that Emscripten 3.1.6 of Debian 12 lacks and that the rooms use. The compiler includes
// this file before each source. A later Emscripten has them all.

#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>
#include <limits>
#include <ranges>
#include <span>
#include <utility>
namespace std {
template <class To, class From>
requires(sizeof(To) == sizeof(From)) constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
} // namespace std
#include <charconv>
#include <compare>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>
namespace std {
template <class T, class A>
strong_ordering operator<=>(const vector<T, A>& a, const vector<T, A>& b) {
    return a < b ? strong_ordering::less : b < a ? strong_ordering::greater : strong_ordering::equal;
}
inline namespace __fs {
namespace filesystem {
inline strong_ordering operator<=>(const path& a, const path& b) { return a.compare(b) <=> 0; }
/// Takes the place of weakly_canonical(), which fails here. There are no files, so no links either.
inline path canonical_in_memory(const path& p, error_code& error) {
    error.clear();
    return (p.is_absolute() ? p : "/" / p).lexically_normal();
}
} // namespace filesystem
} // namespace __fs
inline strong_ordering operator<=>(const string& a, const string& b) { return a.compare(b) <=> 0; }
template <class Real>
requires is_floating_point_v<Real> from_chars_result from_chars(const char* begin, const char* end, Real& value) {
    const string text(begin, end);
    char* stop = nullptr;
    Real read;
    if constexpr (sizeof(Real) == 4)
        read = strtof(text.c_str(), &stop);
    else
        read = strtod(text.c_str(), &stop);
    if (stop == text.c_str())
        return {begin, errc::invalid_argument};
    if (read == numeric_limits<Real>::infinity() || read == -numeric_limits<Real>::infinity())
        return {begin + (stop - text.c_str()), errc::result_out_of_range};
    value = read;
    return {begin + (stop - text.c_str()), errc{}};
}
} // namespace std
#define weakly_canonical canonical_in_memory
namespace std::ranges {
template <class I, class O>
struct in_out_result {
    I in;
    O out;
};
template <class A, class B>
struct in_in_result {
    A in1;
    B in2;
};
namespace parts {
template <class C, class P>
auto both(C& c, P& p) {
    return [&](auto&& a, auto&& b) -> bool {
        return std::invoke(c, std::invoke(p, std::forward<decltype(a)>(a)),
                           std::invoke(p, std::forward<decltype(b)>(b)));
    };
}
template <class F, class P>
auto one(F& f, P& p) {
    return [&](auto&& a) -> bool { return std::invoke(f, std::invoke(p, std::forward<decltype(a)>(a))); };
}
template <class T, class P>
auto same(const T& v, P& p) {
    return [&](auto&& a) -> bool { return std::invoke(p, std::forward<decltype(a)>(a)) == v; };
}
} // namespace parts
#define WHOLE_RANGE ranges::begin(r), ranges::end(r)
template <class R, class T, class P = identity>
auto find(R&& r, const T& v, P p = {}) {
    return std::find_if(WHOLE_RANGE, parts::same(v, p));
}
template <class I, class T>
requires input_or_output_iterator<I> I find(I a, I b, const T& v) { return std::find(a, b, v); }
template <class R, class F, class P = identity>
auto find_if(R&& r, F f, P p = {}) {
    return std::find_if(WHOLE_RANGE, parts::one(f, p));
}
template <class I, class F>
requires input_or_output_iterator<I> I find_if(I a, I b, F f) { return std::find_if(a, b, std::ref(f)); }
template <class R, class F, class P = identity>
auto find_if_not(R&& r, F f, P p = {}) {
    return std::find_if_not(WHOLE_RANGE, parts::one(f, p));
}
template <class I, class F>
requires input_or_output_iterator<I> I find_if_not(I a, I b, F f) { return std::find_if_not(a, b, std::ref(f)); }
template <class R, class F, class P = identity>
bool any_of(R&& r, F f, P p = {}) {
    return std::any_of(WHOLE_RANGE, parts::one(f, p));
}
template <class R, class F, class P = identity>
bool all_of(R&& r, F f, P p = {}) {
    return std::all_of(WHOLE_RANGE, parts::one(f, p));
}
template <class R, class F, class P = identity>
bool none_of(R&& r, F f, P p = {}) {
    return std::none_of(WHOLE_RANGE, parts::one(f, p));
}
template <class R, class F, class P = identity>
auto count_if(R&& r, F f, P p = {}) {
    return std::count_if(WHOLE_RANGE, parts::one(f, p));
}
template <class R, class T, class P = identity>
auto count(R&& r, const T& v, P p = {}) {
    return std::count_if(WHOLE_RANGE, parts::same(v, p));
}
template <class R, class C = less, class P = identity>
auto sort(R&& r, C c = {}, P p = {}) {
    std::sort(WHOLE_RANGE, parts::both(c, p));
    return ranges::end(r);
}
template <class R, class C = less, class P = identity>
auto stable_sort(R&& r, C c = {}, P p = {}) {
    std::stable_sort(WHOLE_RANGE, parts::both(c, p));
    return ranges::end(r);
}
template <class R, class C = less, class P = identity>
bool is_sorted(R&& r, C c = {}, P p = {}) {
    return std::is_sorted(WHOLE_RANGE, parts::both(c, p));
}
template <class R, class I, class C = less, class P = identity>
void nth_element(R&& r, I n, C c = {}, P p = {}) {
    std::nth_element(ranges::begin(r), n, ranges::end(r), parts::both(c, p));
}
template <class R, class T, class C = less, class P = identity>
auto lower_bound(R&& r, const T& v, C c = {}, P p = {}) {
    return std::lower_bound(WHOLE_RANGE, v,
                            [&](const auto& a, const T& b) { return std::invoke(c, std::invoke(p, a), b); });
}
template <class R, class T, class C = less, class P = identity>
auto upper_bound(R&& r, const T& v, C c = {}, P p = {}) {
    return std::upper_bound(WHOLE_RANGE, v,
                            [&](const T& b, const auto& a) { return std::invoke(c, b, std::invoke(p, a)); });
}
template <class I, class S, class T, class C = less, class P = identity>
I upper_bound(I a, S b, const T& v, C c, P p) {
    return std::upper_bound(a, b, v, [&](const T& x, const auto& y) { return std::invoke(c, x, std::invoke(p, y)); });
}
template <class R, class F, class P = identity>
auto partition_point(R&& r, F f, P p = {}) {
    return std::partition_point(WHOLE_RANGE, parts::one(f, p));
}
template <class R, class T, class C = less, class P = identity>
bool binary_search(R&& r, const T& v, C c = {}, P p = {}) {
    auto at = ranges::lower_bound(r, v, c, p);
    return at != ranges::end(r) && !std::invoke(c, v, std::invoke(p, *at));
}
template <class R, class O>
auto copy(R&& r, O o) {
    auto e = std::copy(WHOLE_RANGE, o);
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r), e};
}
template <class I, class O>
requires input_or_output_iterator<I>
auto copy(I a, I b, O o) { return in_out_result<I, O>{b, std::copy(a, b, o)}; }
template <class R, class O>
auto move(R&& r, O o) {
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r), std::move(WHOLE_RANGE, o)};
}
template <class R, class O, class F, class P = identity>
auto copy_if(R&& r, O o, F f, P p = {}) {
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r), std::copy_if(WHOLE_RANGE, o, parts::one(f, p))};
}
template <class R, class O, class F, class P = identity>
auto remove_copy_if(R&& r, O o, F f, P p = {}) {
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r),
                                                      std::remove_copy_if(WHOLE_RANGE, o, parts::one(f, p))};
}
template <class R, class O, class F, class P = identity>
requires(!ranges::range<O>) auto transform(R&& r, O o, F f, P p = {}) {
    return in_out_result<decltype(ranges::end(r)), O>{
        ranges::end(r), std::transform(WHOLE_RANGE, o, [&](auto&& a) -> decltype(auto) {
            return std::invoke(f, std::invoke(p, std::forward<decltype(a)>(a)));
        })};
}
template <class R, class S, class O, class F>
requires ranges::range<S>
auto transform(R&& r, S&& s, O o, F f) { return std::transform(WHOLE_RANGE, ranges::begin(s), o, std::ref(f)); }
template <class R>
void reverse(R&& r) {
    std::reverse(WHOLE_RANGE);
}
template <class R, class T>
void replace(R&& r, const T& a, const T& b) {
    std::replace(WHOLE_RANGE, a, b);
}
template <class R, class F, class T>
void replace_if(R&& r, F f, const T& b) {
    std::replace_if(WHOLE_RANGE, std::ref(f), b);
}
template <class R, class S>
auto mismatch(R&& r, S&& s) {
    auto [a, b] = std::mismatch(WHOLE_RANGE, ranges::begin(s), ranges::end(s));
    return in_in_result<decltype(a), decltype(b)>{a, b};
}
template <class R, class S, class C = equal_to, class P = identity, class Q = identity>
bool equal(R&& r, S&& s, C c = {}, P p = {}, Q q = {}) {
    return std::equal(WHOLE_RANGE, ranges::begin(s), ranges::end(s), [&](const auto& a, const auto& b) {
        return std::invoke(c, std::invoke(p, a), std::invoke(q, b));
    });
}
template <class R, class T>
void fill(R&& r, const T& v) {
    std::fill(WHOLE_RANGE, v);
}
template <class R, class C = less, class P = identity>
auto max_element(R&& r, C c = {}, P p = {}) {
    return std::max_element(WHOLE_RANGE, parts::both(c, p));
}
template <class R, class C = less, class P = identity>
auto min_element(R&& r, C c = {}, P p = {}) {
    return std::min_element(WHOLE_RANGE, parts::both(c, p));
}
template <class R, class C = equal_to>
auto adjacent_find(R&& r, C c = {}) {
    return std::adjacent_find(WHOLE_RANGE, std::ref(c));
}
template <class R, class F>
void for_each(R&& r, F f) {
    std::for_each(WHOLE_RANGE, [&](auto&& each) { std::invoke(f, each); });
}
template <class R, class F>
void generate(R&& r, F f) {
    std::generate(WHOLE_RANGE, std::ref(f));
}
template <class R, class S>
bool is_permutation(R&& r, S&& s) {
    return std::is_permutation(WHOLE_RANGE, ranges::begin(s), ranges::end(s));
}
template <class A>
struct min_max_result {
    A min, max;
};
template <class R>
auto minmax_element(R&& r) {
    auto [a, b] = std::minmax_element(WHOLE_RANGE);
    return min_max_result<decltype(a)>{a, b};
}
template <class R>
auto minmax(R&& r) {
    auto [a, b] = std::minmax_element(WHOLE_RANGE);
    return min_max_result<range_value_t<R>>{*a, *b};
}
template <class R>
range_value_t<R> min(R&& r) {
    return *std::min_element(WHOLE_RANGE);
}
template <class R>
range_value_t<R> max(R&& r) {
    return *std::max_element(WHOLE_RANGE);
}
#undef WHOLE_RANGE
} // namespace std::ranges
