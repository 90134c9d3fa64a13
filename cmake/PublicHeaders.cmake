# Copies the public headers to a folder placedpar/ in the build tree, so that names of rooms, such as runtime/, cannot
# clash with folders of other projects. Each room lists its public headers as DOORS of placedpar_room(): programs may
# include them by name. All other headers that the doors include are copied to placedpar/detail/, and may change at any
# time. In the copies, "room/header.hpp" is replaced by "placedpar/room/header.hpp" or
# "placedpar/detail/room/header.hpp". The headers are copied again after each change. This folder is installed. Projects
# that use PlacedPar by add_subdirectory include it, too.
# Rejected: installing every header. Then no header could be changed without breaking programs.

get_property(doors GLOBAL PROPERTY PLACEDPAR_DOORS)
get_property(rooms GLOBAL PROPERTY PLACEDPAR_ROOMS)
set(room_headers)
foreach(room ${rooms})
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.hpp)
    list(APPEND room_headers ${headers})
endforeach()
list(APPEND room_headers ${PROJECT_SOURCE_DIR}/app/program.hpp)
set(door_list ${PROJECT_BINARY_DIR}/public_headers.cmake)
file(CONFIGURE OUTPUT ${door_list} CONTENT "set(doors @doors@)\n" @ONLY) # written only if the list has changed

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
