# cmake -DTREE=... -DOUTPUT=FILE -P commit.cmake
# Writes a source file with the commit of the sources in TREE; "" if the commit is unknown. In a checkout of PlacedPar,
# git states the commit. In an archive that `git archive` made, commit.txt in this folder states it. If the source file
# already has the right text, it is not written again, so a build without a new commit compiles nothing.
set(commit "")
file(READ ${CMAKE_CURRENT_LIST_DIR}/commit.txt archived)
string(STRIP "${archived}" archived)
find_program(git git)
if(NOT archived MATCHES "Format")
    set(commit "${archived}")
elseif(git AND EXISTS ${TREE}/.git) # without this test, git could state the commit of a project around this one
    execute_process(COMMAND ${git} -C ${TREE} describe --always --dirty --exclude=*
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
string(CONCAT text "// Made by cmake/commit.cmake.\n#include \"report/manifest.hpp\"\n\nnamespace placedpar {\n\n"
       "const char* const commit = \"${commit}\";\n\n} // namespace placedpar\n")
set(before "")
if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} before)
endif()
if(NOT before STREQUAL text)
    file(WRITE ${OUTPUT} "${text}")
endif()
