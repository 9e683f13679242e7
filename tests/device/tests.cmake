# SPDX-License-Identifier: MIT
strahl_test(device/test_cl_code.cpp LABEL unit)
strahl_test(device/test_selector.cpp LABEL unit)
strahl_test(device/test_kernel_source.cpp LABEL unit)
strahl_test(device/test_device.cpp LABEL device)
strahl_test(device/test_program.cpp LABEL device)
