# cmake -DTREE=... -DBUILD=... -DSCRATCH=... -DCOMPILER=... -DBUILD_TYPE=... -DFLAGS=... -DLAUNCHER=... -P test.cmake
# Installs the program and the rooms, builds and runs a project outside of the tree that finds them, and tries the
# installed program from where it was installed.
include(${CMAKE_CURRENT_LIST_DIR}/../must.cmake)

file(REMOVE_RECURSE ${SCRATCH}/installed)
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed --strip) # debuggers may know the source tree
must(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${SCRATCH}/build
     -DCMAKE_PREFIX_PATH=${SCRATCH}/installed -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
     -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DDOORS=${BUILD}/public_headers.cmake
     # A package that asks for these fails where they are missing: no installed header includes them.
     -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
must(${CMAKE_COMMAND} --build ${SCRATCH}/build)
must(${SCRATCH}/build/consumer)

# The programs of docs/guides/own-processes.md, docs/guides/own-problem.md and docs/guides/own-policy.md, as the pages say.
foreach(example csp/own-process/thin genetic/own-problem/tin genetic/own-policy/islands)
    cmake_path(GET example PARENT_PATH folder)
    string(REGEX REPLACE "^[a-z]+/own-" "own_" program ${folder})
    must(${CMAKE_COMMAND} -G Ninja -S ${SCRATCH}/installed/share/placedpar/examples/${folder} -B ${SCRATCH}/${program}
         -DCMAKE_PREFIX_PATH=${SCRATCH}/installed -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
         -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
    must(${CMAKE_COMMAND} --build ${SCRATCH}/${program})
    must(${SCRATCH}/${program}/${program} run ${SCRATCH}/installed/share/placedpar/examples/${example}.cfs)
endforeach()

unset(ENV{PLACEDPAR_EXAMPLES})
must(${SCRATCH}/installed/bin/placedpar kinds)
foreach(printed man/man1/placedpar.1 bash-completion/completions/placedpar zsh/site-functions/_placedpar)
    file(STRINGS ${SCRATCH}/installed/share/${printed} lines REGEX placedpar)
    if(NOT lines)
        message(FATAL_ERROR "${printed} is empty")
    endif()
endforeach()
must(${SCRATCH}/installed/bin/placedpar replay table-e1) # of the installed examples

# What the program's texts name is installed; the unit names the program where it is.
set(doc ${SCRATCH}/installed/share/doc/placedpar)
file(STRINGS ${SCRATCH}/installed/bin/placedpar lines REGEX "(docs|examples)/")
string(REGEX MATCHALL "(docs|examples)/[A-Za-z0-9_/.-]*[A-Za-z0-9]" named "${lines}")
list(LENGTH named count)
if(count LESS 10)
    message(FATAL_ERROR "the program names only ${named}")
endif()
foreach(file IN ITEMS ${named} README.md LICENSE copyright)
    if(NOT EXISTS ${doc}/${file})
        message(FATAL_ERROR "The program names ${file}, which is not installed in ${doc}")
    endif()
endforeach()
file(STRINGS ${SCRATCH}/installed/lib/systemd/system/placedpar-monitor.service unit REGEX ExecStart)
if(NOT unit MATCHES "^ExecStart=\"${SCRATCH}/installed/bin/placedpar\" ")
    message(FATAL_ERROR "The unit has ${unit}")
endif()
# Sanitizers put the names of sources into the program.
if(NOT FLAGS MATCHES "-fsanitize")
    string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" tree "${TREE}/")
    file(STRINGS ${SCRATCH}/installed/bin/placedpar found REGEX "${tree}")
    if(found)
        message(FATAL_ERROR "The installed program depends on the source tree: ${found}")
    endif()
endif()

# Nothing is left.
must(${CMAKE_COMMAND} --build ${BUILD} --target uninstall)
file(GLOB_RECURSE left ${SCRATCH}/installed/*)
if(left)
    message(FATAL_ERROR "The target uninstall leaves ${left}")
endif()
