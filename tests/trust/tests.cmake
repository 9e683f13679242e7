# SPDX-License-Identifier: MIT
strahl_test(trust/test_canary.cpp LABEL device)
