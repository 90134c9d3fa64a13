# tests/fingerprints.csv holds the fingerprint of each netlist and seed. Every build of the program must give these. That
# another compiler's build prints the same reports to the letter is compared by .ci/run.
set(explore ${PROJECT_SOURCE_DIR}/explore)
add_executable(netlist_reports EXCLUDE_FROM_ALL netlist_reports.cpp ${explore}/load.cpp ${explore}/netlist_run.cpp ${explore}/problems.cpp)
target_link_libraries(netlist_reports PRIVATE placedpar_options
    PlacedPar::report PlacedPar::identification PlacedPar::problems PlacedPar::classics PlacedPar::gaprocs PlacedPar::hydraulics
    PlacedPar::netlist PlacedPar::occam PlacedPar::runtime PlacedPar::text)

add_test(NAME fingerprints COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/fingerprints.py $<TARGET_FILE:placedpar>)
