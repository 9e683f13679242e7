# SPDX-License-Identifier: MIT
strahl_test(kinds/test_shape_kinds.cpp LABEL unit)
