// Two processes on two ranks of mpirun exchange a number over and over. For comparison, MPI exchanges the same number
// of bytes by its standard send, and by its synchronous send. The program prints nanoseconds of the wall clock for a
// message there and back. Each figure is the least of several repetitions.

#include "native/rank_channel.hpp"
#include "native/rank_member.hpp"
#include "ranks/rank_mail.hpp"
#include "ranks/ranks.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <stdexcept>

using namespace placedpar;

extern "C" Ranks* placedpar_mpi_ranks(); // app/mpi/mpi_ranks.cpp

namespace {

using Send = int (*)(const void*, int, MPI_Datatype, int, int, MPI_Comm);

double nanoseconds_each(long times, const auto& exchange) {
    MPI_Barrier(MPI_COMM_WORLD);
    const auto begun = std::chrono::steady_clock::now();
    exchange();
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begun).count() /
           static_cast<double>(times);
}

double by_mpi(Send send, int own, long times) {
    return nanoseconds_each(times, [&] {
        long number = 0;
        for (long i = 0; i < times; ++i) {
            if (own == 0)
                send(&number, sizeof number, MPI_BYTE, 1, 0, MPI_COMM_WORLD);
            MPI_Recv(&number, sizeof number, MPI_BYTE, 1 - own, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
            if (own == 1)
                send(&number, sizeof number, MPI_BYTE, 0, 0, MPI_COMM_WORLD);
        }
    });
}

double by_channels(RankMail& mail, long times) {
    Channel<long> there("there"), back("back");
    Simulation simulation;
    native::RankMember member(mail, simulation, 2);
    const int own = mail.own();
    native::RankGiver giver(member, own == 0 ? there : back, own == 0 ? 0 : 1, 1 - own);
    native::RankTaker taker(member, own == 0 ? back : there, own == 0 ? 1 : 0, 1 - own);
    long last = 0;
    simulation.process("ping or pong", [&] {
        for (long i = 0; i < times; ++i) {
            if (own == 0)
                there.out().output(last);
            last = (own == 0 ? back : there).in().input();
            if (own == 1)
                back.out().output(last + 1);
        }
    });
    member.begin();
    double each = 0;
    each = nanoseconds_each(times, [&] { simulation.run(); });
    if (last != times - own)
        throw std::logic_error("the numbers did not come back");
    return each;
}

} // namespace

int main(int arguments, char** argument) {
    const long times = arguments > 1 ? std::atol(argument[1]) : 10'000;
    const std::unique_ptr<Ranks> ranks(placedpar_mpi_ranks());
    if (ranks->count() != 2) {
        fmt::print(stderr, "start two ranks: mpirun -n 2 native_ranks\n");
        return 1;
    }
    const std::unique_ptr<RankMail> mail = ranks->open_mail();
    double usual = 1e12, synchronous = 1e12, channels = 1e12;
    for (int repetition = 0; repetition < 100; ++repetition) {
        usual = std::min(usual, by_mpi(MPI_Send, ranks->own(), times));
        synchronous = std::min(synchronous, by_mpi(MPI_Ssend, ranks->own(), times));
        channels = std::min(channels, by_channels(*mail, times));
    }
    if (ranks->own() == 0)
        fmt::print("MPI: {:.0f} ns there and back, synchronous {:.0f} ns\n"
                   "2 ranks: {:.0f} ns there and back, {:.2f} times MPI, {:.2f} times synchronous MPI\n",
                   usual, synchronous, channels, channels / usual, channels / synchronous);
}
