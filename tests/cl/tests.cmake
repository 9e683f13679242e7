# SPDX-License-Identifier: MIT
strahl_test(cl/test_angle.cpp LABEL unit LIBS strahl_oracle SOURCES cl/angle_f32.cpp cl/angle_f64.cpp)
target_include_directories(cl_test_angle PRIVATE ${PROJECT_SOURCE_DIR}/cl)
