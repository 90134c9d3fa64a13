#include "occam/check/checker.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <utility>

namespace placedpar::occam {

namespace {

struct PredefinedTraits {
    std::string_view name;
    std::string_view parameters, results; ///< a letter for each type; see predefined_traits
    bool is_double = false;               ///< the routine also exists for REAL64; its name then begins with D
};

/// Lists the predefined routines of the language. Each parameter and result has a letter for its type: i for INT, j for
/// INT32, b for BOOL, r for REAL32, d for REAL64, s for VAL [][]BYTE, and S for [][]BYTE by reference. In the routine
/// whose name begins with D, r means REAL64.
constexpr std::array<PredefinedTraits, 51> predefined_traits = {{
    {"LONGADD", "iii", "i"},
    {"LONGSUM", "iii", "ii"},
    {"LONGSUB", "iii", "i"},
    {"LONGDIFF", "iii", "ii"},
    {"LONGPROD", "iii", "ii"},
    {"LONGDIV", "iii", "ii"},
    {"SHIFTLEFT", "iii", "ii"},
    {"SHIFTRIGHT", "iii", "ii"},
    {"NORMALISE", "ii", "iii"},
    {"ASHIFTLEFT", "ii", "i"},
    {"ASHIFTRIGHT", "ii", "i"},
    {"ROTATELEFT", "ii", "i"},
    {"ROTATERIGHT", "ii", "i"},
    {"FRACMUL", "ii", "i"},
    {"BITCOUNT", "ii", "i"},
    {"BITREVWORD", "i", "i"},
    {"BITREVNBITS", "ii", "i"},
    {"CRCWORD", "iii", "i"},
    {"CRCBYTE", "iii", "i"},
    {"ABS", "r", "r", true},
    {"SQRT", "r", "r", true},
    {"MINUSX", "r", "r", true},
    {"MULBY2", "r", "r", true},
    {"DIVBY2", "r", "r", true},
    {"FPINT", "r", "r", true},
    {"SCALEB", "ri", "r", true},
    {"LOGB", "r", "r", true},
    {"COPYSIGN", "rr", "r", true},
    {"NEXTAFTER", "rr", "r", true},
    {"ISNAN", "r", "b", true},
    {"NOTFINITE", "r", "b", true},
    {"ORDERED", "rr", "b", true},
    {"FLOATING.UNPACK", "r", "ir", true},
    {"ARGUMENT.REDUCE", "rrr", "bjr", true},
    {"IEEECOMPARE", "rr", "i", true},
    {"REAL32OP", "rir", "r"},
    {"REAL32REM", "rr", "r"},
    {"REAL64OP", "did", "d"},
    {"REAL64REM", "dd", "d"},
    {"IEEE32OP", "riir", "br"},
    {"IEEE32REM", "rr", "br"},
    {"IEEE64OP", "diid", "bd"},
    {"IEEE64REM", "dd", "bd"},
    {"REAL32EQ", "rr", "b"},
    {"REAL32GT", "rr", "b"},
    {"REAL64EQ", "dd", "b"},
    {"REAL64GT", "dd", "b"},
    {"MOVE2D", "siiSiiii", ""},
    {"DRAW2D", "siiSiiii", ""},
    {"CLIP2D", "siiSiiii", ""},
    {"ASSERT", "b", ""},
}};
constexpr std::array<std::string_view, 2> without_parameters = {"CAUSEERROR", "RESCHEDULE"};

const Type* type_of_letter(Types& types, char letter, bool is_double) {
    switch (letter) {
    case 'i': return types.basic(Basic::integer);
    case 'j': return types.basic(Basic::int32);
    case 'b': return types.basic(Basic::boolean);
    case 'r': return types.basic(is_double ? Basic::real64 : Basic::real32);
    case 'd': return types.basic(Basic::real64);
    default: return types.array(types.array(types.basic(Basic::byte), std::nullopt), std::nullopt);
    }
}

/// Returns the predefined routine of this name; nothing if there is none.
std::optional<Predefined> predefined_form(Types& types, std::string_view name) {
    for (const std::string_view each : without_parameters) {
        if (each == name)
            return Predefined{};
    }
    for (const PredefinedTraits& each : predefined_traits) {
        const bool is_double = each.is_double && name.substr(0, 1) == "D" && name.substr(1) == each.name;
        if (each.name != name && !is_double)
            continue;
        Predefined form;
        for (const char letter : each.parameters) {
            form.parameters.push_back(type_of_letter(types, letter, is_double));
            form.passing.push_back(letter == 'S' ? Parameter::Passing::reference : Parameter::Passing::value);
        }
        for (const char letter : each.results)
            form.results.push_back(type_of_letter(types, letter, is_double));
        return form;
    }
    return std::nullopt;
}

} // namespace

Declaration* Checker::predefined(const std::string& name) {
    const auto known = predefined_.find(name);
    if (known != predefined_.end())
        return known->second;
    std::optional<Predefined> form = predefined_form(types_, name);
    if (!form)
        return nullptr;
    auto declaration = std::make_unique<Declaration>();
    declaration->name = name;
    declaration->form = std::move(*form);
    program_.predefined.push_back(std::move(declaration));
    return predefined_[name] = program_.predefined.back().get();
}

} // namespace placedpar::occam
