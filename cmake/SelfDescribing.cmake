# Makes lists of entries that each have a source file of their own, such as commands and experiments. A new file needs
# no change elsewhere.

# placedpar_list_entries(list.cpp.in TYPE file.cpp ...): writes list.cpp (LIST.cpp, if the variable LIST is set) to the
# build folder. In list.cpp.in, it replaces @DECLARATIONS@ by the declarations of all entries, and @NAMES@ by their
# names. Each file NAME.cpp must define an entry `extern const TYPE NAME_type`, whose name ends in the type's name in
# small letters. The linker reports an entry that is missing.
# Rejected: registration by constructors of static objects. Their order is undefined, and linkers drop them from
# libraries.
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
