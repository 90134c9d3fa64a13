# A part of `cmake --install`, before all others: refuses where a file of `built` is missing in the folder `build`.
set(missing "")
foreach(file IN LISTS built)
    if(NOT EXISTS "${file}")
        string(APPEND missing "\n  ${file}")
    endif()
endforeach()
if(missing)
    message(FATAL_ERROR "Nothing is installed, for these are not built:${missing}\n"
            "Build all that is installed first:\n  cmake --build \"${build}\" --target installed")
endif()
