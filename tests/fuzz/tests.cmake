# SPDX-License-Identifier: MIT
# The readers under libFuzzer, which tests/fuzz/run builds with the preset `fuzz`.
if(STRAHL_FUZZ)
  # The readers and what they need, not all of libstrahl: sanitizers and coverage make the compiler slow.
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/scene/*.cpp ${PROJECT_SOURCE_DIR}/src/image/*.cpp
       ${PROJECT_SOURCE_DIR}/src/kinds/*.cpp ${PROJECT_SOURCE_DIR}/src/settings/*.cpp)
  foreach(name errors.cpp did_you_mean.cpp checkpoint/checkpoint_file.cpp opencl/cl_code.cpp render/film.cpp
               render/film_rows.cpp)
    list(APPEND sources ${PROJECT_SOURCE_DIR}/src/${name})
  endforeach()
  # In a few large files, because headers take most of the compiler's time; these two by themselves as in libstrahl.
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/image/texels_stb.cpp ${PROJECT_SOURCE_DIR}/src/opencl/cl_code.cpp
                              PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  add_executable(fuzz_readers fuzz/fuzz_readers.cpp ${sources})
  set_target_properties(fuzz_readers PROPERTIES UNITY_BUILD_BATCH_SIZE 40)
  target_include_directories(fuzz_readers PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(
    fuzz_readers
    PRIVATE OpenCL::OpenCL pugixml::pugixml fmt::fmt nlohmann_json::nlohmann_json OpenEXR::OpenEXR PNG::PNG ZLIB::ZLIB
            PkgConfig::turbojpeg Threads::Threads ${CMAKE_DL_LIBS})
  target_link_options(fuzz_readers PRIVATE -fsanitize=fuzzer)
else()
  # That their program builds and reads what the fuzzer begins with; 20 minutes of a reader are of the label slow.
  add_executable(fuzz_replay fuzz/fuzz_readers.cpp fuzz/replay.cpp)
  target_link_libraries(fuzz_replay PRIVATE strahl ZLIB::ZLIB)
  target_compile_options(fuzz_replay PRIVATE ${unoptimised})
  add_test(NAME fuzz_replay COMMAND ${CMAKE_CURRENT_LIST_DIR}/run --replay $<TARGET_FILE:fuzz_replay>)
  set_tests_properties(fuzz_replay PROPERTIES LABELS fuzz TIMEOUT 300)
  add_test(NAME fuzz_all_for_20_minutes COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 1200)
  set_tests_properties(fuzz_all_for_20_minutes PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 30000)
endif()
