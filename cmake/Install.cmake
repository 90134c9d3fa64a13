# Installs the program, the rooms as an exported package, their public headers, and the examples.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY PLACEDPAR_ROOMS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/PlacedPar)

foreach(room ${rooms})
    install(TARGETS placedpar_${room} EXPORT PlacedParTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()
install(TARGETS placedpar_program EXPORT PlacedParTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/include/placedpar DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS placedpar RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET placedpar_mpi)
    install(TARGETS placedpar_mpi LIBRARY DESTINATION lib/placedpar) # workbench/study/ranks.cpp looks there
endif()
set(printed ${PROJECT_BINARY_DIR}/app) # by the program: app/CMakeLists.txt
install(FILES ${printed}/placedpar.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${printed}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME placedpar)
install(FILES ${printed}/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _placedpar)
install(FILES ${PROJECT_SOURCE_DIR}/monitor/systemd/placedpar-monitor.service DESTINATION lib/systemd/system)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/placedpar OPTIONAL)

install(EXPORT PlacedParTargets NAMESPACE PlacedPar:: DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/PlacedParConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/PlacedParConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PlacedParConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PlacedParConfig.cmake ${PROJECT_BINARY_DIR}/PlacedParConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindRandom123.cmake
        DESTINATION ${package_folder})
