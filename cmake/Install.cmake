# Installs the program with its documents and examples, the rooms as an exported package, and their public headers.
# Three components, of which Package.cmake makes Debian packages: program, dev, and mpi where MPI is there.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY PLACEDPAR_ROOMS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/PlacedPar)
set(doc ${CMAKE_INSTALL_DATAROOTDIR}/doc)
set(printed ${PROJECT_BINARY_DIR}/app) # by the program: app/CMakeLists.txt
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)

# All that is installed and not there before a build. What is missing is said before anything is copied.
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

# The program reads the examples; who reads the documents finds them beside these, as in the sources.
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
    install(TARGETS placedpar_mpi LIBRARY DESTINATION lib/placedpar COMPONENT mpi) # ranks/ranks.cpp looks there
endif()

# The package for Python, if its module is built: where python3 looks below the prefix, which is dist-packages in Debian.
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

# What is linked or embedded, as Debian names it in packages.txt, with the licence that Debian's package has.
file(STRINGS ${PROJECT_SOURCE_DIR}/packages.txt libraries REGEX "^(lib|node-|zlib)")
list(TRANSFORM libraries REPLACE " .*" "")
list(FILTER libraries EXCLUDE REGEX "clang|mpfr") # the tests' own
file(READ ${PROJECT_SOURCE_DIR}/LICENSE copyright)
foreach(library ${libraries})
    set(licence "It is not known here: see the library.\n")
    if(EXISTS /usr/share/doc/${library}/copyright)
        file(READ /usr/share/doc/${library}/copyright licence)
    endif()
    string(SHA1 hash "${licence}")
    if(NOT hash IN_LIST hashes) # those of Boost's libraries are one
        list(APPEND hashes ${hash})
        string(APPEND copyright "\n\n======== ${library} is linked or embedded; its licence: ========\n\n${licence}")
    endif()
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${copyright}")
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${doc}/placedpar)

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
                  -P ${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake VERBATIM)
