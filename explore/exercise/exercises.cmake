# Embeds the exercises of the course in occam: the programs to start from, and what solutions print. Sets
# exercise_sources.
set(course ${PROJECT_SOURCE_DIR}/docs/occam-course)
set(texts "")
set(text_files "")
set(DECLARATIONS "")
set(EXERCISES "")
foreach(page RANGE 1 10)
    foreach(place RANGE 1 3)
        string(APPEND DECLARATIONS "std::string start_${page}_${place}();\nstd::string expected_${page}_${place}();\n")
        string(APPEND EXERCISES "\n        {\"${page}.${place}\", exercise_texts::start_${page}_${place}(), exercise_texts::expected_${page}_${place}()},")
        list(APPEND text_files ${course}/exercises/${page}-${place}.occ ${course}/answers/${page}-${place}.expected)
        list(APPEND texts start_${page}_${place} ${course}/exercises/${page}-${place}.occ
                          expected_${page}_${place} ${course}/answers/${page}-${place}.expected)
    endforeach()
endforeach()
configure_file(exercise/exercises.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/exercises.cpp @ONLY)
set(embed ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/exercise_texts.cpp
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/exercise_texts.cpp -DHEADER=explore/exercise/course.hpp
            -DNAMESPACE=placedpar::exercise_texts -P ${embed} ${texts}
    DEPENDS ${embed} ${text_files}
    COMMENT "Embedding the exercises of the course in occam" VERBATIM)
set(exercise_sources ${CMAKE_CURRENT_BINARY_DIR}/exercises.cpp ${CMAKE_CURRENT_BINARY_DIR}/exercise_texts.cpp)
