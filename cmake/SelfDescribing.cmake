# Lists of what describes itself, an entry a file, so that adding a file is enough.

# placedpar_list_entries(list.cpp.in TYPE file.cpp ...): each file defines `extern const TYPE name_TYPE`, in small
# letters, where name is the file's. Writes list.cpp to the build folder from list.cpp.in, in which @DECLARATIONS@
# stands for the declarations of them all, and @NAMES@ for their names; where the variable LIST is set, to LIST.cpp. The linker misses what a file does not define.
# Rejected: registration by constructors of statics, whose order is nobody's, and which linkers drop from libraries.
function(placedpar_list_entries template type)
    string(TOLOWER ${type} suffix)
    foreach(file ${ARGN})
        cmake_path(GET file STEM name)
        string(APPEND DECLARATIONS "extern const ${type} ${name}_${suffix};\n")
        list(APPEND names ${name}_${suffix})
    endforeach()
    list(JOIN names ", " NAMES)
    cmake_path(GET template STEM LAST_ONLY list)
    if(LIST)
        set(list ${LIST}.cpp)
    endif()
    configure_file(${template} ${CMAKE_CURRENT_BINARY_DIR}/${list} @ONLY)
endfunction()
