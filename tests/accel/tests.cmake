# SPDX-License-Identifier: MIT
strahl_test(accel/test_trees_equal_lists.cpp LABEL device LIBS strahl_host_kernels strahl_selftest TIMEOUT 600)
add_test(NAME accel_test_trees_equal_lists_all COMMAND accel_tests "-#" "[#test_trees_equal_lists]")
set_tests_properties(accel_test_trees_equal_lists_all PROPERTIES LABELS slow TIMEOUT 1800 ENVIRONMENT STRAHL_RAYS=10000000)
strahl_test(accel/test_instances.cpp LABEL device LIBS strahl_host_kernels strahl_selftest TIMEOUT 600)
strahl_test(accel/test_wide_tree.cpp LABEL unit)
strahl_test(accel/test_on_threads.cpp LABEL unit)
strahl_test(accel/test_packets.cpp LABEL device LIBS strahl_host_kernels strahl_selftest TIMEOUT 300)

foreach(name trees_equal_lists instances packets)
  add_test(NAME accel_test_${name}_own_programs COMMAND accel_tests "-#" "[#test_${name}]")
  set_tests_properties(accel_test_${name}_own_programs PROPERTIES LABELS slow TIMEOUT 3600 ENVIRONMENT
                                                                                    STRAHL_OWN_PROGRAMS=1)
endforeach()

# Names of their own mean something else in each.
set_source_files_properties(accel/test_instances.cpp accel/test_packets.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
