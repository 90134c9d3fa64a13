# cmake -DMANIFEST=FILE -P uninstall.cmake
# Removes the files that `cmake --install` listed in the manifest; if DESTDIR is set, below DESTDIR. Also removes
# PlacedPar's own folders that are empty then.
if(NOT EXISTS ${MANIFEST})
    message(FATAL_ERROR "The file ${MANIFEST} does not exist: this build was not installed, or only some of its components were")
endif()
file(STRINGS ${MANIFEST} installed)
foreach(file IN LISTS installed)
    set(file "$ENV{DESTDIR}${file}")
    message(STATUS "Removing ${file}")
    file(REMOVE "${file}")
    cmake_path(GET file PARENT_PATH folder)
    while(folder MATCHES "/[Pp]laced[Pp]ar")
        execute_process(COMMAND rmdir -- "${folder}" RESULT_VARIABLE kept OUTPUT_QUIET ERROR_QUIET)
        if(NOT kept EQUAL 0) # it is not empty
            break()
        endif()
        cmake_path(GET folder PARENT_PATH folder)
    endwhile()
endforeach()
