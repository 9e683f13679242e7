# SPDX-License-Identifier: MIT
set(STRAHL_INSTALL_TEST ${PROJECT_BINARY_DIR}/tests/library)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
add_test(NAME library_install_example
         COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/library/install_example ${PROJECT_BINARY_DIR} ${STRAHL_INSTALL_TEST}
                 ${CMAKE_CXX_COMPILER} -G ${CMAKE_GENERATOR}
                 "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
set_tests_properties(library_install_example PROPERTIES LABELS render TIMEOUT 300 FIXTURES_SETUP installed_example)

strahl_test(library/test_example.cpp LABEL render)
target_compile_definitions(library_tests PRIVATE STRAHL_INSTALL_TEST="${STRAHL_INSTALL_TEST}")
set_tests_properties(library_test_example PROPERTIES FIXTURES_REQUIRED installed_example)

strahl_test(library/test_build.cpp LABEL unit)
