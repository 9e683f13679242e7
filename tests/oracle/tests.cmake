# SPDX-License-Identifier: MIT
foreach(name exact quadrics planar aabb laws generators)
  strahl_test(oracle/test_${name}.cpp LABEL unit LIBS strahl_oracle)
endforeach()
