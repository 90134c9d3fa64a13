# Builds the page of `placedpar serve` as files, which work from any web server, since the programs run in the browser:
# cmake --build --preset release --target webassembly writes them to build/release/webassembly/page.
find_program(PLACEDPAR_EMCMAKE emcmake)
mark_as_advanced(PLACEDPAR_EMCMAKE)
set(webassembly_folder ${PROJECT_BINARY_DIR}/webassembly)
if(PLACEDPAR_EMCMAKE)
    find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
    set(with_debian_modules ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs) # Emscripten's own modules
    add_custom_target(webassembly
        COMMAND ${with_debian_modules} ${PLACEDPAR_EMCMAKE} ${CMAKE_COMMAND} -S ${PROJECT_SOURCE_DIR}/tools/webassembly
                -B ${webassembly_folder} -G ${CMAKE_GENERATOR} --log-level=ERROR
        COMMAND ${with_debian_modules} ${CMAKE_COMMAND} --build ${webassembly_folder}
        COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/webassembly/static_page.py $<TARGET_FILE:placedpar>
                ${webassembly_folder} ${webassembly_folder}/page
        DEPENDS placedpar USES_TERMINAL VERBATIM)
else()
    add_custom_target(webassembly
        COMMAND ${CMAKE_COMMAND} -E echo
                "WebAssembly needs a compiler: run tools/install_packages --webassembly, then cmake again."
        COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
