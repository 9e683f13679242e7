# SPDX-License-Identifier: MIT
strahl_test(program/test_calls_for_tree.cpp LABEL unit)
strahl_test(program/test_path_lanes.cpp LABEL unit)
strahl_test(program/test_kernel_source.cpp LABEL unit)
strahl_test(program/test_features.cpp LABEL unit)
strahl_test(program/test_disabled.cpp LABEL unit)
strahl_test(program/test_texture_lod.cpp LABEL unit)
strahl_test(program/test_program_text.cpp LABEL unit)
