# Installs the program with its documents and examples, the rooms as an exported package, and their public headers.
# Package.cmake makes a Debian package of each component: program, dev, and, if MPI is installed, mpi.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY PLACEDPAR_ROOMS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/PlacedPar)
set(doc ${CMAKE_INSTALL_DATAROOTDIR}/doc)
set(printed ${PROJECT_BINARY_DIR}/app) # folder of the files that the program prints: see app/CMakeLists.txt
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)

# The files that are installed and do not exist before a build. If one of them is missing, the installation ends with an
# error before it copies any file.
set(archives ${rooms})
list(TRANSFORM archives PREPEND placedpar_)
list(APPEND archives placedpar_program)
set(built_targets placedpar ${archives})
if(TARGET placedpar_mpi)
    list(APPEND built_targets placedpar_mpi)
endif()
add_custom_target(installed)
add_dependencies(installed ${built_targets} placedpar_headers)
foreach(target ${built_targets})
    list(APPEND built $<TARGET_FILE:${target}>)
endforeach()
list(APPEND built ${printed}/placedpar.1 ${printed}/completion.bash ${printed}/completion.zsh
     ${PROJECT_BINARY_DIR}/public_headers.stamp)
install(CODE "set(built \"${built}\")\nset(build \"${PROJECT_BINARY_DIR}\")\n
    include(\"${PROJECT_SOURCE_DIR}/cmake/refuse_unbuilt.cmake\")" ALL_COMPONENTS)

install(TARGETS placedpar RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${printed}/placedpar.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${printed}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME placedpar)
install(FILES ${printed}/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _placedpar)
install(CODE "set(bindir \"${CMAKE_INSTALL_BINDIR}\")\nset(build \"${PROJECT_BINARY_DIR}\")\n
    include(\"${PROJECT_SOURCE_DIR}/cmake/install_unit.cmake\")" COMPONENT program)

# The program reads the examples in share/placedpar. A link makes them visible beside the documents, as in the sources.
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/placedpar)
install(DIRECTORY docs DESTINATION ${doc}/placedpar)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${doc}/placedpar)
file(RELATIVE_PATH examples_from_doc ${CMAKE_INSTALL_FULL_DATAROOTDIR}/doc/placedpar ${CMAKE_INSTALL_FULL_DATADIR}/placedpar/examples)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/link)
file(CREATE_LINK ${examples_from_doc} ${PROJECT_BINARY_DIR}/link/examples SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/link/examples DESTINATION ${doc}/placedpar)

install(TARGETS ${archives} EXPORT PlacedParTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(DIRECTORY ${PROJECT_BINARY_DIR}/include/placedpar DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(EXPORT PlacedParTargets NAMESPACE PlacedPar:: DESTINATION ${package_folder} COMPONENT dev)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/PlacedParConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/PlacedParConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PlacedParConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PlacedParConfig.cmake ${PROJECT_BINARY_DIR}/PlacedParConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindRandom123.cmake
        DESTINATION ${package_folder} COMPONENT dev)

if(TARGET placedpar_mpi)
    install(TARGETS placedpar_mpi LIBRARY DESTINATION lib/placedpar COMPONENT mpi) # ranks/ranks.cpp loads it from there
endif()

# Installs the Python package, if its module is built, in the folder below the prefix that python3 searches: in Debian,
# dist-packages.
if(TARGET placedpar_python)
    install(CODE "if(EXISTS \"$<TARGET_FILE:placedpar_python>\")
        set(site lib/python${python_version}/dist-packages)
        if(CMAKE_INSTALL_PREFIX STREQUAL /usr)
            set(site lib/python3/dist-packages)
        endif()
        file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/\${site}/placedpar\" TYPE FILE
             FILES ${python_package} \"$<TARGET_FILE:placedpar_python>\")
    endif()" COMPONENT python)
endif()

# Collects the licences of the libraries that are linked or embedded. packages.txt lists their Debian packages, which
# contain the licences.
file(STRINGS ${PROJECT_SOURCE_DIR}/packages.txt libraries REGEX "^(lib|node-|zlib)")
list(TRANSFORM libraries REPLACE " .*" "")
list(FILTER libraries EXCLUDE REGEX "clang|mpfr") # only tests use these
file(READ ${PROJECT_SOURCE_DIR}/LICENSE copyright)
foreach(library ${libraries})
    set(licence "It is not known here: see the library.\n")
    if(EXISTS /usr/share/doc/${library}/copyright)
        file(READ /usr/share/doc/${library}/copyright licence)
    endif()
    string(SHA1 hash "${licence}")
    if(NOT hash IN_LIST hashes) # all libraries of Boost have the same licence
        list(APPEND hashes ${hash})
        string(APPEND copyright "\n\n======== ${library} is linked or embedded; its licence: ========\n\n${licence}")
    endif()
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${copyright}")
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${doc}/placedpar)

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
                  -P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake VERBATIM)
