#pragma once

namespace placedpar {

// These are the formulas for speedups in chapter 4 and appendix C of the thesis. `alpha` is t_p / t_s, the time for
// evaluating a generation divided by the time for breeding (section 4.5; in section 4.7 also for a local population).
// The thesis defines n as the number of slaves, but computes with n as the number of processors, including the master:
// equation E.2 gives 12 with n = 4.

/// The times of a generation, all in the same unit: computing on one processor, and communication between several
/// processors.
struct GenerationTimes {
    double evaluating, breeding; ///< t_p, t_s
    double communication = 0;    ///< t_c; in equation 4.9 it is n t_c2
};

/// Returns the speedup by equation C.1, which is equation 4.9 with communication.
double formula_c_1(const GenerationTimes&, double processors);
/// Returns the speedup by equation 4.9 without communication.
double formula_4_9(double alpha, double processors);
/// Returns the speedup by equation 4.10, which is equation 4.9 with n = `alpha`.
double formula_4_10(double alpha);
/// Returns the speedup with a pipeline: `processors` ("100 % efficiency", section 4.2), but not more than `alpha` + 1
/// ("the maximum achievable speedup factor").
double formula_pipelined(double alpha, double processors);

/// Returns the efficiency by equation C.2, the speedup per processor.
double formula_c_2(double speedup, double processors);

} // namespace placedpar
