# SPDX-License-Identifier: MIT
strahl_test(opencl/test_cl_code.cpp LABEL unit)
strahl_test(opencl/test_selector.cpp LABEL unit)
strahl_test(opencl/test_device.cpp LABEL device)
add_test(NAME opencl_test_specialization COMMAND opencl_tests --warn NoTests "PoCL launches what*")
set_tests_properties(opencl_test_specialization PROPERTIES LABELS device SKIP_RETURN_CODE 77 TIMEOUT 60
                                                           ENVIRONMENT POCL_WORK_GROUP_SPECIALIZATION=1)
strahl_test(opencl/test_program.cpp LABEL device)
strahl_test(opencl/test_program_cache.cpp LABEL unit)
strahl_test(opencl/test_functions.cpp LABEL device LIBS strahl_host_kernels)
strahl_test(opencl/test_splats.cpp LABEL device LIBS strahl_host_kernels)
strahl_test(opencl/test_process_memory.cpp LABEL unit)
add_test(NAME opencl_test_vendors COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/opencl/test_vendors)
set_tests_properties(opencl_test_vendors PROPERTIES LABELS unit TIMEOUT 60)
