# SPDX-License-Identifier: MIT
strahl_test(packing/test_memory_estimate.cpp LABEL unit)
strahl_test(packing/test_pack.cpp LABEL unit)
strahl_test(packing/test_pack_shapes.cpp LABEL unit)
strahl_test(packing/test_pack_camera.cpp LABEL unit)
strahl_test(packing/test_choice_table.cpp LABEL unit)
strahl_test(packing/test_majorants.cpp LABEL unit)
strahl_test(packing/test_filter_quantiles.cpp LABEL unit)
