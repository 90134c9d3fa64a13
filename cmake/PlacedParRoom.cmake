# A room is a folder at the top of the tree. All sources below the folder are compiled into a static library
# placedpar_NAME, which other projects link as PlacedPar::NAME. Sources in the tree include a header as
# "room/folder/header.hpp". Programs outside of the tree include a public header, called a door, as
# "placedpar/room/folder/header.hpp" (PublicHeaders.cmake).

# These options apply to all sources of this project, but not to sources of projects that link it.
add_library(placedpar_options INTERFACE)
target_include_directories(placedpar_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(placedpar_options INTERFACE cxx_std_20)
# -ffp-contract=off: compilers contract multiplications and additions differently, and so round differently, but the
# same netlist and seed must give the same fingerprint with every compiler.
# -Wno-restrict: GCC 12 gives false alarms about the + of strings (GCC's bug 105651).
target_compile_options(placedpar_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=) # otherwise source locations would contain the path of this tree
# Hardens the program as Debian hardens its programs; position-independent code is the compilers' default. Sanitizers
# find more faults, so they are used without these checks. In builds without optimisation, the C library has no checks.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize|_FORTIFY_SOURCE")
    target_compile_options(placedpar_options INTERFACE $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-D_FORTIFY_SOURCE=2>)
endif()
target_compile_options(placedpar_options INTERFACE -fstack-protector-strong -Werror=format-security)
target_link_options(placedpar_options INTERFACE LINKER:-z,relro,-z,now)
if(CMAKE_UNITY_BUILD)
    # A unity build compiles several files as one source, so a name at file scope in one file may be shadowed in
    # another. Builds that compile each file alone keep the warning.
    target_compile_options(placedpar_options INTERFACE -Wno-shadow)
endif()
if(PLACEDPAR_WARNINGS_AS_ERRORS)
    target_compile_options(placedpar_options INTERFACE -Werror)
endif()

# placedpar_slow_options(target room): adds the options in the room's own variable, such as PLACEDPAR_OPTIONS_occam, to
# the target. If the room is in PLACEDPAR_SLOW_ROOMS, also adds PLACEDPAR_SLOW_OPTIONS, which save compile time in rooms
# whose speed matters little.
function(placedpar_slow_options target room)
    target_compile_options(${target} PRIVATE ${PLACEDPAR_OPTIONS_${room}})
    if(room IN_LIST PLACEDPAR_SLOW_ROOMS)
        target_compile_options(${target} PRIVATE ${PLACEDPAR_SLOW_OPTIONS})
    endif()
endfunction()

# placedpar_room(name [SOURCES generated.cpp] [DOORS header.hpp ...] LINKS ...)
# The doors are the public headers: those that a program outside of this tree includes by name. All rooms together have
# at most 30 doors (tests/consumer). A header need not be a door if a door includes it and no programmer would look for
# it by name.
function(placedpar_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;DOORS;LINKS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_library(placedpar_${name} STATIC ${sources} ${ROOM_SOURCES})
    add_library(PlacedPar::${name} ALIAS placedpar_${name})
    set_target_properties(placedpar_${name} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(placedpar_${name} INTERFACE
        $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(placedpar_${name} PUBLIC cxx_std_20)
    # PUBLIC, because programs that link the room compile their own problems for several vector widths
    # (runtime/vector_width.hpp), and must round as the rooms do.
    target_compile_options(placedpar_${name} PUBLIC -ffp-contract=off)
    target_link_libraries(placedpar_${name} PRIVATE $<BUILD_INTERFACE:placedpar_options> PUBLIC ${ROOM_LINKS})
    placedpar_slow_options(placedpar_${name} ${name})
    # A room is linked into programs, and into Python's module, which is a shared library (python/README.md) and needs
    # position-independent code. In a program the linker replaces this code's indirect accesses to data, functions and
    # thread-local variables by direct accesses.
    set_target_properties(placedpar_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(placedpar_${name} PRIVATE -fno-semantic-interposition -ftls-model=initial-exec)

    list(TRANSFORM ROOM_DOORS PREPEND ${name}/)
    set_property(GLOBAL APPEND PROPERTY PLACEDPAR_DOORS ${ROOM_DOORS})
    set_property(GLOBAL APPEND PROPERTY PLACEDPAR_ROOMS ${name})
endfunction()

# placedpar_test(name [PROGRAM] LINKS ...): defines a doctest program of all sources below the folder. Each room has one
# such test, with the label `room`; the target room_tests builds all of them. A test that needs the whole program
# belongs to no room: state PROGRAM.
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
