# SPDX-License-Identifier: MIT
strahl_test(kinds/test_filter_taps.cpp LABEL unit)
strahl_test(kinds/test_principled_lobes.cpp LABEL unit)
strahl_test(kinds/test_readers.cpp LABEL unit)
strahl_test(kinds/test_rough_boundary.cpp LABEL unit)
