# SPDX-License-Identifier: MIT
strahl_test(kinds/test_readers.cpp LABEL unit)
