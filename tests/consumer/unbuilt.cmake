# cmake -DTREE=... -DSCRATCH=... -DCOMPILER=... -P unbuilt.cmake
# An install of what is not built names what is missing and the command, and copies nothing.
include(${CMAKE_CURRENT_LIST_DIR}/must.cmake)
file(REMOVE_RECURSE ${SCRATCH})
must(${CMAKE_COMMAND} -G Ninja -S ${TREE} -B ${SCRATCH}/build -DCMAKE_CXX_COMPILER=${COMPILER} -DPLACEDPAR_TESTS=OFF -DPLACEDPAR_BENCH=OFF)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${SCRATCH}/installed
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
if(result EQUAL 0 OR EXISTS ${SCRATCH}/installed)
    message(FATAL_ERROR "What is not built was installed (${result})")
endif()
if(NOT error MATCHES "app/placedpar\n" OR NOT error MATCHES "cmake --build \"${SCRATCH}/build\" --target installed")
    message(FATAL_ERROR "The refusal does not help: ${error}")
endif()
