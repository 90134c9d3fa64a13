# cmake -DTREE=... -DSCRATCH=... -DCOMPILER=... -DFLAGS=... -DLAUNCHER=... -P test.cmake
# Each source by itself, as a project around builds them that says nothing of unity builds; optimised a little: what
# is inline in one source and used by another links without.
include(${CMAKE_CURRENT_LIST_DIR}/../must.cmake)

must(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH} -DPLACEDPAR_TREE=${TREE}
     -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 -DCMAKE_CXX_FLAGS=${FLAGS}
     -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
must(${CMAKE_COMMAND} --build ${SCRATCH})
must(${SCRATCH}/around)
