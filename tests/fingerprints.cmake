# tests/fingerprints.csv holds the fingerprint of each netlist and seed. Every build of the program must give these, and
# builds of other compilers and optimisations print the same reports to the letter. The preset ci itself is GCC's -O2,
# and -O1 from the monitor upwards.
function(placedpar_fingerprints test) # ... program [reference]
    add_test(NAME ${test} COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/fingerprints.py ${ARGN})
endfunction()

placedpar_fingerprints(fingerprints $<TARGET_FILE:placedpar>)

# placedpar_compiler(clang-O0 clang++ -O0): builds what runs netlists that way and compares what it prints.
function(placedpar_compiler name compiler flags)
    find_program(PLACEDPAR_${compiler} ${compiler} REQUIRED)
    set(build ${CMAKE_CURRENT_BINARY_DIR}/${name})
    add_test(NAME ${name}.configure COMMAND ${CMAKE_COMMAND} -G Ninja -S ${PROJECT_SOURCE_DIR} -B ${build}
        -DCMAKE_CXX_COMPILER=${PLACEDPAR_${compiler}} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_BUILD_TYPE=
        -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 # each room as one source: a third of the time
        -DPLACEDPAR_TESTS=OFF -DPLACEDPAR_BENCH=OFF -DPLACEDPAR_WARNINGS_AS_ERRORS=${PLACEDPAR_WARNINGS_AS_ERRORS})
    # On one core, beside the other tests: alone, its last room would leave the others idle.
    add_test(NAME ${name}.build COMMAND ${CMAKE_COMMAND} --build ${build} --target placedpar_netlists --parallel 1)
    placedpar_fingerprints(${name}.fingerprints ${build}/app/placedpar_netlists $<TARGET_FILE:placedpar>)
    set_tests_properties(${name}.configure ${name}.build ${name}.fingerprints PROPERTIES LABELS compilers)
    set_tests_properties(${name}.configure PROPERTIES FIXTURES_SETUP ${name}.configured)
    set_tests_properties(${name}.build PROPERTIES
        FIXTURES_REQUIRED ${name}.configured FIXTURES_SETUP ${name}.built)
    set_tests_properties(${name}.fingerprints PROPERTIES FIXTURES_REQUIRED ${name}.built)
endfunction()

if(PLACEDPAR_COMPILER_TESTS)
    placedpar_compiler(clang-O0 clang++ -O0) # another compiler and another optimisation in one build
endif()
