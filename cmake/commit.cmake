# cmake -DTREE=... -DOUTPUT=FILE -P commit.cmake
# Writes a source that says of which commit the sources in TREE are, "" where that is not known: as git describes it in
# a checkout of our own, else as commit.txt in this folder has it from `git archive`. A file that says so already is
# left alone, so that a build compiles nothing when no commit was made.
set(commit "")
file(READ ${CMAKE_CURRENT_LIST_DIR}/commit.txt archived)
string(STRIP "${archived}" archived)
find_program(git git)
if(NOT archived MATCHES "Format")
    set(commit "${archived}")
elseif(git AND EXISTS ${TREE}/.git) # the git of a project around this one knows nothing of our commits
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
