# A part of `cmake --install`: writes the unit for systemd, which names the program where it is being installed.
cmake_path(APPEND CMAKE_INSTALL_PREFIX "${bindir}" placedpar OUTPUT_VARIABLE installed_program)
string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" installed_program "${installed_program}") # as systemd reads what is quoted
string(REPLACE "%" "%%" installed_program "${installed_program}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/../monitor/systemd/placedpar-monitor.service.in
               ${build}/placedpar-monitor.service @ONLY)
file(INSTALL ${build}/placedpar-monitor.service DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/systemd/system")
