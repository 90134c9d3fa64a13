# A part of `cmake --install`: writes the unit for systemd, which names the program where it is being installed.
cmake_path(APPEND CMAKE_INSTALL_PREFIX "${bindir}" placedpar OUTPUT_VARIABLE installed_program)
string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" installed_program "${installed_program}") # as systemd reads what is quoted
string(REPLACE "%" "%%" installed_program "${installed_program}")
string(SHA1 place "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}") # two installs at once may have two prefixes
set(unit ${build}/units/${place}/placedpar-monitor.service)
configure_file(${CMAKE_CURRENT_LIST_DIR}/../monitor/systemd/placedpar-monitor.service.in ${unit} @ONLY)
file(INSTALL ${unit} DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/systemd/system")
