# A room is a folder at the top and a static library placedpar_NAME, known to consumers as PlacedPar::NAME, built from
# all sources below the folder. In the tree, includes read "room/folder/header.hpp"; outside of it, those of doors read
# "placedpar/room/folder/header.hpp" (PublicHeaders.cmake).

# For all that is compiled here, and nobody else.
add_library(placedpar_options INTERFACE)
target_include_directories(placedpar_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(placedpar_options INTERFACE cxx_std_20)
# Contracted multiply-adds round differently from one compiler to the next: the same netlist and seed
# must give the same fingerprint everywhere.
# -Wrestrict: false alarms on string + in GCC 12 (its bug 105651).
target_compile_options(placedpar_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=) # source locations name no folder of the builder's
# Hardened as Debian's programs are, which are position-independent by the compilers' default. Not with sanitizers, which
# see more; unoptimised, the library has no checks.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize|_FORTIFY_SOURCE")
    target_compile_options(placedpar_options INTERFACE $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-D_FORTIFY_SOURCE=2>)
endif()
target_compile_options(placedpar_options INTERFACE -fstack-protector-strong -Werror=format-security)
target_link_options(placedpar_options INTERFACE LINKER:-z,relro,-z,now)
if(CMAKE_UNITY_BUILD)
    # What one file names at its scope may be shadowed in another that is compiled with it; which these are changes with
    # every new file. A build of single files keeps the warning.
    target_compile_options(placedpar_options INTERFACE -Wno-shadow)
endif()
if(PLACEDPAR_WARNINGS_AS_ERRORS)
    target_compile_options(placedpar_options INTERFACE -Werror)
endif()

# placedpar_slow_options(target room): a target of a room that may be slow gets what PLACEDPAR_SLOW_OPTIONS says, and any
# room what its own variable says, such as PLACEDPAR_OPTIONS_occam.
function(placedpar_slow_options target room)
    target_compile_options(${target} PRIVATE ${PLACEDPAR_OPTIONS_${room}})
    if(room IN_LIST PLACEDPAR_SLOW_ROOMS)
        target_compile_options(${target} PRIVATE ${PLACEDPAR_SLOW_OPTIONS})
    endif()
endfunction()

# placedpar_room(name [SOURCES generated.cpp] [DOORS header.hpp ...] LINKS ...)
# The doors are the headers that a program outside of the house begins with, 30 in all rooms at most (tests/consumer). A
# header that another door includes anyway, and that nobody would look for by its name, is no door.
function(placedpar_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;DOORS;LINKS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(placedpar_${name} STATIC ${sources} ${ROOM_SOURCES})
    add_library(PlacedPar::${name} ALIAS placedpar_${name})
    set_target_properties(placedpar_${name} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(placedpar_${name} INTERFACE
        $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(placedpar_${name} PUBLIC cxx_std_20)
    # Public, for problems are compiled for several vector widths by those who state them: runtime/vector_width.hpp.
    target_compile_options(placedpar_${name} PUBLIC -ffp-contract=off)
    target_link_libraries(placedpar_${name} PRIVATE $<BUILD_INTERFACE:placedpar_options> PUBLIC ${ROOM_LINKS})
    placedpar_slow_options(placedpar_${name} ${name})
    # A room is linked into programs and into Python's module, a shared library (python/README.md). In a program the linker
    # turns the accesses of such code to data, functions and thread-local variables into direct ones.
    set_target_properties(placedpar_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(placedpar_${name} PRIVATE -fno-semantic-interposition -ftls-model=initial-exec)

    list(TRANSFORM ROOM_DOORS PREPEND ${name}/)
    set_property(GLOBAL APPEND PROPERTY PLACEDPAR_DOORS ${ROOM_DOORS})
    set_property(GLOBAL APPEND PROPERTY PLACEDPAR_ROOMS ${name})
endfunction()

# placedpar_test(name [PROGRAM] LINKS ...): a doctest program of all sources below the folder. One a room, with the
# label room; the target room_tests builds them all. What needs the whole program is no room's: PROGRAM.
function(placedpar_test name)
    cmake_parse_arguments(TEST "PROGRAM" "" "LINKS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE placedpar_options placedpar_test_main ${TEST_LINKS})
    target_compile_definitions(test_${name} PRIVATE PLACEDPAR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
        target_compile_definitions(test_${name} PRIVATE PLACEDPAR_SANITIZED) # tests/sanitized.hpp
    endif()
    add_test(NAME ${name} COMMAND test_${name})
    if(NOT TEST_PROGRAM)
        set_tests_properties(${name} PROPERTIES LABELS room)
        add_dependencies(room_tests test_${name})
    endif()
endfunction()
