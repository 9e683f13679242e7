# SPDX-License-Identifier: MIT
strahl_test(bench/test_driver.cpp LABEL device LIBS strahl_bench nlohmann_json::nlohmann_json)
