# cmake -DTREE=... -DSTAGE=... -P headers.cmake
# The headers that a program outside of the house begins with are few, and no document or example of ours includes another.
# What comes with them, in detail/, is counted apart, and needs none of the large libraries.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE doors RELATIVE ${STAGE} ${STAGE}/*.hpp)
set(inside ${doors})
list(FILTER doors EXCLUDE REGEX "^detail/")
list(FILTER inside INCLUDE REGEX "^detail/")

# few(WHAT MOST HEADER...): counts them, and fails where there are more.
function(few what most)
    list(LENGTH ARGN count)
    message(STATUS "${count} headers ${what}")
    if(count GREATER most OR count EQUAL 0)
        message(FATAL_ERROR "There are ${count} headers ${what}, not 1 to ${most}: see DOORS in the rooms' CMakeLists.txt")
    endif()
endfunction()
few("that a program outside begins with" 30 ${doors})
few("in detail/, which come with them" 142 ${inside})

foreach(header ${doors} ${inside})
    file(STRINGS ${STAGE}/${header} large REGEX "^#include <(Eigen/|fmt/|CLI/|sqlite3|boost/json)")
    list(FILTER large EXCLUDE REGEX "boost/json/fwd")
    if(large)
        message(FATAL_ERROR "${header} says ${large}: a program outside would read that library with it")
    endif()
endforeach()

file(GLOB pages ${TREE}/README.md ${TREE}/docs/*/*.md ${TREE}/*/README.md ${TREE}/CONTRIBUTING.md ${TREE}/examples/*/*/README.md
    ${TREE}/examples/*/*/*.?pp)
foreach(page ${pages})
    file(READ ${page} text)
    string(REGEX MATCHALL "placedpar/[a-z0-9_/]+\\.hpp" named "${text}")
    foreach(header ${named})
        cmake_path(RELATIVE_PATH header BASE_DIRECTORY placedpar)
        if(NOT header IN_LIST doors)
            message(FATAL_ERROR "${page} names placedpar/${header}, with which no program outside begins")
        endif()
    endforeach()
endforeach()
