# Compiles with ccache, if it is installed. Another build of the same sources, in CI or with another preset, then reuses
# the compiled files.
find_program(PLACEDPAR_CCACHE ccache)
mark_as_advanced(PLACEDPAR_CCACHE)
if(PLACEDPAR_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${PLACEDPAR_CCACHE})
endif()
