# SPDX-License-Identifier: MIT
foreach(name ignis_point sionna embree_masks)
  strahl_test(acceptance/test_${name}.cpp LABEL render)
endforeach()
