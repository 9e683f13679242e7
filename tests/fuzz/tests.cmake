# SPDX-License-Identifier: MIT
# tests/fuzz/run builds this with the preset `fuzz`.
if(STRAHL_FUZZ)
  add_executable(fuzz_readers fuzz/fuzz_readers.cpp)
  target_link_libraries(fuzz_readers PRIVATE strahl ZLIB::ZLIB)
  target_link_options(fuzz_readers PRIVATE -fsanitize=fuzzer)
else()
  # Builds the library anew with clang: minutes.
  add_test(NAME fuzz_readers_run COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 20)
  set_tests_properties(fuzz_readers_run PROPERTIES LABELS slow SKIP_RETURN_CODE 77 TIMEOUT 3600)
endif()
