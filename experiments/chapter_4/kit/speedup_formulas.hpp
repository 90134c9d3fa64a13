#pragma once

namespace placedpar {

// Speedups of chapter 4 and appendix C of the thesis. alpha is t_p / t_s (4.5; 4.7: of a local population, too). The
// thesis calls n the slaves, but puts in all processors of a master and its slaves: equation E.2 gives 12 with n = 4.

/// A generation's times on one processor, in any unit, and what communication adds on several.
struct GenerationTimes {
    double evaluating, breeding; ///< t_p, t_s
    double communication = 0;    ///< t_c; in 4.9 n t_c2
};

/// Equation C.1, which is 4.9 with communication.
double formula_c_1(const GenerationTimes&, double processors);
/// Equation 4.9 as it is where communication takes nothing.
double formula_4_9(double alpha, double processors);
/// Equation 4.10: 4.9 with n = alpha.
double formula_4_10(double alpha);
/// "100 % efficiency" up to "the maximum achievable speedup factor" (4.2), which is that of infinitely many processors.
double formula_pipelined(double alpha, double processors);

/// Equation C.2: efficiency.
double formula_c_2(double speedup, double processors);

} // namespace placedpar
