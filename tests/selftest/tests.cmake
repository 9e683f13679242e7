# SPDX-License-Identifier: MIT
strahl_test(selftest/test_probe.cpp LABEL device LIBS strahl_robust_kernels strahl_selftest)
