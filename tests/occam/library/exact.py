"""The formats of reals and the elementary functions by exact arithmetic, independent of the libraries."""

import decimal
import struct
from fractions import Fraction

MOST = {32: 9, 64: 17}
WIDTH = {32: 2, 64: 3}


def of_bits(bits, size):
    return struct.unpack(">f" if size == 32 else ">d", bits.to_bytes(size // 8, "big"))[0]


def rounded(value, last):
    """Returns a fraction in units of 10^last, rounded half to even."""
    return round(value / Fraction(10) ** last)


def exponent_of(value):
    exponent = 0
    while Fraction(10) ** exponent <= value:
        exponent += 1
    while Fraction(10) ** exponent > value:
        exponent -= 1
    return exponent


def significant(value, digits):
    """Returns the digits of a positive fraction as an integer, and the power of ten of the first."""
    exponent = exponent_of(value)
    number = rounded(value, exponent - digits + 1)
    return (number // 10, exponent + 1) if number == 10 ** digits else (number, exponent)


def scientific(value, sign, digits, size):
    keep = max(min(digits, MOST[size]), 1)
    number, exponent = (0, 0) if value == 0 else significant(value, keep)
    text = str(number).rjust(keep, "0") + "0" * (digits - keep)
    mantissa = text[0] + "." + text[1:] if digits > 1 else " " * digits + text
    return f"{sign}{mantissa}E{'-' if exponent < 0 else '+'}{abs(exponent):0{WIDTH[size]}d}"


def fixed(value, sign, Ip, Dp, size):
    last = -Dp
    if value:
        last = max(last, exponent_of(value) + 1 - MOST[size])
    number = rounded(value, last) * 10 ** (last + Dp)
    text = str(number).rjust(Dp + 1, "0")
    text = sign + text[:-Dp] + "." + text[-Dp:]
    field = Ip + Dp + 2
    if len(text) <= field:
        return text.rjust(field)
    room = field - 4 - WIDTH[size]
    return scientific(value, sign, room, size) if room >= 0 else (sign + "Ov").ljust(field)


def free(value, size):
    if value == 0:
        return "0.0"
    number, exponent = significant(value, MOST[size])
    if not -4 <= exponent < MOST[size]:
        digits = str(number).rstrip("0")
        return f"{digits[0]}.{digits[1:] or '0'}E{'-' if exponent < 0 else '+'}{abs(exponent):0{WIDTH[size]}d}"
    whole, point, rest = f"{decimal.Decimal(number).scaleb(exponent - MOST[size] + 1):f}".partition(".")
    return f"{whole}.{rest.rstrip('0') or '0'}"


def formatted(bits, size, Ip, Dp):
    """Returns what REAL32TOSTRING and REAL64TOSTRING write for the number with these bits."""
    x = of_bits(bits, size)
    negative = bits >> (size - 1) == 1
    sign = "-" if negative else " "
    field = Ip + Dp + 2 if Ip else Dp + 4 + WIDTH[size] if Dp else 0
    if x != x:
        return ("NaN" if not field else " NaN").ljust(field)
    if x in (float("inf"), float("-inf")):
        return ("-Inf" if negative else "Inf" if not field else " Inf").ljust(field)
    value = abs(Fraction(x))
    if Ip:
        return fixed(value, sign, Ip, Dp, size)
    if Dp:
        return scientific(value, sign, Dp, size)
    return sign.strip() + free(value, size)


# Elementary functions of decimal numbers of 60 digits and more



def series(first, ratio):
    """Returns first * (1 + ratio(1) * (1 + ratio(2) * ...)), by its terms."""
    total, term, k = first, first, 0
    while term and term.adjusted() > total.adjusted() - 70:
        k += 1
        term = term * ratio(k)
        total += term
    return total


def arctangent(x):
    if x < 0:
        return -arctangent(-x)
    halvings = 0
    while x > decimal.Decimal("0.05"):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    return series(x, lambda k: -x * x * (2 * k - 1) / (2 * k + 1)) * 2 ** halvings


def circle():
    return 4 * (4 * arctangent(1 / decimal.Decimal(5)) - arctangent(1 / decimal.Decimal(239)))


def sine(x, quarter=0):
    half_pi = circle() / 2
    turns = int((x / half_pi).to_integral_value())
    r = x - turns * half_pi
    turns += quarter
    if turns % 2:
        y = series(decimal.Decimal(1), lambda k: -r * r / ((2 * k - 1) * (2 * k)))
    else:
        y = series(r, lambda k: -r * r / ((2 * k) * (2 * k + 1)))
    return -y if turns & 2 else y


def arcsine(x):
    return arctangent(x / (1 - x * x).sqrt()) if abs(x) != 1 else x * circle() / 2


def hyperbolic_sine(x):
    return series(x, lambda k: x * x / ((2 * k) * (2 * k + 1))) if abs(x) < 1 else (x.exp() - (-x).exp()) / 2


def angle(x, y):
    if x == 0:
        return (circle() / 2).copy_sign(y)
    return arctangent(y / x) + (circle().copy_sign(y) if x < 0 else 0)


FUNCTIONS = {
    "SIN": sine, "COS": lambda x: sine(x, 1), "TAN": lambda x: sine(x) / sine(x, 1),
    "ASIN": arcsine, "ACOS": lambda x: circle() / 2 - arcsine(x), "ATAN": arctangent, "ATAN2": angle,
    "SINH": hyperbolic_sine, "COSH": lambda x: (x.exp() + (-x).exp()) / 2,
    "TANH": lambda x: hyperbolic_sine(x) / ((x.exp() + (-x).exp()) / 2),
    "ALOG": lambda x: x.ln(), "ALOG10": lambda x: x.log10(), "EXP": lambda x: x.exp(),
    "POWER": lambda x, y: (x.ln() * y).exp(),
}


def units_off(name, arguments, result, size):
    """Returns by how many units of the last place a result is off."""
    with decimal.localcontext(decimal.Context(prec=110, Emin=-99999, Emax=99999)):
        true = Fraction(FUNCTIONS[name](*[decimal.Decimal(x) for x in arguments]))
    fraction, least = (23, -149) if size == 32 else (52, -1074)
    exponent = 0
    while Fraction(2) ** exponent <= abs(true):
        exponent += 1
    while true and Fraction(2) ** exponent > abs(true):
        exponent -= 1
    return abs(Fraction(result) - true) / Fraction(2) ** max(exponent - fraction, least)
