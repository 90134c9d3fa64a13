// Tests how the time of a process with components is divided into activities.

#include "observe/critical_path/waits.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

constexpr Time at(int picoseconds) { return Time{picoseconds}; }

/// A process that begins an activity at 0.
Accounts beginning(Activity activity) {
    Accounts accounts;
    accounts.turn("p", Activity::ended, activity, at(0));
    return accounts;
}

} // namespace

TEST_CASE("time is assigned to the process's activity") {
    Accounts accounts = beginning(Activity::ready);
    accounts.turn("p", Activity::ready, Activity::computing, at(2));
    accounts.turn("p", Activity::computing, Activity::moving, at(5));
    accounts.turn("p", Activity::moving, Activity::ended, at(9));
    accounts.close(at(20));
    const Account& p = accounts.all().at("p");
    CHECK(p.ready == at(2));
    CHECK(p.computing == at(3));
    CHECK(p.communicating == at(4));
    CHECK(p.life() == at(9)); // nothing is counted after the process has ended
}

TEST_CASE("a process computes while any of its components does") {
    Accounts accounts = beginning(Activity::computing);
    accounts.turn("p", Activity::ended, Activity::joining, at(0)); // a second component starts
    accounts.turn("p", Activity::computing, Activity::ready, at(4));
    accounts.turn("p", Activity::ready, Activity::inputting, at(6));
    accounts.close(at(10));
    const Account& p = accounts.all().at("p");
    CHECK(p.computing == at(4));
    CHECK(p.ready == at(2));
    CHECK(p.waiting == at(4));
    CHECK(p.waiting_for.empty()); // the wait never ended
    CHECK(p.most_waited_for().empty());
}

TEST_CASE("every kind of wait counts as a wait") {
    for (Activity wait : {Activity::delayed, Activity::outputting, Activity::inputting, Activity::alternating,
                          Activity::joining, Activity::after_work, Activity::stopped}) {
        Accounts accounts = beginning(wait);
        accounts.close(at(3));
        CHECK(accounts.all().at("p").waiting == at(3));
    }
}

TEST_CASE("a wait for a partner ends when both are ready, and communication begins") {
    Accounts accounts = beginning(Activity::inputting);
    accounts.explain("p", "slow", at(7), at(10));
    const Account& p = accounts.all().at("p");
    CHECK(p.waiting == at(7));
    CHECK(p.communicating == at(3));
    CHECK(p.waiting_for.at("slow") == at(7));
    accounts.explain("p", "quick", at(12), at(12));
    CHECK(p.waiting_for.at("quick") == at(2));
    CHECK(p.most_waited_for() == "slow");
}

TEST_CASE("a wait without a partner counts as a delay") {
    Accounts accounts = beginning(Activity::delayed);
    accounts.explain("p", "", at(5), at(5));
    CHECK(accounts.all().at("p").delayed == at(5));
    CHECK(accounts.all().at("p").waiting == at(0));
}
