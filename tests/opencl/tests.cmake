# SPDX-License-Identifier: MIT
strahl_test(opencl/test_cl_code.cpp LABEL unit)
strahl_test(opencl/test_selector.cpp LABEL unit)
strahl_test(opencl/test_device.cpp LABEL device)
strahl_test(opencl/test_program.cpp LABEL device)
strahl_test(opencl/test_program_cache.cpp LABEL unit)
strahl_test(opencl/test_functions.cpp LABEL device LIBS strahl_host_kernels)
strahl_test(opencl/test_splats.cpp LABEL device LIBS strahl_host_kernels)
strahl_test(opencl/test_process_memory.cpp LABEL unit)
