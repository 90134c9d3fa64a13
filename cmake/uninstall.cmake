# cmake -DMANIFEST=FILE -P uninstall.cmake
# Removes what `cmake --install` has written to the manifest, below DESTDIR if that is set, and the folders that are ours
# alone and empty then.
if(NOT EXISTS ${MANIFEST})
    message(FATAL_ERROR "There is no ${MANIFEST}: nothing was installed from this build as a whole")
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
