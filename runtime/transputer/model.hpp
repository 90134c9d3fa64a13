#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace placedpar::transputer {

/// A word of a transputer with 32 bits, or an address. On the machine addresses are signed, so memory begins at
/// `most_negative`.
using Word = std::uint32_t;

/// MostNeg, the address of the first byte of memory. The same value also stands for "no process".
inline constexpr Word most_negative = 0x8000'0000;
inline constexpr Word not_a_process = most_negative;

/// The models of transputer whose code can be executed.
enum class Model : std::uint8_t { t414, t425, t400, t800, t805 };

/// A set of models.
using Models = unsigned;
constexpr Models only(Model model) { return 1u << static_cast<unsigned>(model); }
inline constexpr Models all_models = 0x1f;
/// Models with a floating-point unit.
inline constexpr Models with_reals = only(Model::t800) | only(Model::t805);
/// Models without a floating-point unit. They have instructions for library routines on reals.
inline constexpr Models without_reals = all_models & ~with_reals;
/// Models with the instructions that came with the T800: duplicate, moves in two dimensions, CRC, bits.
inline constexpr Models second_generation = all_models & ~only(Model::t414);
/// Models with instructions for debuggers.
inline constexpr Models with_breakpoints = second_generation & ~only(Model::t800);

/// The properties of a model, apart from its instructions. Source: IMS T414, T425, T400, T800, T805 data sheets.
struct Traits {
    std::string_view name;
    Word memory_start;     ///< MemStart as an offset from MostNeg: first byte that programs may use
    Word bytes_on_chip;    ///< memory on the chip
    std::int64_t identity; ///< number that lddevid pushes
};

inline constexpr Traits all_traits[] = {{"T414", 0x48, 2048, 0},
                                        {"T425", 0x70, 4096, 0},
                                        {"T400", 0x70, 2048, 50},
                                        {"T800", 0x70, 4096, 0},
                                        {"T805", 0x70, 4096, 10}};

/// Returns the traits of a model.
constexpr const Traits& traits_of(Model model) { return all_traits[static_cast<unsigned>(model)]; }

/// Returns the model of this name, such as "T800"; nothing if its code cannot be executed.
constexpr std::optional<Model> model_named(std::string_view name) {
    for (const Model model : {Model::t414, Model::t425, Model::t400, Model::t800, Model::t805})
        if (traits_of(model).name == name)
            return model;
    return std::nullopt;
}

} // namespace placedpar::transputer
