# `cpack -G DEB` makes Debian packages from the installed files: placedpar, libplacedpar-dev and placedpar-mpi.
set(CPACK_PACKAGE_NAME placedpar)
set(CPACK_PACKAGE_CONTACT "The PlacedPar maintainers <placedpar@localhost>")
set(CPACK_SET_DESTDIR ON) # so that install_unit.cmake can write the prefix into the unit for systemd
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "simulator of transputer networks and CSP processes
 It runs netlists of processes on simulated machines and reports times and deadlocks.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME placedpar)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gnuplot-nox, libplacedpar-dev, placedpar-mpi")

# A program that links the rooms needs the libraries with which the rooms are built, except MPI and the header-only
# libraries that no installed header includes (CLI11, Eigen, toml++).
set(needed ${libraries})
list(FILTER needed INCLUDE REGEX "-dev$")
list(FILTER needed EXCLUDE REGEX "cli11|eigen3|mpi|toml")
list(JOIN needed ", " needed)
set(CPACK_DEBIAN_DEV_DESCRIPTION "simulator of transputer networks, as libraries
 Headers, static libraries and a CMake package for programs with processes of their own.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libplacedpar-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${needed}")
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${doc}/libplacedpar-dev COMPONENT dev)

if(TARGET placedpar_mpi)
    list(APPEND CPACK_COMPONENTS_ALL mpi)
    set(CPACK_DEBIAN_MPI_DESCRIPTION "simulator of transputer networks, runs by MPI
 The module with which placedpar sweep and native runs spread over the ranks of mpirun.")
    set(CPACK_DEBIAN_MPI_PACKAGE_NAME placedpar-mpi)
    set(CPACK_DEBIAN_MPI_PACKAGE_SECTION science)
    set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "placedpar (= ${PROJECT_VERSION}), openmpi-bin")
    install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${doc}/placedpar-mpi COMPONENT mpi)
endif()
include(CPack)
