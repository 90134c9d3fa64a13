# The public headers of the rooms, as programs outside of the tree include them: under placedpar/, so that they clash
# with nobody's runtime/. Each room names its doors (placedpar_room's DOORS), which a program may include by name; all other
# headers that these include lie in placedpar/detail/, and are no promise. They are staged in the build tree, where
# "room/header.hpp" is rewritten to "placedpar/room/header.hpp" or "placedpar/detail/room/header.hpp", again after each
# edit. The staged folder is what is installed, and what a project includes that uses PlacedPar by add_subdirectory.
# Rejected: installing every header, which makes all of the house a promise.

get_property(doors GLOBAL PROPERTY PLACEDPAR_DOORS)
get_property(rooms GLOBAL PROPERTY PLACEDPAR_ROOMS)
set(room_headers)
foreach(room ${rooms})
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.hpp)
    list(APPEND room_headers ${headers})
endforeach()
list(APPEND room_headers ${PROJECT_SOURCE_DIR}/app/program.hpp)
set(door_list ${PROJECT_BINARY_DIR}/public_headers.cmake)
file(CONFIGURE OUTPUT ${door_list} CONTENT "set(doors @doors@)\n" @ONLY) # written only when they are others

set(script ${CMAKE_CURRENT_LIST_DIR}/stage_headers.cmake)
set(staged ${PROJECT_BINARY_DIR}/public_headers.stamp)
add_custom_command(
    OUTPUT ${staged}
    COMMAND ${CMAKE_COMMAND} -DTREE=${PROJECT_SOURCE_DIR} -DDOORS=${door_list}
            -DSTAGE=${PROJECT_BINARY_DIR}/include/placedpar -P ${script}
    COMMAND ${CMAKE_COMMAND} -E touch ${staged}
    DEPENDS ${room_headers} ${door_list} ${script}
    COMMENT "Staging the public headers" VERBATIM)
add_custom_target(placedpar_headers DEPENDS ${staged})
foreach(room ${rooms})
    add_dependencies(placedpar_${room} placedpar_headers)
endforeach()
