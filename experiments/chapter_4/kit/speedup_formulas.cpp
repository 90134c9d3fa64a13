#include "experiments/chapter_4/kit/speedup_formulas.hpp"

#include <algorithm>

namespace placedpar {

double formula_c_1(const GenerationTimes& times, double processors) {
    return (times.evaluating + times.breeding) / (times.evaluating / processors + times.breeding + times.communication);
}

double formula_4_9(double alpha, double processors) {
    return formula_c_1({.evaluating = alpha, .breeding = 1}, processors);
}

double formula_4_10(double alpha) { return (alpha + 1) / 2; }

double formula_pipelined(double alpha, double processors) { return std::min(processors, alpha + 1); }

double formula_c_2(double speedup, double processors) { return speedup / processors; }

} // namespace placedpar
