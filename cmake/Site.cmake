# Builds the documents as a web site: run cmake --build --preset release --target site, then open
# build/release/site/html/index.html.
find_program(PLACEDPAR_SPHINX sphinx-build)
mark_as_advanced(PLACEDPAR_SPHINX)
set(site_folder ${PROJECT_BINARY_DIR}/site)
if(PLACEDPAR_SPHINX)
    find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
    set(python_interfaces)
    if(TARGET python_module)
        set(python_interfaces --python ${PROJECT_BINARY_DIR}/python)
    endif()
    add_custom_target(site
        COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/site/build.py $<TARGET_FILE:placedpar>
                ${PROJECT_BINARY_DIR}/include/placedpar ${site_folder} ${python_interfaces}
        DEPENDS placedpar placedpar_headers USES_TERMINAL VERBATIM)
else()
    add_custom_target(site
        COMMAND ${CMAKE_COMMAND} -E echo "The site needs packages: run tools/install_packages --site, then cmake again."
        COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
