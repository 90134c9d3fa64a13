# tests/fingerprints.csv holds the fingerprint of each netlist and seed. Every build of the program must give these. That
# another compiler's build prints the same reports to the letter is compared by .ci/run.
add_test(NAME fingerprints COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/fingerprints.py $<TARGET_FILE:placedpar>)
