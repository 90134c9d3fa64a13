# The first part of `cmake --install`: ends with an error if one of the files in `built` does not exist. `build` is the
# build folder.
set(missing "")
foreach(file IN LISTS built)
    if(NOT EXISTS "${file}")
        string(APPEND missing "\n  ${file}")
    endif()
endforeach()
if(missing)
    message(FATAL_ERROR "Nothing was installed, because these files have not been built:${missing}\n"
            "Build them first:\n  cmake --build \"${build}\" --target installed")
endif()
