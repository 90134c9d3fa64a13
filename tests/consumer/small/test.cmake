# cmake -DINSTALLED=... -DSCRATCH=... -DCOMPILER=... -DLAUNCHER=... -P test.cmake
# Builds and runs the small project against what is installed.
include(${CMAKE_CURRENT_LIST_DIR}/../must.cmake)

must(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH} -DCMAKE_PREFIX_PATH=${INSTALLED}
     -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
must(${CMAKE_COMMAND} --build ${SCRATCH})
foreach(program plain_20 lto_23 address_20 address_23)
    must(${SCRATCH}/${program})
endforeach()

# A process whose local array is too large is named, however large it is, and nobody else's variables are overwritten.
foreach(program plain_20 lto_23)
    must(${SCRATCH}/${program} array 100000)
    foreach(large "array;340000" "array;4000000" "alloca;340000" "alloca;4000000")
        execute_process(COMMAND ${SCRATCH}/${program} ${large} RESULT_VARIABLE result ERROR_VARIABLE error)
        if(NOT result MATCHES "Segmentation|11|139" OR NOT error MATCHES "^process large has used up its stack of 256 Kbyte")
            message(FATAL_ERROR "${program} ${large} ended with ${result}: ${error}")
        endif()
    endforeach()
endforeach()
