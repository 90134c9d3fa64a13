# A part of `cmake --install`: writes the unit for systemd, which contains the path of the installed program.
cmake_path(APPEND CMAKE_INSTALL_PREFIX "${bindir}" placedpar OUTPUT_VARIABLE installed_program)
string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" installed_program "${installed_program}") # systemd's escapes in quotes
string(REPLACE "%" "%%" installed_program "${installed_program}")
string(SHA1 place "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}") # for installations with different prefixes at the same time
set(unit ${build}/units/${place}/placedpar-monitor.service)
configure_file(${CMAKE_CURRENT_LIST_DIR}/../monitor/systemd/placedpar-monitor.service.in ${unit} @ONLY)
file(INSTALL ${unit} DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/systemd/system")
