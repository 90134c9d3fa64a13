# cmake -DBUILD=... -DSOURCE=... -DSCRATCH=... -P test.cmake: installs, then builds and runs the consumer.
function(must)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN} failed:\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed)
must(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/tests/consumer -B ${SCRATCH}/build
     -DCMAKE_PREFIX_PATH=${SCRATCH}/installed -DCMAKE_CXX_FLAGS=${FLAGS})
must(${CMAKE_COMMAND} --build ${SCRATCH}/build)
must(${SCRATCH}/build/consumer)
must(${SCRATCH}/installed/bin/placedpar kinds)
